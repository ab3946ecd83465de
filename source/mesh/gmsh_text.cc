#include <rolling_contact/mesh/gmsh_text.h>

#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>

namespace RollingContact
{
  namespace
  {
    /**
     * Reads through the sections that deal.II reads, in their order.
     */
    class GmshCheck
    {
    public:
      explicit GmshCheck(const std::string &text)
        : stream(text)
      {}

      void
      check()
      {
        check_format();
        for (std::string word; stream >> word;)
          if (word == "$Entities" && version >= 4.)
            check_entities();
          else if (word == "$Nodes")
            check_nodes();
          else if (word == "$Elements")
            {
              check_elements();
              return;
            }
          else if (word[0] == '$') // names and whatever else is there
            skip("$End" + word.substr(1));
        throw std::runtime_error("it has no $Elements, or is cut off.");
      }

    private:
      void
      check_format()
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
        number();
        end("$EndMeshFormat");
      }

      void
      skip(const std::string &mark)
      {
        std::string word;
        while (stream >> word && word != mark)
          ;
      }

      [[noreturn]] void
      complain(const std::string &what)
      {
        throw std::runtime_error("in its " + section + " " + what +
                                 "; is it cut off or damaged?");
      }

      void
      end(const std::string &mark)
      {
        std::string word;
        stream >> word;
        if (word != mark)
          complain("\"" + word + "\" stands in place of " + mark);
      }

      double
      number()
      {
        double value = 0.;
        if (!(stream >> value) || !std::isfinite(value))
          complain("a number is missing");
        return value;
      }

      /**
       * A count or a number of a node, element or group.
       */
      long
      whole(const long least = 0)
      {
        const double value = number();
        if (value != std::floor(value) || value < least || value > 2e9)
          complain("a number is out of range");
        return value;
      }

      void
      numbers(const long n)
      {
        for (long i = 0; i < n; ++i)
          number();
      }

      /**
       * Points, curves, surfaces and volumes with their physical groups.
       */
      void
      check_entities()
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
              numbers(whole());
              if (d > 0)
                numbers(whole());
            }
        end("$EndEntities");
      }

      void
      check_nodes()
      {
        section = "$Nodes";
        for_each_block([&](const long n, const long parametric) {
          if (version >= 4. && parametric != 0)
            throw std::runtime_error("it has parametric coordinates; save it "
                                     "with Mesh.SaveParametric = 0.");
          const bool apart = version == 4.1; // numbers first
          for (long i = 0; i < n; ++i)
            {
              nodes.insert(whole());
              numbers(apart ? 0 : 3);
            }
          numbers(apart ? 3 * n : 0);
        });
        end("$EndNodes");
      }

      void
      check_elements()
      {
        section = "$Elements";
        for_each_block([&](const long n, const long type) {
          for (long i = 0; i < n; ++i)
            {
              whole();
              long type_of_element = type;
              if (version < 4.)
                {
                  type_of_element = whole();
                  numbers(whole(2));
                }
              check_nodes_of_element(type_of_element);
            }
        });
        end("$EndElements");
      }

      void
      check_nodes_of_element(const long type)
      {
        static const std::map<long, unsigned int> n_nodes{
          {1, 2}, {2, 3}, {3, 4}, {4, 4}, {5, 8}, {6, 6}, {7, 5}, {15, 1}};
        const auto found = n_nodes.find(type);
        if (found == n_nodes.end())
          throw std::runtime_error(
            "it has elements of Gmsh's type " + std::to_string(type) +
            "; only those of first order can be used (Gmsh: -order 1).");
        for (unsigned int v = 0; v < found->second; ++v)
          if (nodes.count(whole()) == 0)
            complain("an element has a node that is not there");
      }

      /**
       * Format 2 has one block; in format 4 the blocks of geometric entities
       * must hold as many entries as announced.
       */
      template <typename Action>
      void
      for_each_block(const Action &action)
      {
        if (version < 4.)
          {
            action(whole(), 0);
            return;
          }
        const long n_blocks = whole(), total = whole();
        numbers(version == 4.1 ? 2 : 0);
        long sum = 0;
        for (long block = 0; block < n_blocks; ++block)
          {
            numbers(2);
            const long kind = whole(), n = whole();
            sum += n;
            if (sum > total)
              complain("there are more entries than announced");
            action(n, kind);
          }
        if (sum != total)
          complain("there are fewer entries than announced");
      }

      std::istringstream stream;
      std::string        section = "$MeshFormat";
      double             version = 0.;
      std::set<long>     nodes;
    };
  } // namespace



  void
  check_gmsh(const std::string &text)
  {
    GmshCheck(text).check();
  }
} // namespace RollingContact
