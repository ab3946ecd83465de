#include <rolling_contact/mesh/abaqus_text.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <map>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace RollingContact
{
  namespace
  {
    using Words = std::vector<std::string>;

    /**
     * The entries between commas, in capitals and without blanks.
     */
    Words
    words_of(const std::string &line)
    {
      Words              words;
      std::istringstream parts(line);
      for (std::string part; std::getline(parts, part, ',');)
        {
          std::string word;
          for (const char c : part)
            if (!std::isspace(static_cast<unsigned char>(c)))
              word += std::toupper(static_cast<unsigned char>(c));
          words.push_back(word);
        }
      while (!words.empty() && words.back().empty())
        words.pop_back();
      return words;
    }



    std::string
    joined(const Words &words)
    {
      std::string line;
      for (const std::string &word : words)
        line += (line.empty() ? "" : ", ") + word;
      return line;
    }



    /**
     * The value of KEY=value in a keyword line; empty if it is not there.
     */
    std::string
    option(const Words &words, const std::string &key)
    {
      for (const std::string &word : words)
        if (word.compare(0, key.size() + 1, key + '=') == 0)
          return word.substr(key.size() + 1);
      return "";
    }



    /**
     * A whole number above zero, or 0 if it is none.
     */
    long
    number(const std::string &word)
    {
      const bool digits =
        !word.empty() && word.size() < 10 &&
        std::all_of(word.begin(), word.end(), [](const unsigned char c) {
          return std::isdigit(c) != 0;
        });
      return digits ? std::strtol(word.c_str(), nullptr, 10) : 0;
    }



    class Reduction
    {
    public:
      explicit Reduction(const unsigned int dimension)
        : dimension(dimension)
      {}

      std::string
      reduce(const std::string &text)
      {
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);)
          {
            ++line_number;
            const Words words = words_of(line);
            if (words.empty() || words[0].compare(0, 2, "**") == 0)
              continue;
            if (words[0] == "*STEP")
              break;
            if (words[0][0] == '*')
              begin(words);
            else if (keyword == "*NODE")
              reduced += joined(words) + '\n';
            else if (keyword == "*ELEMENT")
              take_element(words);
            else if (keyword == "*ELSET")
              take_set(words);
            else if (keyword == "*SURFACE")
              take_surface(words);
          }
        if (n_elements == 0)
          throw std::runtime_error(
            "it has no *ELEMENT; is it an Abaqus input file?");
        return reduced;
      }

    private:
      [[noreturn]] void
      complain(const std::string &what) const
      {
        throw std::runtime_error("line " + std::to_string(line_number) + ": " +
                                 what);
      }

      void
      begin(const Words &words)
      {
        keyword = words[0];
        if (keyword == "*ELEMENT")
          type = option(words, "TYPE");
        if (keyword == "*ELSET")
          {
            set       = option(words, "ELSET");
            generates = std::count(words.begin(), words.end(), "GENERATE") > 0;
            sets[set];
          }
        if (keyword == "*SURFACE" && option(words, "TYPE") == "NODE")
          complain("a surface of nodes; define it by the faces of elements, "
                   "*SURFACE, TYPE=ELEMENT.");
        if (keyword == "*NODE" || keyword == "*ELEMENT" ||
            keyword == "*SURFACE")
          reduced += joined(words) + '\n';
      }

      void
      take_element(const Words &words)
      {
        const std::size_t n_corners = dimension == 2 ? 4 : 8;
        if (words.size() != n_corners + 1)
          complain("an element of type " + type + " with " +
                   std::to_string(words.size() - 1) + " nodes; only " +
                   (dimension == 2 ? "quadrilaterals of 4 nodes (CPE4)"
                                   : "hexahedra of 8 nodes (C3D8)") +
                   " can be used, no triangles, tetrahedra, wedges, beams, "
                   "shells or elements of second order.");
        ++n_elements;
        if (number(words[0]) != n_elements)
          complain("element " + words[0] + " is number " +
                   std::to_string(n_elements) +
                   " of the file; elements must be numbered 1, 2, 3, ... in "
                   "the order of the file, in one part.");
        reduced += joined(words) + '\n';
      }

      /**
       * Numbers, or first, last and step.
       */
      void
      take_set(const Words &words)
      {
        std::vector<long> numbers;
        for (const std::string &word : words)
          {
            numbers.push_back(number(word));
            if (numbers.back() == 0 || numbers.back() > n_elements)
              complain("\"" + word +
                       "\" in *ELSET is no number of an element before it.");
          }
        if (!generates)
          sets[set].insert(sets[set].end(), numbers.begin(), numbers.end());
        else if (numbers.size() > 1)
          for (long i = numbers[0]; i <= numbers[1];
               i += numbers.size() > 2 ? numbers[2] : 1)
            sets[set].push_back(i);
      }

      void
      take_surface(const Words &words)
      {
        const auto        found = sets.find(words[0]);
        const long        first = number(words[0]);
        const std::string face  = words.size() > 1 ? words[1] : "";
        const bool        named =
          face.size() == 2 && (face[0] == 'S' || face[0] == 'E');
        const long label = named ? number(face.substr(1)) : 0;
        if (found == sets.end() && (first < 1 || first > n_elements))
          complain("\"" + words[0] +
                   "\" in *SURFACE is neither the name of an *ELSET nor the "
                   "number of an element.");
        if (label < 1 || label > (dimension == 2 ? 4 : 6))
          complain("\"" + face +
                   "\" in *SURFACE is no face of an element (S1 "
                   "to " +
                   (dimension == 2 ? "S4)." : "S6)."));
        for (const long element :
             found == sets.end() ? std::vector<long>{first} : found->second)
          reduced +=
            std::to_string(element) + ", S" + std::to_string(label) + '\n';
      }

      const unsigned int                       dimension;
      unsigned int                             line_number = 0;
      std::string                              keyword, type, set, reduced;
      bool                                     generates = false;
      std::map<std::string, std::vector<long>> sets;
      long                                     n_elements = 0;
    };
  } // namespace



  std::string
  checked_abaqus(const std::string &text, const unsigned int dimension)
  {
    return Reduction(dimension).reduce(text);
  }
} // namespace RollingContact
