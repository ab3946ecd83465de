#include <boost/crc.hpp>

#include <rolling_contact/mesh/file_mesh.h>

namespace RollingContact
{
  std::string FileMesh::fingerprint() const
  {
    boost::crc_32_type crc;
    const auto         process = [&](const auto &entries) {
      crc.process_bytes(entries.data(),
                        entries.size() * sizeof(*entries.data()));
    };
    process(vertices);
    process(cells);
    process(contact_faces);
    process(hub_faces);
    return std::to_string(vertices.size()) + " nodes, " +
           std::to_string(cells.size()) + " cells, CRC-32 " +
           std::to_string(crc.checksum());
  }
} // namespace RollingContact
