#include <rolling_contact/contact/halved_problem.h>
#include <rolling_contact/contact/surface_coupling.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace RollingContact
{
  namespace
  {
    using Index = std::array<int, 2>;

    /**
     * The grid of the largest elements of a trace, and which nodes are on it.
     */
    class Grid
    {
    public:
      explicit Grid(const Trace &trace)
        : n_dimensions(trace.n_dimensions)
      {
        for (const Trace::Cell &cell : trace.cells)
          if (cell.upper[0] - cell.lower[0] > size[0] * (1 + rounding))
            for (unsigned int d = 0; d < n_dimensions; ++d)
              {
                origin[d] = cell.lower[d];
                size[d]   = cell.upper[d] - cell.lower[d];
              }
        for (unsigned int i = 0; i < trace.nodes.size(); ++i)
          if (const auto index = index_of(trace.nodes[i]))
            number[*index] = i;
      }

      std::optional<unsigned int> node_at(const Index &index) const
      {
        const auto found = number.find(index);
        return found == number.end() ? std::nullopt
                                     : std::optional(found->second);
      }

      /**
       * The nodes with the given parity of their numbers.
       */
      std::vector<std::pair<Index, unsigned int>>
      nodes_of(const std::array<unsigned int, 2> &odd) const
      {
        std::vector<std::pair<Index, unsigned int>> nodes;
        for (const auto &entry : number)
          if ((entry.first[0] & 1) == int(odd[0]) &&
              (n_dimensions == 1 || (entry.first[1] & 1) == int(odd[1])))
            nodes.push_back(entry);
        return nodes;
      }

      /**
       * The shape function of elements of twice the size between two points.
       */
      double shape(const std::array<double, 2> &node,
                   const std::array<double, 2> &point) const
      {
        double product = 1.;
        for (unsigned int d = 0; d < n_dimensions; ++d)
          product *=
            std::max(0., 1 - std::abs(point[d] - node[d]) / (2 * size[d]));
        return product > rounding ? product : 0.;
      }

    private:
      static constexpr double rounding = 1e-6;

      std::optional<Index> index_of(const std::array<double, 2> &point) const
      {
        Index index{};
        for (unsigned int d = 0; d < n_dimensions; ++d)
          {
            const double steps = (point[d] - origin[d]) / size[d];
            index[d]           = std::lround(steps);
            if (std::abs(steps - index[d]) > rounding)
              return {};
          }
        return index;
      }

      const unsigned int            n_dimensions;
      std::array<double, 2>         origin{}, size{};
      std::map<Index, unsigned int> number; ///< of the node at a place
    };

    /**
     * The elements of twice the size whose corners are nodes, and these.
     */
    HalvedProblem halved_trace(const Trace                       &trace,
                               const Grid                        &grid,
                               const std::array<unsigned int, 2> &odd)
    {
      HalvedProblem                          half;
      std::map<unsigned int, unsigned int>   number; // of nodes of the whole
      std::vector<std::vector<unsigned int>> boxes;
      for (const auto &[index, node] : grid.nodes_of(odd))
        {
          std::vector<unsigned int> corners;
          for (int v = 0; v < 1 << trace.n_dimensions; ++v)
            if (const auto corner = grid.node_at(
                  {{index[0] + 2 * (v & 1), index[1] + 2 * (v >> 1)}}))
              corners.push_back(*corner);
          if (corners.size() < 1u << trace.n_dimensions)
            continue;
          boxes.push_back(corners);
          for (const unsigned int corner : corners)
            number[corner] = 0;
        }
      half.trace.n_dimensions = trace.n_dimensions;
      for (auto &[node, place] : number)
        {
          place = half.nodes.size();
          half.nodes.push_back(node);
          half.trace.nodes.push_back(trace.nodes[node]);
        }
      for (const auto &corners : boxes)
        {
          Trace::Cell cell;
          cell.lower = trace.nodes[corners.front()];
          cell.upper = trace.nodes[corners.back()];
          for (const unsigned int corner : corners)
            cell.corners.push_back({{number[corner], 1.}});
          half.trace.cells.push_back(cell);
        }
      return half;
    }

    /**
     * R: the weights of the whole problem's nodes in those of the half.
     */
    SparseRows weights_of(const HalvedProblem       &half,
                          const Grid                &grid,
                          const Trace               &trace,
                          const std::vector<double> &areas)
    {
      SparseRows R(half.nodes.size());
      for (unsigned int k = 0; k < half.nodes.size(); ++k)
        {
          double sum = 0.;
          for (unsigned int i = 0; i < trace.nodes.size(); ++i)
            if (const double share =
                  grid.shape(half.trace.nodes[k], trace.nodes[i]))
              {
                R[k].emplace_back(i, share * areas[i]);
                sum += share * areas[i];
              }
          for (auto &entry : R[k])
            entry.second /= sum;
        }
      return R;
    }

    ContactCompliance halved_compliance(const HalvedProblem  &half,
                                        const ContactProblem &whole)
    {
      const ContactCompliance &W = whole.operators.W();
      if (const GridCompliance *grid = W.on_grid())
        return {std::make_shared<const GridCompliance>(
          grid->parts().halved(half.nodes, half.coupling.projection()))};
      return half.coupling.to_interface(W.dense());
    }

    template <typename Values>
    Values taken(const Values &all, const std::vector<unsigned int> &nodes)
    {
      Values result;
      if (!all.empty())
        for (const unsigned int node : nodes)
          result.push_back(all[node]);
      return result;
    }

    NodalField taken(const NodalField                &all,
                     const std::vector<unsigned int> &nodes)
    {
      if (all.empty())
        return {};
      NodalField result(nodes.size(), all.n_components());
      for (unsigned int c = 0; c < all.n_components(); ++c)
        for (unsigned int k = 0; k < nodes.size(); ++k)
          result(c, k) = all(c, nodes[k]);
      return result;
    }
  } // namespace

  void HalvedProblem::take(const ContactProblem &whole)
  {
    ContactLoads &loads   = problem.loads;
    loads                 = whole.loads;
    loads.gap             = taken(loads.gap, nodes);
    loads.friction        = taken(loads.friction, nodes);
    loads.slip_of_profile = taken(loads.slip_of_profile, nodes);
    loads.forces          = {};
    loads.inclined_load.reset();
    SurfaceFrames frames = whole.operators.frames();
    frames.nodes         = taken(frames.nodes, nodes);
    problem.operators.set_frames(std::move(frames));
  }

  std::optional<HalvedProblem>
  halved_problem(const ContactProblem              &whole,
                 const Trace                       &trace,
                 const ContactMatrices              matrices,
                 const double                       thickness,
                 const std::array<unsigned int, 2> &odd)
  {
    const Grid    grid(trace);
    HalvedProblem half = halved_trace(trace, grid, odd);
    if (half.nodes.empty())
      return {};
    const ContactOperators &operators = whole.operators;
    const SlipOperator     &slip      = operators.slip_operator();
    half.coupling =
      SurfaceCoupling(weights_of(half, grid, trace, operators.areas()),
                      whole.n_nodes());
    half.problem.operators = ContactOperators(
      half.trace.nodes,
      contact_matrix(half.trace, matrices, thickness),
      halved_compliance(half, whole),
      whole.n_tangential() > 0
        ? SlipOperator(half.trace, slip.kind(), matrices, slip.flow_direction())
        : SlipOperator(slip.kind()),
      operators.coupling(),
      operators.nodal_forces());
    return half;
  }

  ContactState halved_state(const HalvedProblem &half,
                            const ContactState  &whole)
  {
    ContactState state = open_state(half.problem);
    state.approach     = whole.approach;
    state.pressure     = taken(whole.pressure, half.nodes);
    if (half.problem.n_tangential() > 0)
      state.traction = taken(whole.traction, half.nodes);
    return state;
  }
} // namespace RollingContact
