#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/files.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/input/prm_text.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace RollingContact
{
  namespace fs = std::filesystem;

  namespace
  {
    const std::size_t  max_bytes      = 1 << 24;
    const unsigned int max_inclusions = 100;

    [[noreturn]] void reject(const std::string &place,
                             const std::string &reason)
    {
      throw InputError(place + reason);
    }

    const std::string wanted = "give the path of a .prm file.";

    /** Throws unless all bytes are those of a text. */
    void require_text(const std::string &place, const std::string &text)
    {
      if (text.size() > max_bytes)
        reject(place,
               "it has more than 16 MiB, which no scene needs; " + wanted);
      if (text.empty())
        reject(place, "the file is empty; " + wanted);
      unsigned int line = 1;
      for (const char character : text)
        {
          line += character == '\n';
          if (static_cast<unsigned char>(character) < ' ' &&
              std::string("\t\n\v\f\r").find(character) == std::string::npos)
            reject(place,
                   "line " + std::to_string(line) + " holds the byte " +
                     quotable(std::string(1, character)) +
                     ", so it is no text; " + wanted);
        }
    }

    /** Bytes of a file, all of them of a text. */
    std::string read_bounded(const fs::path &file)
    {
      const std::string place   = file.string() + ": ",
                        problem = why_unreadable(file);
      if (!problem.empty())
        reject(place, "cannot be read: " + problem + "; " + wanted);
      if (size_of(file) > max_bytes)
        reject(place,
               "it has more than 16 MiB, which no scene needs; " + wanted);
      const std::string text = read_bytes(file);
      require_text(place, text);
      return text;
    }

    /** The next line without comment and blanks around it, continued where it
     * ends with a backslash. False at the end. */
    bool next_line(std::istream &lines, std::string &line, unsigned int &number)
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

    /** Whether a line is a statement of this word; then what follows it. */
    bool is_statement(const std::string &line,
                      const std::string &lower,
                      const std::string &upper,
                      std::string       &rest)
    {
      const std::string word = line.substr(0, line.find(' '));
      if (word != lower && word != upper)
        return false;
      rest = trimmed(line.substr(word.size()));
      return true;
    }

    /**
     * Collects the entries of a file and of those it includes.
     */
    class Scan
    {
    public:
      explicit Scan(PrmText &found)
        : found(found)
      {}

      void read(const fs::path    &file,
                const std::string &text,
                const std::string &section);

    private:
      /** ", 'WHAT IT SAYS'" of a statement; of a file that is included nothing,
       * which may be one that is not for the reader of the message. */
      std::string said(const std::string &statement) const;

      void add_entry(const std::string                   &path,
                     const std::string                   &rest,
                     const std::string                   &place,
                     const unsigned int                   line,
                     std::map<std::string, unsigned int> &lines);

      PrmText     &found;
      unsigned int n_inclusions = 0;
      unsigned int depth        = 0; ///< of the file that is read
    };

    std::string Scan::said(const std::string &statement) const
    {
      return depth > 1 ? "it" : "'" + quotable(statement) + "'";
    }

    void Scan::add_entry(const std::string                   &path,
                         const std::string                   &rest,
                         const std::string                   &place,
                         const unsigned int                   line,
                         std::map<std::string, unsigned int> &lines)
    {
      const std::size_t equals = rest.find('=');
      if (equals == std::string::npos)
        reject(place,
               said("set " + rest) + " has no '='; write `set ENTRY = VALUE`.");
      const std::string entry = path + trimmed(rest.substr(0, equals)),
                        value = trimmed(rest.substr(equals + 1));
      if (rest.find('{') != std::string::npos)
        reject(place, "'{' cannot stand in an entry.");
      const auto [known, is_new] = lines.emplace(entry, line);
      if (!is_new)
        reject(place,
               quotable(entry) + " is given here and in line " +
                 std::to_string(known->second) + "; leave one of them out.");
      found.entries.push_back({entry, value, place});
    }

    void Scan::read(const fs::path    &file,
                    const std::string &text,
                    const std::string &section)
    {
      std::istringstream                  stream(text);
      std::vector<std::string>            open{section};
      std::map<std::string, unsigned int> lines;
      unsigned int                        number = 0;
      std::string                         rest;
      ++depth;
      for (std::string line; next_line(stream, line, number);)
        {
          const std::string place =
            file.string() + ": line " + std::to_string(number) + ": ";
          if (line.empty())
            continue;
          if (is_statement(line, "set", "SET", rest))
            add_entry(open.back(), rest, place, number, lines);
          else if (is_statement(line, "subsection", "SUBSECTION", rest))
            {
              found.sections.push_back({open.back() + rest, "", place});
              open.push_back(open.back() + rest + '/');
            }
          else if (is_statement(line, "end", "END", rest) && rest.empty())
            {
              if (open.size() == 1)
                reject(place, "'end' without a section that it could end.");
              open.pop_back();
            }
          else if (is_statement(line, "include", "INCLUDE", rest))
            {
              if (++n_inclusions > max_inclusions)
                reject(place,
                       "more than " + std::to_string(max_inclusions) +
                         " inclusions; does a file include itself?");
              const fs::path included = file.parent_path() / rest;
              read(included, read_bounded(included), open.back());
            }
          else
            reject(place,
                   said(line) +
                     " is no line of a .prm file; write `set ENTRY = VALUE`, "
                     "`subsection NAME`, `end` or `include FILE`, and # before "
                     "a comment.");
        }
      if (open.size() > 1)
        reject(file.string() + ": ",
               "section " +
                 quotable(open.back().substr(0, open.back().size() - 1)) +
                 " is not ended; write `end` behind its last entry.");
      --depth;
    }
  } // namespace

  PrmText read_prm(const fs::path &file)
  {
    return read_prm_text(read_bounded(file), file.string());
  }

  PrmText read_prm_text(const std::string &text, const std::string &name)
  {
    require_text(name + ": ", text);
    const std::string byte_order_mark = "\xEF\xBB\xBF";
    PrmText           found;
    found.text = text;
    if (found.text.compare(0, byte_order_mark.size(), byte_order_mark) == 0)
      found.text.erase(0, byte_order_mark.size());
    Scan(found).read(name, found.text, "");
    return found;
  }

  std::string problem_of_value(const std::string &value)
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
