#include <boost/algorithm/string.hpp>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/files.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/surfaces/surface_file.h>

namespace RollingContact
{
  namespace
  {
    const std::size_t most_bytes = 200'000'000; // of a text

    /** Take a word off the front of a text; false if it is not there. */
    bool take_keyword(const std::string &keyword, std::string &text)
    {
      if (!boost::starts_with(text, keyword))
        return false;
      text = trimmed(text.substr(keyword.size()));
      return true;
    }
  } // namespace

  SurfaceFile::Source SurfaceFile::source_of(const std::string &text)
  {
    Source      found;
    std::string rest  = text;
    found.mirrored    = take_keyword("mirrored:", rest);
    found.middle_line = !found.mirrored && take_keyword("middle line:", rest);
    found.file        = rest;
    if (take_keyword("table:", rest))
      {
        found.kind       = Kind::line;
        const auto space = rest.find_last_of(" \t");
        found.file       = trimmed(rest.substr(0, space));
        if (space != std::string::npos)
          found.column = rest.substr(space + 1);
      }
    else if (take_keyword("grid:", rest))
      {
        found.kind = Kind::grid;
        found.file = rest;
      }
    else if (boost::iends_with(rest, ".sdf"))
      found.kind = Kind::sdf;
    else if (boost::ends_with(rest, ".csv"))
      found.kind = Kind::line;
    else
      for (const std::string ending : {".h5:", ".hdf5:"})
        if (const auto place = rest.find(ending);
            place != std::string::npos && found.kind == Kind::none)
          {
            const std::size_t colon = place + ending.size() - 1;
            found.kind              = Kind::hdf5;
            found.file              = trimmed(rest.substr(0, colon));
            found.dataset           = trimmed(rest.substr(colon + 1));
          }
    return found;
  }

  SurfaceFile::SurfaceFile(const std::string           &entry,
                           const std::string           &text,
                           const std::filesystem::path &folder)
    : entry(entry)
    , text(text)
    , source(source_of(text))
    , path((folder / source.file).string())
  {
    if ((source.mirrored || source.middle_line) &&
        (source.kind == Kind::none || source.kind == Kind::line))
      throw InputError(entry + " = " + quotable(text, 200) +
                       ": `mirrored:` and `middle line:` stand in front of a "
                       "map, FILE.sdf, grid: FILE or FILE.h5:/DATASET.");
    const std::string problem = why_unreadable(path);
    if (!problem.empty())
      reject("cannot be read: " + problem + ".");
    if (source.kind != Kind::hdf5 && size_of(path) > most_bytes)
      reject("it has " + human_bytes(static_cast<double>(size_of(path))) +
             "; at most " + human_bytes(most_bytes) + " are read.");
  }

  void SurfaceFile::reject(const std::string &reason,
                           const std::size_t  line) const
  {
    throw InputError(entry + " = " + quotable(text, 200) + ": \"" + path + '"' +
                     (line > 0 ? ", line " + std::to_string(line) : "") + ": " +
                     reason);
  }

  std::size_t SurfaceFile::column() const
  {
    const std::string &given = source.column;
    const auto         found = number(given);
    if (given.size() > 3 ||
        given.find_first_not_of("0123456789") != std::string::npos || !found ||
        *found < 2)
      throw InputError(entry + " = " + quotable(text, 200) +
                       ": the column of the height is a number from 2 on, not "
                       "\"" +
                       quotable(given) + "\".");
    return static_cast<std::size_t>(*found);
  }
} // namespace RollingContact
