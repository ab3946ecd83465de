#include <rolling_contact/base/spelling.h>

#include <algorithm>
#include <cctype>

namespace RollingContact
{
  namespace
  {
    std::string small(std::string text)
    {
      for (char &letter : text)
        letter = std::tolower(static_cast<unsigned char>(letter));
      return text;
    }

    std::string section_of(const std::string &path)
    {
      const std::size_t slash = path.rfind('/');
      return slash == std::string::npos ? "" : path.substr(0, slash);
    }

    std::string entry_of(const std::string &path)
    {
      return path.substr(path.rfind('/') + 1);
    }

    /** Whether the words of one are in the other. */
    bool holds(const std::string &longer, const std::string &shorter)
    {
      return shorter.size() > 2 &&
             (' ' + small(longer) + ' ').find(' ' + small(shorter) + ' ') !=
               std::string::npos;
    }

    /** How far apart two names are; 100 if they have nothing in common. */
    std::size_t difference(const std::string &given, const std::string &known)
    {
      const std::size_t letters = edit_distance(given, known);
      if (letters <= 1 + given.size() / 4 && letters < given.size())
        return letters;
      return holds(known, given) || holds(given, known) ? 2 : 100;
    }
  } // namespace

  std::size_t edit_distance(const std::string &first, const std::string &second)
  {
    const std::string                     a = small(first), b = small(second);
    std::vector<std::vector<std::size_t>> d(a.size() + 1,
                                            std::vector<std::size_t>(b.size() +
                                                                     1));
    for (std::size_t i = 0; i <= a.size(); ++i)
      for (std::size_t j = 0; j <= b.size(); ++j)
        if (i == 0 || j == 0)
          d[i][j] = i + j;
        else
          {
            d[i][j] = std::min({d[i - 1][j] + 1,
                                d[i][j - 1] + 1,
                                d[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
              d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
          }
    return d[a.size()][b.size()];
  }

  std::vector<std::string> likely_meant(const std::string              &path,
                                        const std::vector<std::string> &known)
  {
    // a name right in another section is nearer than a wrong one in this
    std::vector<std::string> nearest;
    std::size_t              least = 100;
    for (const std::string &candidate : known)
      {
        const std::size_t section =
                            difference(section_of(path), section_of(candidate)),
                          all = 3 * difference(entry_of(path),
                                               entry_of(candidate)) +
                                std::min<std::size_t>(section, 2);
        if (all < least)
          nearest.clear();
        least = std::min(least, all);
        if (all == least && all < 100)
          nearest.push_back(candidate);
      }
    if (nearest.size() > 3)
      nearest.resize(3);
    return nearest;
  }

  std::string did_you_mean(const std::vector<std::string> &meant)
  {
    std::string text;
    for (std::size_t k = 0; k < meant.size(); ++k)
      text += (k == 0                  ? "did you mean "
               : k + 1 == meant.size() ? " or "
                                       : ", ") +
              meant[k];
    return text.empty() ? "" : text + '?';
  }
} // namespace RollingContact
