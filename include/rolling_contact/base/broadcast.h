#ifndef rolling_contact_base_broadcast_h
#define rolling_contact_base_broadcast_h

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/device/back_inserter.hpp>
#include <boost/iostreams/stream_buffer.hpp>
#include <boost/serialization/array.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <rolling_contact/base/ranks.h>

#include <string>

namespace RollingContact
{
  namespace Ranks
  {
    /**
     * Give all ranks the @p object of rank @p from, whose own object is read
     * and those of the other ranks are replaced. @p Object is a structure with
     * a serialize() for Boost.Serialization, or a standard container of such.
     * Collective; does nothing on one rank.
     */
    template <typename Object>
    void broadcast(Object &object, const unsigned int from = 0)
    {
      namespace io = boost::iostreams;
      if (count() == 1)
        return;
      std::string bytes;
      if (rank() == from)
        {
          io::stream_buffer<io::back_insert_device<std::string>> buffer(bytes);
          boost::archive::binary_oarchive(buffer, boost::archive::no_header)
            << object;
        }
      broadcast(bytes, from);
      if (rank() != from)
        {
          io::stream_buffer<io::array_source> buffer(bytes.data(),
                                                     bytes.size());
          boost::archive::binary_iarchive(buffer, boost::archive::no_header) >>
            object;
        }
    }
  } // namespace Ranks
} // namespace RollingContact

#endif
