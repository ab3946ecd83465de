#ifndef rolling_contact_tests_mesh_writer_h
#define rolling_contact_tests_mesh_writer_h

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * A body for mesh files: a grid of (a, b, c) with c the depth below the
   * contact surface, mapped to (x, y, z); in 2D without b, and y is zero. The
   * contact surface is boundary 1, the other end of c is 2.
   */
  struct WrittenMesh
  {
    using Point = std::array<double, 3>;

    std::vector<double>                          a, b, c;
    std::function<Point(double, double, double)> map;
    bool                                         closed   = false; ///< in a
    double                                       unit     = 1.;
    bool                                         mirrored = false;

    bool is_flat() const
    {
      return b.size() < 2;
    }

    unsigned int
    node(const unsigned int i, const unsigned int j, const unsigned int k) const
    {
      const unsigned int n_b = is_flat() ? 1 : b.size();
      return 1 + ((i % a.size()) * n_b + j) * c.size() + k;
    }

    /** Corners of a cell as Gmsh and Abaqus count them. */
    std::vector<unsigned int>
    cell(const unsigned int i, const unsigned int j, const unsigned int k) const
    {
      if (is_flat())
        return {node(i, 0, k),
                node(i, 0, k + 1),
                node(i + 1, 0, k + 1),
                node(i + 1, 0, k)};
      std::vector<unsigned int> corners;
      for (const unsigned int at : {k + 1, k})
        for (const auto &[p, q] : {std::pair(0, 0),
                                   std::pair(1, 0),
                                   std::pair(1, 1),
                                   std::pair(0, 1)})
          corners.push_back(node(i + p, j + q, at));
      return corners;
    }

    template <typename Action>
    void for_each_cell(const Action &action) const
    {
      for (unsigned int i = 0; i + (closed ? 0 : 1) < a.size(); ++i)
        for (unsigned int j = 0; j < (is_flat() ? 1 : b.size() - 1); ++j)
          for (unsigned int k = 0; k + 1 < c.size(); ++k)
            action(i, j, k);
    }

    /** Lines "n x y z" with the given blank. */
    std::string nodes(const std::string &blank) const
    {
      std::ostringstream text;
      text << std::setprecision(17);
      for (unsigned int i = 0; i < a.size(); ++i)
        for (unsigned int j = 0; j < (is_flat() ? 1 : b.size()); ++j)
          for (unsigned int k = 0; k < c.size(); ++k)
            {
              Point p = map(a[i], is_flat() ? 0. : b[j], c[k]);
              for (double &coordinate : p)
                coordinate /= unit;
              p[2] *= mirrored ? -1 : 1;
              text << node(i, j, k) << blank << p[0] << blank
                   << (is_flat() ? p[2] : p[1]) << blank
                   << (is_flat() ? 0. : p[2]) << '\n';
            }
      return text.str();
    }

    std::string gmsh() const
    {
      std::ostringstream elements;
      unsigned int       n   = 0;
      const auto         add = [&](const std::string               &type,
                           const unsigned int               id,
                           const std::vector<unsigned int> &corners) {
        elements << ++n << ' ' << type << " 2 " << id << " 1";
        for (const unsigned int corner : corners)
          elements << ' ' << corner;
        elements << '\n';
      };
      for_each_cell([&](unsigned int i, unsigned int j, unsigned int k) {
        const auto all = cell(i, j, k);
        add(is_flat() ? "3" : "5", 3, all);
        if (is_flat())
          {
            if (k == 0)
              add("1", 1, {all[0], all[3]});
            if (k + 2 == c.size())
              add("1", 2, {all[1], all[2]});
            return;
          }
        if (k == 0)
          add("3", 1, {all[4], all[5], all[6], all[7]});
        if (k + 2 == c.size())
          add("3", 2, {all[0], all[1], all[2], all[3]});
      });
      const std::string  points = nodes(" ");
      std::ostringstream text;
      text << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n"
           << std::count(points.begin(), points.end(), '\n') << '\n'
           << points << "$EndNodes\n$Elements\n"
           << n << '\n'
           << elements.str() << "$EndElements\n";
      return text.str();
    }

    /** Elements of format 4.1: a block each for the contact boundary, the hub
     * and the cells; their number. */
    std::string blocks41(unsigned int &n) const
    {
      using Corners = std::vector<unsigned int>;
      std::ostringstream elements;
      const auto         add = [&](const std::string &head, const auto &part) {
        std::ostringstream block;
        const unsigned int before = n;
        for_each_cell([&](unsigned int i, unsigned int j, unsigned int k) {
          const Corners corners = part(cell(i, j, k), k);
          for (std::size_t v = 0; v < corners.size(); ++v)
            block << (v == 0 ? std::to_string(++n) : "") << ' ' << corners[v]
                  << (v + 1 == corners.size() ? "\n" : "");
        });
        elements << head << ' ' << n - before << '\n' << block.str();
      };
      const auto top = [&](const Corners &all, const unsigned int k) {
        return k > 0       ? Corners()
               : is_flat() ? Corners{all[0], all[3]}
                           : Corners(all.begin() + 4, all.end());
      };
      const auto bottom = [&](const Corners &all, const unsigned int k) {
        return k + 2 < c.size() ? Corners()
               : is_flat()      ? Corners{all[1], all[2]}
                                : Corners(all.begin(), all.begin() + 4);
      };
      add(is_flat() ? "1 1 1" : "2 1 3", top);
      add(is_flat() ? "1 2 1" : "2 2 3", bottom);
      add(is_flat() ? "2 1 3" : "3 1 5",
          [](const Corners &all, unsigned int) { return all; });
      return elements.str();
    }

    /** What gmsh() has in format 4.1, with one block of nodes. */
    std::string gmsh41() const
    {
      unsigned int       n_nodes = 0, n = 0, number = 0;
      std::ostringstream numbers, points, text;
      std::istringstream lines(nodes(" "));
      for (std::string line; lines >> number && std::getline(lines, line);)
        {
          ++n_nodes;
          numbers << number << '\n';
          points << line << '\n';
        }
      const std::string blocks = blocks41(n), at = " 0 0 0 0 0 0 1 ";
      text << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n"
           << (is_flat() ? "0 2 1 0\n" : "0 0 2 1\n") << "1" << at << "1 0\n2"
           << at << "2 0\n1" << at << "3 2 1 -2\n$EndEntities\n$Nodes\n1 "
           << n_nodes << " 1 " << n_nodes << '\n'
           << (is_flat() ? 2 : 3) << " 1 0 " << n_nodes << '\n'
           << numbers.str() << points.str() << "$EndNodes\n$Elements\n3 " << n
           << " 1 " << n << '\n'
           << blocks << "$EndElements\n";
      return text.str();
    }

    /** As Abaqus/CAE orders it, with what the program is to leave out. */
    std::string abaqus() const
    {
      std::ostringstream text, top, bottom;
      unsigned int       n = 0;
      text << "*Heading\n** a comment\n*Part, name=Part-1\n*Node\n"
           << nodes(", ") << "*Element, type=" << (is_flat() ? "CPE4" : "C3D8R")
           << '\n';
      for_each_cell([&](unsigned int i, unsigned int j, unsigned int k) {
        text << ++n;
        for (const unsigned int corner : cell(i, j, k))
          text << ", " << corner;
        text << "\r\n";
        if (k == 0)
          top << n << ",\n";
        if (k + 2 == c.size())
          bottom << n << ", " << (is_flat() ? "S2" : "S1") << '\n';
      });
      text << "** Section\n*Elset, internal, elset=_Top_S\n"
           << top.str() << "*Surface, type=ELEMENT, name=Surf-1\n_Top_S, "
           << (is_flat() ? "S4" : "S2")
           << "\n*Surface, type=ELEMENT, name=Surf-2\n"
           << bottom.str()
           << "*End Part\n*Material, name=Steel\n*Elastic\n210000., 0.3\n"
              "*Step\n*Node Output\nU, RF\n*End Step\n";
      return text.str();
    }
  };

  /** From 0 in equal steps to @p fine, then in growing ones to @p end. */
  inline std::vector<double> graded(const double step,
                                    const double fine,
                                    const double end,
                                    const double growth)
  {
    std::vector<double> points;
    const int           n = std::lround(fine / step);
    for (int i = 0; i <= n; ++i)
      points.push_back(i * step);
    double at = n * step, size = step;
    while (at < end)
      points.push_back(at += size *= growth);
    for (double &point : points)
      if (point > n * step)
        point = n * step + (point - n * step) * (end - n * step) /
                             (points.back() - n * step);
    return points;
  }

  /** Both signs, shifted by @p shift steps in the middle and not at the ends.
   */
  inline std::vector<double> mirrored_points(const std::vector<double> &points,
                                             const double               shift)
  {
    std::vector<double> result;
    const double        end = points.back(), step = points[1];
    for (auto p = points.rbegin(); p + 1 != points.rend(); ++p)
      result.push_back(-*p);
    result.insert(result.end(), points.begin(), points.end());
    for (double &at : result)
      at += shift * step * (1 - at * at / (end * end));
    return result;
  }
} // namespace RollingContact

#endif
