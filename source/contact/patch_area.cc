#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/contact/node_lines.h>
#include <rolling_contact/contact/patch_area.h>
#include <rolling_contact/contact/recovered_tractions.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>

namespace RollingContact
{
  namespace
  {
    const double       reach        = 3.2;  // of a fit, in elements
    const double       edge_weight  = 0.06; // of nodes at the edge, in a fit
    const double       largest_rest = 0.05; // rms of a fit over its largest
    const unsigned int n_strips     = 8;    // across a box that is cut

    using Place = std::array<double, 2>;

    /**
     * The nodes next to each other along the lines of nodes.
     */
    class Neighbours
    {
    public:
      explicit Neighbours(const ContactOperators &operators)
        : at(operators.positions())
        , beside(at.size())
      {
        for (unsigned int axis = 0; axis < 2; ++axis)
          for (const auto &line : node_lines(operators, axis))
            for (std::size_t k = 1; k < line.size(); ++k)
              {
                beside[line[k]][2 * axis]         = line[k - 1];
                beside[line[k - 1]][2 * axis + 1] = line[k];
              }
      }

      /**
       * The neighbour on side 0 to 3: below and above in x, in y.
       */
      std::optional<unsigned int> on_side(const unsigned int node,
                                          const unsigned int side) const
      {
        return beside[node][side];
      }

      /**
       * Distance to the neighbour on a side, 0 m if there is none.
       */
      double distance(const unsigned int node, const unsigned int side) const
      {
        const auto other = beside[node][side];
        return other ? std::abs(at[*other][side / 2] - at[node][side / 2]) : 0.;
      }

      /**
       * The shorter distance to a neighbour along an axis: the element.
       */
      double element(const unsigned int node, const unsigned int axis) const
      {
        const double below = distance(node, 2 * axis),
                     above = distance(node, 2 * axis + 1);
        return below > 0. && above > 0. ? std::min(below, above)
                                        : std::max(below, above);
      }

      /**
       * Neighbours along the lines and along the lines of these.
       */
      std::set<unsigned int> around(const unsigned int node) const
      {
        std::set<unsigned int> found;
        for (unsigned int side = 0; side < 4; ++side)
          if (const auto next = beside[node][side])
            {
              found.insert(*next);
              for (unsigned int turn = 0; turn < 4; ++turn)
                if (turn / 2 != side / 2 && beside[*next][turn])
                  found.insert(*beside[*next][turn]);
            }
        return found;
      }

    private:
      const ContactOperators::Positions                      &at;
      std::vector<std::array<std::optional<unsigned int>, 4>> beside;
    };

    /**
     * A quadratic polynomial of places in elements from a node.
     */
    struct Quadratic
    {
      double value = 0.;
      Place  slope{}, curvature{}; ///< c_x x^2 + c_y y^2
      double twist = 0.;           ///< of x y

      /**
       * Share of -@p lower to @p upper along @p axis on which it is positive,
       * at @p across of the other axis.
       */
      double length_inside(const unsigned int axis,
                           const double       across,
                           const double       from,
                           const double       to) const
      {
        const unsigned int other = 1 - axis;
        const double       a     = curvature[axis];
        const double       b     = slope[axis] + twist * across;
        const double       c =
          value + (slope[other] + curvature[other] * across) * across;
        const auto at = [&](const double t) { return c + (b + a * t) * t; };
        std::vector<double> ends{from, to};
        const double        discriminant = b * b - 4 * a * c;
        if (discriminant > 0.)
          {
            const double q = -(b + std::copysign(std::sqrt(discriminant), b));
            for (const double root : {2 * c / q, q / (2 * a)})
              if (root > from && root < to) // false for one that is not finite
                ends.push_back(root);
          }
        std::sort(ends.begin(), ends.end());
        double length = 0.;
        for (std::size_t k = 1; k < ends.size(); ++k)
          if (at((ends[k - 1] + ends[k]) / 2) > 0.)
            length += ends[k] - ends[k - 1];
        return length;
      }
    };

    /**
     * Cuts the boxes around nodes where a field on the nodes inside ends like a
     * square root.
     */
    class Outline
    {
    public:
      Outline(const ContactOperators    &operators,
              const std::vector<double> &field,
              std::vector<bool>          nodes_inside)
        : at(operators.positions())
        , neighbours(operators)
        , inside(std::move(nodes_inside))
        , at_edge(at.size())
        , is_line(std::all_of(at.begin(), at.end(), [&](const Place &place) {
          return place[1] == at[0][1];
        }))
      {
        for (const double value : field)
          square.push_back(value * value);
        for (unsigned int i = 0; i < at.size(); ++i)
          at_edge[i] = !others_around(i).empty();
      }

      /**
       * The neighbours of a node that are outside if it is inside, or inside
       * if it is outside.
       */
      std::vector<unsigned int> others_around(const unsigned int node) const
      {
        std::vector<unsigned int> others;
        for (const unsigned int next : neighbours.around(node))
          if (inside[next] != inside[node])
            others.push_back(next);
        return others;
      }

      /**
       * Share of the box around a node that is inside: all or nothing away from
       * the outline, and where nothing fits.
       */
      double share(const unsigned int node) const
      {
        const double uncut = inside[node] ? 1. : 0.;
        if (!at_edge[node])
          return uncut;
        const auto F = fit(node,
                           inside[node] ? std::vector<unsigned int>{node}
                                        : others_around(node));
        return F ? share(node, *F) : uncut;
      }

    private:
      /**
       * Nodes inside that hang together with the @p first ones, near a node.
       */
      std::vector<unsigned int>
      nodes_near(const unsigned int               node,
                 const std::vector<unsigned int> &first) const
      {
        std::vector<unsigned int> found(first);
        std::set<unsigned int>    known(first.begin(), first.end());
        for (std::size_t k = 0; k < found.size(); ++k)
          for (unsigned int side = 0; side < 4; ++side)
            if (const auto next = neighbours.on_side(found[k], side))
              if (inside[*next] && is_near(node, *next) &&
                  known.insert(*next).second)
                found.push_back(*next);
        return found;
      }

      Place in_elements(const unsigned int from, const unsigned int node) const
      {
        Place place{};
        for (unsigned int axis = 0; axis < (is_line ? 1 : 2); ++axis)
          place[axis] =
            (at[node][axis] - at[from][axis]) / neighbours.element(from, axis);
        return place;
      }

      bool is_near(const unsigned int from, const unsigned int node) const
      {
        const Place place = in_elements(from, node);
        return std::max(std::abs(place[0]), std::abs(place[1])) <= reach;
      }

      std::optional<Quadratic> fit(const unsigned int               node,
                                   const std::vector<unsigned int> &first) const
      {
        const std::vector<unsigned int> nodes     = nodes_near(node, first);
        const std::size_t               n_unknown = is_line ? 3 : 6;
        // nodes at the edge hardly count, so that in small spots all fits
        const std::size_t n_inner =
          std::count_if(nodes.begin(), nodes.end(), [&](const unsigned int i) {
            return !at_edge[i];
          });
        if (nodes.size() <= n_unknown || n_inner < (is_line ? 3 : 7))
          return {};
        DenseMatrix         M(nodes.size(), n_unknown);
        std::vector<double> b;
        double              largest = 0.;
        for (std::size_t k = 0; k < nodes.size(); ++k)
          {
            const auto [x, y]   = in_elements(node, nodes[k]);
            const double weight = at_edge[nodes[k]] ? edge_weight : 1.;
            const std::array<double, 6> row{{1., x, x * x, y, y * y, x * y}};
            for (std::size_t c = 0; c < n_unknown; ++c)
              M(k, c) = weight * row[c];
            b.push_back(weight * square[nodes[k]]);
            largest = std::max(largest, square[nodes[k]]);
          }
        const std::vector<double> values = b;
        const DenseMatrix         rows   = M;
        if (!solve_least_squares(M, b))
          return {};
        const double rest =
          (as_vector(values) - rows * as_vector(b)).squaredNorm() /
          nodes.size();
        if (!(std::sqrt(rest) < largest_rest * largest))
          return {};
        b.resize(6, 0.);
        return Quadratic{b[0], {{b[1], b[3]}}, {{b[2], b[4]}}, b[5]};
      }

      double share(const unsigned int node, const Quadratic &F) const
      {
        const auto end = [&](const unsigned int side) {
          const double element = neighbours.element(node, side / 2);
          return element > 0.
                   ? std::min(0.5,
                              neighbours.distance(node, side) / element / 2)
                   : 0.;
        };
        const unsigned int axis =
          std::abs(F.slope[0]) >= (1 - 1e-6) * std::abs(F.slope[1]) ? 0 : 1;
        const double from = -end(2 * axis), to = end(2 * axis + 1);
        if (is_line)
          return F.length_inside(0, 0., from, to) / (to - from);
        const unsigned int other = 1 - axis;
        const double       low = -end(2 * other), high = end(2 * other + 1);
        double             length = 0.;
        for (unsigned int k = 0; k < n_strips; ++k)
          length += F.length_inside(axis,
                                    low + (k + 0.5) / n_strips * (high - low),
                                    from,
                                    to);
        return length / n_strips / (to - from);
      }

      const ContactOperators::Positions &at;
      const Neighbours                   neighbours;
      std::vector<double>                square;
      std::vector<bool>                  inside, at_edge;
      const bool                         is_line;
    };
  } // namespace

  std::vector<double> areas_in_contact(const ContactOperators    &operators,
                                       const std::vector<double> &pressure)
  {
    std::vector<bool> touches(pressure.size());
    for (unsigned int i = 0; i < pressure.size(); ++i)
      touches[i] = pressure[i] > 0.;
    const Outline       outline(operators,
                          recovered_pressure(operators, pressure),
                          touches);
    std::vector<double> areas(pressure.size(), 0.);
    for (unsigned int i = 0; i < areas.size(); ++i)
      {
        const double area = operators.areas()[i] * outline.share(i);
        if (touches[i])
          areas[i] += area;
        else if (area > 0.)
          {
            const auto touching = outline.others_around(i);
            for (const unsigned int next : touching)
              areas[next] += area / touching.size();
          }
      }
    return areas;
  }

  std::vector<double> sticking_areas(const TangentialProblem      &tangential,
                                     const ContactState           &state,
                                     const std::vector<NodeState> &states,
                                     const std::vector<double>    &areas)
  {
    std::vector<double> sticking(states.size(), 0.);
    std::vector<bool>   sticks(states.size());
    for (unsigned int i = 0; i < states.size(); ++i)
      {
        sticks[i] = states[i] == NodeState::stick;
        if (sticks[i])
          sticking[i] = areas[i];
      }
    if (tangential.contact.loads.friction_law || state.traction.empty())
      return sticking;
    const ContactOperators &operators = tangential.contact.operators;
    const Outline           outline(operators,
                          recovered_margin(tangential, states, state),
                          sticks);
    for (unsigned int i = 0; i < states.size(); ++i)
      {
        const auto others = outline.others_around(i);
        const bool at_slip =
          std::any_of(others.begin(), others.end(), [&](const unsigned int k) {
            return states[sticks[i] ? k : i] == NodeState::slip;
          });
        if (at_slip)
          sticking[i] =
            std::min(areas[i], operators.areas()[i] * outline.share(i));
      }
    return sticking;
  }

  PatchAreas patch_areas(const ContactProblem &problem,
                         const ContactState   &state)
  {
    const TangentialProblem   tangential = tangential_problem(problem, state);
    const std::vector<double> areas =
      areas_in_contact(problem.operators, state.pressure);
    const std::vector<double> sticking =
      sticking_areas(tangential, state, node_states(tangential, state), areas);
    return {std::accumulate(areas.begin(), areas.end(), 0.),
            std::accumulate(sticking.begin(), sticking.end(), 0.)};
  }
} // namespace RollingContact
