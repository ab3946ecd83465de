#ifndef rolling_contact_tests_input_parts_h
#define rolling_contact_tests_input_parts_h

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace RollingContact
{
  /** The parts of a fuzzer's input: they are separated by lines of "%%". */
  inline std::vector<std::string> input_parts(const std::uint8_t *data,
                                              const std::size_t   size)
  {
    const std::string text(reinterpret_cast<const char *>(data), size),
      mark = "\n%%\n";
    std::vector<std::string> parts;
    std::size_t              begin = 0;
    for (std::size_t end; (end = text.find(mark, begin)) != std::string::npos;
         begin = end + mark.size())
      parts.push_back(text.substr(begin, end - begin));
    parts.push_back(text.substr(begin));
    return parts;
  }

  /** Writes a part to a file of the current folder. */
  inline void write_part(const std::string              &file,
                         const std::vector<std::string> &parts,
                         const std::size_t               i)
  {
    std::ofstream(file, std::ios::binary) << (i < parts.size() ? parts[i] : "");
  }

  /** Ends the program with what a reader did wrong. */
  inline void must(const bool condition, const std::string &what)
  {
    if (!condition)
      throw std::logic_error(what);
  }

  /** That the message of an error names the file or the entry it is of. */
  inline void must_name(const std::exception &error, const std::string &name)
  {
    must(std::string(error.what()).find(name) != std::string::npos,
         "No " + name + " in the message: " + error.what());
  }

  /** With all its digits. */
  inline std::string written(const double number)
  {
    must(std::isfinite(number), "A number that is not finite was read.");
    char text[32];
    std::snprintf(text, sizeof(text), "%.17g", number);
    return text;
  }
} // namespace RollingContact

#endif
