#include <rolling_contact/mesh/gmsh_text.h>
#include <rolling_contact/mesh/shared_edges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace RollingContact
{
  namespace
  {
    const long largest_int = std::numeric_limits<int>::max();

    /// Gmsh's number of a type
    const long quadrilateral = 3;

    /**
     * Reads through the sections that deal.II reads, in their order, word by
     * word as it does: whole numbers are ints there, and none is checked.
     */
    class GmshCheck
    {
    public:
      GmshCheck(const std::string &text, const unsigned int dimension)
        : text(text)
        , dimension(dimension)
        , stream(text)
      {}

      std::string checked()
      {
        check_format();
        std::string word;
        stream >> word;
        if (word == "$PhysicalNames")
          skip(word);
        if (word == "$Entities" && version >= 4.)
          {
            check_entities();
            stream >> word;
          }
        if (word == "$PartitionedEntities")
          skip(word);
        begin("$Nodes", word);
        check_nodes();
        stream >> word;
        begin("$Elements", word);
        check_elements();
        return text;
      }

    private:
      void check_format()
      {
        std::string mark;
        int         binary = 0;
        stream >> mark >> version >> binary;
        if (mark != "$MeshFormat" || !stream)
          throw std::runtime_error(
            "it does not begin with $MeshFormat; is it a mesh of Gmsh?");
        if (binary != 0)
          throw std::runtime_error(
            "it is binary; save it in ASCII (without -bin, Mesh.Binary = 0).");
        if (!(version >= 2. && version < 2.3) && version != 4. &&
            version != 4.1)
          throw std::runtime_error(
            "its format is not one of 2.0 to 2.2, 4.0 and 4.1 (Gmsh: -format "
            "msh41).");
        whole();
        end("$EndMeshFormat");
      }

      /**
       * Read on to the word after the end of a section.
       */
      void skip(std::string &word)
      {
        const std::string mark = "$End" + word.substr(1);
        while (stream >> word && word != mark)
          ;
        stream >> word;
      }

      void begin(const std::string &mark, const std::string &word)
      {
        if (!stream)
          throw std::runtime_error("it has no " + mark + ", or is cut off.");
        if (word != mark)
          throw std::runtime_error(
            line() + "\"" + word + "\" stands in place of " + mark +
            "; before the nodes a file may have $PhysicalNames, in format 4 "
            "$Entities, and $PartitionedEntities, in this order, and its "
            "elements come next. Save it anew with Gmsh.");
      }

      std::string line()
      {
        stream.clear();
        const auto at = stream.tellg();
        return "line " +
               std::to_string(
                 1 + std::count(text.begin(), text.begin() + at, '\n')) +
               ": ";
      }

      [[noreturn]] void complain(const std::string &what)
      {
        throw std::runtime_error(line() + "in its " + section + " " + what +
                                 "; is it cut off or damaged?");
      }

      void end(const std::string &mark)
      {
        std::string word;
        stream >> word;
        if (word != mark)
          complain("\"" + word + "\" stands in place of " + mark);
      }

      /**
       * Coordinates.
       */
      void numbers(const long n)
      {
        double value = 0.;
        for (long i = 0; i < n; ++i)
          if (!(stream >> value) || !std::isfinite(value))
            {
              std::string rest;
              stream.clear();
              stream >> rest;
              complain(rest.empty()
                         ? "a number is missing"
                         : "\"" + rest + "\" stands in place of a number");
            }
      }

      /**
       * A count, a type, or the number of a node, an element or an entity.
       */
      long whole(const long least = 0, const long most = largest_int)
      {
        std::string word;
        if (!(stream >> word))
          complain("a number is missing");
        long              value  = 0;
        const char *const end    = word.data() + word.size();
        const auto        result = std::from_chars(word.data(), end, value);
        if (result.ec != std::errc() || result.ptr != end || value < least ||
            value > most)
          complain("\"" + word + "\" stands in place of a whole number from " +
                   std::to_string(least) + " to " + std::to_string(most));
        return value;
      }

      void wholes(const long n, const long least = 0)
      {
        for (long i = 0; i < n; ++i)
          whole(least);
      }

      /**
       * Numbers of physical groups: Gmsh puts a minus before that of a group
       * which takes a curve or surface the other way round. It is taken out.
       */
      void groups(const long n)
      {
        for (long i = 0; i < n; ++i)
          {
            stream >> std::ws;
            if (stream.peek() == '-')
              text[stream.tellg()] = ' ';
            whole(-largest_int);
          }
      }

      /**
       * Points, curves, surfaces and volumes with their physical groups and
       * the entities around them, whose sign is their direction.
       */
      void check_entities()
      {
        section = "$Entities";
        long n[4];
        for (long &count : n)
          count = whole();
        for (unsigned int d = 0; d < 4; ++d)
          for (long i = 0; i < n[d]; ++i)
            {
              whole();
              numbers(d == 0 && version == 4.1 ? 3 : 6);
              groups(whole());
              if (d > 0)
                wholes(whole(), -largest_int);
            }
        end("$EndEntities");
      }

      void check_nodes()
      {
        section = "$Nodes";
        for_each_block([&](const long n, const long parametric) {
          if (version >= 4. && parametric != 0)
            throw std::runtime_error("it has parametric coordinates; save it "
                                     "with Mesh.SaveParametric = 0.");
          const bool apart = version == 4.1; // numbers first
          for (long i = 0; i < n; ++i)
            {
              const long node = whole();
              if (!nodes.insert(node).second)
                complain("node " + std::to_string(node) + " is there twice");
              numbers(apart ? 0 : 3);
            }
          numbers(apart ? 3 * n : 0);
        });
        end("$EndNodes");
      }

      void check_elements()
      {
        section = "$Elements";
        for_each_block([&](const long n, const long type) {
          for (long i = 0; i < n; ++i)
            {
              whole();
              long type_of_element = type;
              if (version < 4.)
                {
                  type_of_element   = whole();
                  const long n_tags = whole(2);
                  groups(1);
                  wholes(n_tags - 1, -largest_int);
                }
              check_nodes_of_element(type_of_element);
            }
        });
        end("$EndElements");
        edges.check();
      }

      void check_nodes_of_element(const long type)
      {
        static const std::map<long, unsigned int> n_nodes{
          {1, 2}, {2, 3}, {3, 4}, {4, 4}, {5, 8}, {6, 6}, {7, 5}, {15, 1}};
        const auto found = n_nodes.find(type);
        if (found == n_nodes.end())
          throw std::runtime_error(
            "it has elements of Gmsh's type " + std::to_string(type) +
            "; only those of first order can be used (Gmsh: -order 1).");
        std::vector<long> corners;
        for (unsigned int v = 0; v < found->second; ++v)
          {
            corners.push_back(whole());
            if (nodes.count(corners.back()) == 0)
              complain("an element has a node that is not there, " +
                       std::to_string(corners.back()));
          }
        if (dimension == 2 && type == quadrilateral)
          edges.add(corners);
      }

      /**
       * Format 2 has one block; in format 4 the blocks of geometric entities
       * must hold as many entries as announced.
       */
      template <typename Action>
      void for_each_block(const Action &action)
      {
        if (version < 4.)
          {
            action(whole(), 0);
            return;
          }
        const long n_blocks = whole(), total = whole();
        wholes(version == 4.1 ? 2 : 0); // least and largest number
        long sum = 0;
        for (long block = 0; block < n_blocks; ++block)
          {
            whole(0, version == 4.1 ? 3 : largest_int); // dimension, entity
            whole(0, version == 4.1 ? largest_int : 3); // in 4.0 the reverse
            const long kind = whole(), n = whole();
            sum += n;
            if (sum > total)
              complain("there are more entries than announced, " +
                       std::to_string(total));
            action(n, kind);
          }
        if (sum != total)
          complain("there are fewer entries than announced, " +
                   std::to_string(total));
      }

      std::string        text;
      const unsigned int dimension;
      std::istringstream stream;
      std::string        section = "$MeshFormat";
      double             version = 0.;
      std::set<long>     nodes;
      SharedEdges        edges;
    };
  } // namespace

  std::string checked_gmsh(const std::string &text,
                           const unsigned int dimension)
  {
    return GmshCheck(text, dimension).checked();
  }
} // namespace RollingContact
