#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/input/prm_text.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace RollingContact
{
  namespace fs = std::filesystem;

  namespace
  {
    const std::size_t  max_bytes      = 1 << 24;
    const unsigned int max_inclusions = 100;



    std::string
    trimmed(const std::string &text)
    {
      const std::string blanks = " \t\r\n\v\f";
      const std::size_t begin  = text.find_first_not_of(blanks),
                        end    = text.find_last_not_of(blanks);
      return begin == std::string::npos ? ""
                                        : text.substr(begin, end - begin + 1);
    }



    /** Bytes of a file of any kind, also of a pipe. */
    std::string
    read_bounded(const fs::path &file)
    {
      std::error_code error;
      std::ifstream   stream(file, std::ios::binary);
      if (fs::is_directory(file, error) || !stream ||
          stream.peek() == std::ifstream::traits_type::eof())
        throw InputError(
          file.string() +
          ": cannot be read or is empty; give the path of a .prm file.");
      std::string text;
      char        piece[4096];
      while (text.size() <= max_bytes && stream)
        {
          stream.read(piece, sizeof(piece));
          text.append(piece, stream.gcount());
        }
      if (text.size() > max_bytes)
        throw InputError(file.string() +
                         ": it has more than 16 MiB, which no scene needs; "
                         "give the path of a .prm file.");
      return text;
    }



    /** The next line without comment and blanks around it, continued where it
     * ends with a backslash. False at the end. */
    bool
    next_line(std::istream &lines, std::string &line, unsigned int &number)
    {
      line.clear();
      bool        found = false;
      std::string part;
      while (std::getline(lines, part))
        {
          ++number;
          found           = true;
          part            = trimmed(part);
          const bool ends = part.empty() || part.back() != '\\';
          line += ends ? part : part.substr(0, part.size() - 1);
          if (ends)
            break;
        }
      line = trimmed(line.substr(0, line.find('#')));
      std::replace(line.begin(), line.end(), '\t', ' ');
      return found;
    }



    bool
    begins_with(const std::string &line,
                const std::string &lower,
                const std::string &upper)
    {
      return line.compare(0, lower.size(), lower) == 0 ||
             line.compare(0, upper.size(), upper) == 0;
    }



    void
    check_lines(const fs::path    &file,
                const std::string &text,
                unsigned int      &n_inclusions)
    {
      std::istringstream lines(text);
      unsigned int       number = 0;
      for (std::string line; next_line(lines, line, number);)
        {
          const std::string place =
            file.string() + ": line " + std::to_string(number) + ": ";
          if (begins_with(line, "set ", "SET ") &&
              line.find('{') != std::string::npos)
            throw InputError(place + "'{' cannot stand in an entry.");
          if (!begins_with(line, "include ", "INCLUDE "))
            continue;
          if (++n_inclusions > max_inclusions)
            throw InputError(place + "more than " +
                             std::to_string(max_inclusions) +
                             " inclusions; does a file include itself?");
          const fs::path part = trimmed(line.substr(8));
          check_lines(part, read_bounded(part), n_inclusions);
        }
    }
  } // namespace



  std::string
  read_prm(const fs::path &file)
  {
    const std::string byte_order_mark = "\xEF\xBB\xBF";
    std::string       text            = read_bounded(file);
    if (text.compare(0, byte_order_mark.size(), byte_order_mark) == 0)
      text.erase(0, byte_order_mark.size());
    unsigned int n_inclusions = 0;
    check_lines(file, text, n_inclusions);
    return text;
  }



  std::string
  problem_of_value(const std::string &value)
  {
    for (const char character : value)
      if (character == '#' || character == '{' ||
          (static_cast<unsigned char>(character) < ' ' && character != '\t'))
        return "a value has no '#', '{' or control characters.";
    return !value.empty() && value.back() == '\\'
             ? "a value does not end with a backslash."
             : "";
  }
} // namespace RollingContact
