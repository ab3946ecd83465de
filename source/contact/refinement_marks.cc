#include <rolling_contact/contact/refinement_marks.h>

#include <algorithm>
#include <array>
#include <limits>

namespace RollingContact
{
  namespace
  {
    /**
     * A cell with corners in and out of contact.
     */
    struct RimCell
    {
      const Trace::Cell *cell;
      bool               leading; ///< the pressure grows along the flow
    };

    std::vector<RimCell> rim_cells(const Trace               &trace,
                                   const std::vector<double> &pressure,
                                   const int                  flow)
    {
      std::vector<RimCell> result;
      for (const Trace::Cell &cell : trace.cells)
        {
          unsigned int n_touching = 0;
          double       growth     = 0.;
          for (unsigned int c = 0; c < cell.corners.size(); ++c)
            {
              const double p = apply(cell.corners[c], pressure);
              n_touching += p > 0.;
              growth += (c & 1 ? flow : -flow) * p;
            }
          if (n_touching > 0 && n_touching < cell.corners.size())
            result.push_back({&cell, growth > 0.});
        }
      return result;
    }

    /**
     * True if the cell, no smaller than the rim cell, is that or one of the
     * next two along x inside the contact.
     */
    bool in_band(const Trace::Cell &cell, const RimCell &rim, const int flow)
    {
      const double size         = rim.cell->upper[0] - rim.cell->lower[0];
      const double tolerance    = 1e-3 * size;
      const bool   inside_is_up = (flow > 0) == rim.leading;
      const double lower = rim.cell->lower[0] - (inside_is_up ? 0 : 2) * size,
                   upper = rim.cell->upper[0] + (inside_is_up ? 2 : 0) * size;
      return cell.upper[0] - cell.lower[0] > size - tolerance &&
             cell.upper[0] > lower + tolerance &&
             cell.lower[0] < upper - tolerance &&
             (cell.upper[1] == cell.lower[1] ||
              (cell.upper[1] > rim.cell->lower[1] + tolerance &&
               cell.lower[1] < rim.cell->upper[1] - tolerance));
    }

    /**
     * True if some corners stick and others slip; a hanging corner counts by
     * the nodes it hangs between.
     */
    bool stick_meets_slip(const Trace::Cell            &cell,
                          const std::vector<NodeState> &states)
    {
      bool sticks = false, slips = false;
      for (const auto &corner : cell.corners)
        for (const auto &entry : corner)
          {
            sticks = sticks || states[entry.first] == NodeState::stick;
            slips  = slips || states[entry.first] == NodeState::slip;
          }
      return sticks && slips;
    }

    bool touch(const Trace::Cell &a, const Trace::Cell &b)
    {
      const double tolerance = 1e-3 * (a.upper[0] - a.lower[0]);
      for (unsigned int d = 0; d < 2; ++d)
        if (a.lower[d] > b.upper[d] + tolerance ||
            b.lower[d] > a.upper[d] + tolerance)
          return false;
      return true;
    }

    using Marks = std::vector<RefinementMark>;

    void mark_rim(const Trace               &trace,
                  const std::vector<double> &pressure,
                  const int                  flow,
                  Marks                     &marks)
    {
      const auto rim = rim_cells(trace, pressure, flow);
      for (std::size_t k = 0; k < marks.size(); ++k)
        for (const RimCell &edge : rim)
          if (in_band(trace.cells[k], edge, flow))
            marks[k] = std::min(marks[k],
                                edge.leading ? RefinementMark::leading_rim
                                             : RefinementMark::trailing_rim);
    }

    void mark_stick_border(const Trace                  &trace,
                           const std::vector<NodeState> &states,
                           Marks                        &marks)
    {
      for (const Trace::Cell &border : trace.cells)
        if (stick_meets_slip(border, states))
          for (std::size_t k = 0; k < marks.size(); ++k)
            {
              const Trace::Cell &cell = trace.cells[k];
              if (touch(cell, border) &&
                  cell.upper[0] - cell.lower[0] >
                    0.9 * (border.upper[0] - border.lower[0]))
                marks[k] = std::min(marks[k], RefinementMark::stick_border);
            }
    }

    /**
     * A cell all of whose corners stick.
     */
    bool sticks(const Trace::Cell &cell, const std::vector<NodeState> &states)
    {
      return std::all_of(cell.corners.begin(),
                         cell.corners.end(),
                         [&](const SparseRows::Row &corner) {
                           return std::all_of(corner.begin(),
                                              corner.end(),
                                              [&](const auto &entry) {
                                                return states[entry.first] ==
                                                       NodeState::stick;
                                              });
                         });
    }

    /**
     * In 3D the stick zone goes with its leading edge: it carries the traction
     * of each line on, and with it the disturbance where lines end.
     */
    void mark_stick_zone(const Trace                  &trace,
                         const std::vector<NodeState> &states,
                         Marks                        &marks)
    {
      double smallest = std::numeric_limits<double>::max();
      for (std::size_t k = 0; k < marks.size(); ++k)
        if (marks[k] == RefinementMark::leading_rim)
          smallest =
            std::min(smallest,
                     trace.cells[k].upper[0] - trace.cells[k].lower[0]);
      for (std::size_t k = 0; k < marks.size(); ++k)
        if (trace.cells[k].upper[0] - trace.cells[k].lower[0] >
              0.9 * smallest &&
            sticks(trace.cells[k], states))
          marks[k] = RefinementMark::leading_rim;
    }

    /**
     * The mark of a finer neighbour's, of two on opposite sides the less
     * urgent; none unless there are two.
     */
    class GapFilling
    {
    public:
      GapFilling(const Trace &trace, const Marks &marks)
        : trace(trace)
        , marks(marks)
      {}

      RefinementMark mark_of(const Trace::Cell &cell) const
      {
        RefinementMark best = RefinementMark::none;
        for (unsigned int d = 0; d < trace.n_dimensions; ++d)
          best =
            std::min(best, std::max(beyond(cell, d, -1), beyond(cell, d, 1)));
        return best;
      }

    private:
      /**
       * The mark of the cell beyond the middle of a side if that is going to be
       * finer; the most urgent if it is finer already.
       */
      RefinementMark beyond(const Trace::Cell &cell,
                            const unsigned int d,
                            const int          side) const
      {
        std::array<double, 2> point;
        for (unsigned int e = 0; e < 2; ++e)
          point[e] = (cell.lower[e] + cell.upper[e]) / 2;
        const double size = cell.upper[d] - cell.lower[d];
        point[d] += side * 0.51 * size;
        for (std::size_t k = 0; k < marks.size(); ++k)
          {
            const Trace::Cell &other = trace.cells[k];
            if (point[0] < other.lower[0] || point[0] > other.upper[0] ||
                point[1] < other.lower[1] || point[1] > other.upper[1])
              continue;
            return other.upper[d] - other.lower[d] < 0.75 * size
                     ? RefinementMark::leading_rim
                     : marks[k];
          }
        return RefinementMark::none;
      }

      const Trace &trace;
      const Marks &marks;
    };

    void fill_gaps(const Trace &trace, Marks &marks)
    {
      for (bool changed = true; changed;)
        {
          changed                   = false;
          const Marks      previous = marks;
          const GapFilling gaps(trace, previous);
          for (std::size_t k = 0; k < marks.size(); ++k)
            if (previous[k] == RefinementMark::none)
              {
                marks[k] = gaps.mark_of(trace.cells[k]);
                changed  = changed || marks[k] != RefinementMark::none;
              }
        }
    }
  } // namespace

  std::vector<RefinementMark> refinement_marks(const Trace          &trace,
                                               const ContactProblem &problem,
                                               const ContactState   &state)
  {
    const int flow = problem.n_tangential() > 0
                       ? problem.operators.slip_operator().flow_direction()
                       : 1;
    Marks     marks(trace.cells.size(), RefinementMark::none);
    mark_rim(trace, state.pressure, flow, marks);
    if (problem.n_tangential() > 0)
      {
        const auto states =
          node_states(tangential_problem(problem, state), state);
        mark_stick_border(trace, states, marks);
        if (trace.n_dimensions == 2)
          mark_stick_zone(trace, states, marks);
      }
    fill_gaps(trace, marks);
    return marks;
  }
} // namespace RollingContact
