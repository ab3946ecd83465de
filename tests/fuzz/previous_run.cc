#include "input_parts.h"

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/input/prm_entries.h>
#include <rolling_contact/run/previous_run.h>

#include <stdexcept>

using namespace RollingContact;

/** Parts: run.json, used.prm of a former run, used.prm of this one. */
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data,
                                      const std::size_t   size)
{
  const auto parts = input_parts(data, size);
  write_part(record_name, parts, 0);
  for (const std::string &name : read_previous_run("").files)
    if (!is_plain_name(name))
      throw std::logic_error("A file outside the folder: " + name);
  try
    {
      refuse_changed_entries(prm_entries(parts.size() > 1 ? parts[1] : ""),
                             prm_entries(parts.size() > 2 ? parts[2] : ""),
                             {"Output/", "Time/End time"});
    }
  catch (const InputError &)
    {}
  return 0;
}
