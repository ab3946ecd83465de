#include <deal.II/base/multithread_info.h>

#include "input_parts.h"

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/program/scene_reader.h>

#include <sstream>
#include <stdexcept>

using namespace RollingContact;

namespace
{
  /** What `--validate` does, with settings of the command line. */
  std::string validate(const std::vector<std::string> &settings)
  {
    std::vector<const char *> words{"rolling-contact", "scene.prm"};
    for (const std::string &setting : settings)
      {
        words.push_back("--set");
        words.push_back(setting.c_str());
      }
    return read_scene(CommandLine(words.size(), words.data())).used;
  }
} // namespace

extern "C" int LLVMFuzzerInitialize(int *, char ***)
{
  dealii::MultithreadInfo::set_thread_limit(1);
  return 0;
}

/** Parts: scene.prm, a file it may include, a table it may name, settings by
 * line. A valid scene written back must be valid and the same. */
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data,
                                      const std::size_t   size)
{
  const auto parts = input_parts(data, size);
  write_part("scene.prm", parts, 0);
  write_part("part.prm", parts, 1);
  write_part("table.csv", parts, 2);
  std::vector<std::string> settings;
  std::istringstream       lines(parts.size() > 3 ? parts[3] : "");
  for (std::string line; std::getline(lines, line);)
    settings.push_back(line);
  std::string used;
  try
    {
      used = validate(settings);
    }
  catch (const InputError &)
    {
      return 0;
    }
  write_part("scene.prm", {used}, 0);
  if (validate({}) != used)
    throw std::logic_error("used.prm is another scene:\n" + used);
  return 0;
}
