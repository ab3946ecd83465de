#include "input_parts.h"

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/program/command_line.h>

#include <algorithm>

using namespace RollingContact;

/** One word a line. */
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data,
                                      const std::size_t   size)
{
  std::string text(reinterpret_cast<const char *>(data), size);
  std::replace(text.begin(), text.end(), '\n', '\0');
  std::vector<const char *> words{"rolling-contact"};
  for (std::size_t i = 0; i < text.size(); i = text.find('\0', i) + 1)
    {
      words.push_back(text.c_str() + i);
      if (text.find('\0', i) == std::string::npos)
        break;
    }
  try
    {
      CommandLine(words.size(), words.data());
    }
  catch (const InputError &)
    {}
  return 0;
}
