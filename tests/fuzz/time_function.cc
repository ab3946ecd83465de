#include "input_parts.h"

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/scene/time_function.h>

using namespace RollingContact;

/** Parts: the text of an entry of section Time, table.csv. */
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data,
                                      const std::size_t   size)
{
  const auto parts = input_parts(data, size);
  write_part("table.csv", parts, 1);
  try
    {
      const TimeFunction history("Time/Spin", parts[0], "");
      for (const double time : {0., 1e-3, 1., 1e3})
        history.value(time);
      if (history.is_table())
        history.table_fingerprint();
    }
  catch (const InputError &)
    {}
  return 0;
}
