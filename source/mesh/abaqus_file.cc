#include <rolling_contact/mesh/abaqus_file.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <set>
#include <sstream>
#include <stdexcept>

namespace RollingContact
{
  namespace
  {
    using Words = std::vector<std::string>;

    /**
     * The entries between commas, in capitals and without blanks.
     */
    Words words_of(const std::string &line)
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

    /**
     * The value of KEY=value in a keyword line; empty if it is not there.
     */
    std::string option(const Words &words, const std::string &key)
    {
      for (const std::string &word : words)
        if (word.compare(0, key.size() + 1, key + '=') == 0)
          return word.substr(key.size() + 1);
      return "";
    }

    /**
     * A whole number above zero, or 0 if it is none.
     */
    long number(const std::string &word)
    {
      const bool digits =
        !word.empty() && word.size() < 10 &&
        std::all_of(word.begin(), word.end(), [](const unsigned char c) {
          return std::isdigit(c) != 0;
        });
      return digits ? std::strtol(word.c_str(), nullptr, 10) : 0;
    }

    /**
     * A finite number, also with an exponent of Fortran's, 5.0D-03, or nothing,
     * which is zero; false if it is none.
     */
    bool read_real(std::string word, double &value)
    {
      std::replace(word.begin(), word.end(), 'D', 'E');
      char *end = nullptr;
      value     = word.empty() ? 0. : std::strtod(word.c_str(), &end);
      return word.find_first_not_of("0123456789+-.E") == std::string::npos &&
             (word.empty() || *end == '\0') && std::isfinite(value);
    }

    /**
     * Line by line.
     */
    class AbaqusReader
    {
    public:
      explicit AbaqusReader(const unsigned int dimension)
        : dimension(dimension)
      {}

      AbaqusFile read(const std::string &text)
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
            if (!words[0].empty() && words[0][0] == '*')
              begin(words);
            else if (keyword == "*NODE")
              take_node(words);
            else if (keyword == "*ELEMENT")
              take_element(words);
            else if (keyword == "*ELSET")
              take_set(words);
            else if (keyword == "*SURFACE")
              take_surface(words);
            else if (keyword == "*INSTANCE")
              take_place(words);
          }
        if (file.elements.empty())
          throw std::runtime_error(
            "it has no *ELEMENT; is it an Abaqus input file?");
        check_elements();
        return file;
      }

    private:
      [[noreturn]] void complain(const std::string &what) const
      {
        throw std::runtime_error("line " + std::to_string(line_number) + ": " +
                                 what);
      }

      void begin(const Words &words)
      {
        static const std::set<std::string> unread{"*ELCOPY",
                                                  "*ELGEN",
                                                  "*INCLUDE",
                                                  "*NCOPY",
                                                  "*NFILL",
                                                  "*NGEN",
                                                  "*NMAP"};
        keyword                  = words[0];
        const std::string system = option(words, "SYSTEM");
        if (keyword == "*SYSTEM" ||
            (keyword == "*NODE" && !system.empty() && system != "R"))
          complain("a system of coordinates (" + keyword +
                   "); export the part in its final place, in x, y, z.");
        if (unread.count(keyword) > 0 || !option(words, "INPUT").empty())
          complain(keyword + ": write all nodes and elements into this file, "
                             "in its final place.");
        set = option(words, "ELSET");
        if (keyword == "*ELEMENT")
          type = option(words, "TYPE");
        if (keyword == "*ELSET")
          generates = std::count(words.begin(), words.end(), "GENERATE") > 0;
        if (!set.empty() && (keyword == "*ELEMENT" || keyword == "*ELSET"))
          sets[set];
        if (keyword == "*SURFACE")
          begin_surface(words);
      }

      /**
       * Its id are the first digits in its name.
       */
      void begin_surface(const Words &words)
      {
        if (option(words, "TYPE") == "NODE")
          complain("a surface of nodes; define it by the faces of elements, "
                   "*SURFACE, TYPE=ELEMENT.");
        const std::string name = option(words, "NAME"), digits = "0123456789";
        const std::size_t first = name.find_first_of(digits);
        std::string       id    = "0";
        if (first != std::string::npos)
          id =
            name.substr(first, name.find_first_not_of(digits, first) - first);
        if (id.size() > 9)
          complain("the id " + id + " of surface " + name +
                   " is too large; take at most nine digits.");
        file.surfaces.push_back({id, {}});
      }

      void take_node(const Words &words)
      {
        const long node = number(words[0]);
        if (node == 0)
          complain("\"" + words[0] +
                   "\" is not a node number; they are whole, from 1 on.");
        AbaqusFile::Point point{};
        for (unsigned int d = 0; d < dimension && d + 1 < words.size(); ++d)
          if (!read_real(words[d + 1], point[d]))
            complain("\"" + words[d + 1] + "\" is no coordinate of node " +
                     words[0] + "; give numbers like 5.0, 5e-3 or 5.0D-03.");
        if (!file.nodes.insert({node, point}).second)
          complain("node " + words[0] +
                   " is there twice; leave one part in the file, without the "
                   "reference points of an assembly.");
      }

      void take_element(const Words &words)
      {
        const std::size_t n_corners = dimension == 2 ? 4 : 8;
        if (words.size() != n_corners + 1)
          complain("an element of type " + type + " with " +
                   std::to_string(words.size() - 1) + " nodes; only " +
                   (dimension == 2 ? "quadrilaterals of 4 nodes (CPE4)"
                                   : "hexahedra of 8 nodes (C3D8)") +
                   " can be used, no triangles, tetrahedra, wedges, beams, "
                   "shells or elements of second order.");
        const long n = file.elements.size() + 1;
        if (number(words[0]) != n)
          complain("element " + words[0] + " is number " + std::to_string(n) +
                   " of the file; elements must be numbered 1, 2, 3, ... in "
                   "the order of the file, in one part.");
        file.elements.push_back({line_number, {}});
        for (std::size_t v = 1; v < words.size(); ++v)
          {
            file.elements.back().corners.push_back(number(words[v]));
            if (file.elements.back().corners.back() == 0)
              complain("\"" + words[v] + "\" is not a node number.");
          }
        if (!set.empty())
          sets[set].push_back(n);
      }

      void check_elements()
      {
        for (const AbaqusFile::Element &element : file.elements)
          for (const long node : element.corners)
            if (file.nodes.count(node) == 0)
              {
                line_number = element.line;
                complain("an element has node " + std::to_string(node) +
                         ", which is not in the file.");
              }
      }

      /**
       * Numbers, or first, last and step.
       */
      void take_set(const Words &words)
      {
        const long        n_elements = file.elements.size();
        std::vector<long> numbers;
        for (const std::string &word : words)
          {
            numbers.push_back(number(word));
            if (numbers.back() == 0 || numbers.back() > n_elements)
              complain("\"" + word +
                       "\" in *ELSET is not an element above it.");
          }
        if (!generates)
          sets[set].insert(sets[set].end(), numbers.begin(), numbers.end());
        else if (numbers.size() < 2)
          complain("GENERATE needs the first and the last number.");
        else
          for (long i = numbers[0]; i <= numbers[1];
               i += numbers.size() > 2 ? numbers[2] : 1)
            sets[set].push_back(i);
      }

      void take_surface(const Words &words)
      {
        const long        n_elements = file.elements.size();
        const auto        found      = sets.find(words[0]);
        const long        first      = number(words[0]);
        const std::string face       = words.size() > 1 ? words[1] : "";
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
          file.surfaces.back().faces.emplace_back(element, label);
      }

      /**
       * Shift and rotation of an instance.
       */
      void take_place(const Words &words)
      {
        for (const std::string &word : words)
          {
            double value = 0.;
            if (!read_real(word, value) || value != 0.)
              complain("*INSTANCE moves the part (" + word +
                       "); export it in its final place.");
          }
      }

      const unsigned int                       dimension;
      AbaqusFile                               file;
      unsigned int                             line_number = 0;
      std::string                              keyword, type, set;
      bool                                     generates = false;
      std::map<std::string, std::vector<long>> sets;
    };
  } // namespace

  AbaqusFile read_abaqus_file(const std::string &text,
                              const unsigned int dimension)
  {
    return AbaqusReader(dimension).read(text);
  }
} // namespace RollingContact
