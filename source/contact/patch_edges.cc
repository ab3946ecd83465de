#include <rolling_contact/contact/patch_edge.h>
#include <rolling_contact/contact/patch_edges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace RollingContact
{
  namespace
  {
    /**
     * Touching nodes of a line, in the order of their places along it.
     */
    using Line = std::vector<unsigned int>;

    /**
     * The lines of nodes that tell where the edges of a patch lie.
     */
    class EdgeLines
    {
    public:
      EdgeLines(const ContactOperators    &operators,
                const std::vector<double> &pressure)
        : nodal_forces(operators.nodal_forces())
        , at(operators.positions())
        , pressure(pressure)
      {
        for (unsigned int i = 0; i < at.size(); ++i)
          if (pressure[i] > 0.)
            {
              touching.push_back(i);
              tolerance = std::max({tolerance,
                                    1e-9 * std::abs(at[i][0]),
                                    1e-9 * std::abs(at[i][1])});
            }
      }

      bool empty() const
      {
        return touching.empty();
      }

      /**
       * The line along x that is nearest to y = 0.
       */
      Line middle() const
      {
        double nearest = std::numeric_limits<double>::max();
        for (const unsigned int i : touching)
          nearest = std::min(nearest, std::abs(at[i][1]));
        return line(0, [&](const unsigned int i) {
          return std::abs(at[i][1]) <= nearest * (1 + 1e-9);
        });
      }

      /**
       * The lines along y through the node with the largest @p sign times y, of
       * several that with the largest pressure, and through the nodes beside
       * it.
       */
      Line outermost(const int sign) const
      {
        double outer = -std::numeric_limits<double>::max();
        for (const unsigned int i : touching)
          outer = std::max(outer, sign * at[i][1]);
        std::pair<double, unsigned int> end{-1., 0}; // pressure, node
        for (const unsigned int i : touching)
          if (sign * at[i][1] >= outer - tolerance)
            end = std::max(end, {pressure[i], i});
        return across(at[end.second][0]);
      }

      /**
       * The line along y at a place.
       */
      Line across(const double x) const
      {
        return line(1, [&](const unsigned int i) {
          return std::abs(at[i][0] - x) <= tolerance;
        });
      }

      /**
       * The largest place below, or with @p sign 1 the least one above @p x
       * where nodes touch; x itself if there is none. Units: m.
       */
      double beside(const double x, const int sign) const
      {
        double nearest = std::numeric_limits<double>::infinity();
        for (const unsigned int i : touching)
          if (sign * (at[i][0] - x) > tolerance)
            nearest = std::min(nearest, sign * (at[i][0] - x));
        return std::isfinite(nearest) ? x + sign * nearest : x;
      }

      /**
       * Places and pressures of the nodes of a line along an axis from its last
       * one on, or with @p sign -1 from the first one.
       */
      std::pair<std::vector<double>, std::vector<double>>
      from_end(Line nodes, const unsigned int axis, const int sign) const
      {
        if (sign > 0)
          std::reverse(nodes.begin(), nodes.end());
        std::pair<std::vector<double>, std::vector<double>> found;
        for (const unsigned int node : nodes)
          {
            found.first.push_back(at[node][axis]);
            found.second.push_back(pressure[node]);
          }
        return found;
      }

      double place(const unsigned int node, const unsigned int axis) const
      {
        return at[node][axis];
      }

      /**
       * Whether all nodes lie on one line along x.
       */
      bool is_line() const
      {
        return std::all_of(at.begin(), at.end(), [&](const auto &place) {
          return place[1] == at[0][1];
        });
      }

      const NodalForces nodal_forces;

    private:
      template <typename Condition>
      Line line(const unsigned int axis, const Condition &is_part) const
      {
        Line nodes;
        std::copy_if(touching.begin(),
                     touching.end(),
                     std::back_inserter(nodes),
                     is_part);
        std::sort(nodes.begin(), nodes.end(), [&](const auto i, const auto j) {
          return at[i][axis] < at[j][axis];
        });
        return nodes;
      }

      const ContactOperators::Positions &at;
      const std::vector<double>         &pressure;
      std::vector<unsigned int>          touching;
      double                             tolerance = 0.; ///< of places, m
    };

    /**
     * Edges by @p edge_of, which takes places and pressures from the end.
     */
    template <typename EdgeOf>
    PatchEdges edges_of(const EdgeLines &lines, const EdgeOf &edge_of)
    {
      if (lines.empty())
        return {};
      const auto edge =
        [&](const Line &line, const unsigned int axis, const int sign) {
          const auto [places, pressures] = lines.from_end(line, axis, sign);
          return edge_of(places, pressures);
        };
      return {edge(lines.middle(), 0, -1),
              edge(lines.middle(), 0, 1),
              edge(lines.outermost(-1), 1, -1),
              edge(lines.outermost(1), 1, 1)};
    }

    double recovered(const EdgeLines &lines, const Line &line, const int sign)
    {
      const auto [places, pressures] = lines.from_end(line, 1, sign);
      return recovered_edge(places, pressures, true, lines.nodal_forces);
    }

    /**
     * The largest @p sign times y of the edges near the line that reaches
     * farthest.
     */
    double farthest(const EdgeLines &lines, const int sign)
    {
      const Line   outermost = lines.outermost(sign);
      const double x         = lines.place(outermost.front(), 0),
                   below = lines.beside(x, -1), above = lines.beside(x, 1),
                   edge = recovered(lines, outermost, sign);
      if (below == x || above == x)
        return edge;
      const double to_below =
                     (recovered(lines, lines.across(below), sign) - edge) /
                     (below - x),
                   to_above =
                     (recovered(lines, lines.across(above), sign) - edge) /
                     (above - x),
                   curvature = (to_above - to_below) / (above - below),
                   slope     = to_below - curvature * (below - x);
      const double top       = -slope / curvature / 2;
      return sign * curvature < 0. && top > below - x && top < above - x
               ? edge + slope * top / 2
               : edge;
    }
  } // namespace

  PatchEdges extrapolated_edges(const ContactOperators    &operators,
                                const std::vector<double> &pressure)
  {
    return edges_of(EdgeLines(operators, pressure), patch_edge);
  }

  PatchEdges recovered_edges(const ContactOperators    &operators,
                             const std::vector<double> &pressure)
  {
    const EdgeLines lines(operators, pressure);
    const bool      curved = !lines.is_line();
    PatchEdges      edges =
      edges_of(lines, [&](const auto &places, const auto &pressures) {
        return recovered_edge(places, pressures, curved, lines.nodal_forces);
      });
    if (curved && !lines.empty())
      {
        edges.begin_y = farthest(lines, -1);
        edges.end_y   = farthest(lines, 1);
      }
    return edges;
  }
} // namespace RollingContact
