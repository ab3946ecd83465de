#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/solvers/normal_active_set.h>
#include <rolling_contact/solvers/pressure_on_grid.h>

#include <algorithm>
#include <set>

namespace RollingContact
{
  namespace
  {
    using ActiveSet = std::vector<bool>;

    /**
     * Pressure and approach with zero gap on the active nodes. Returns false
     * when the dense solve breaks down.
     */
    bool solve_on(const ContactProblem      &problem,
                  const std::vector<double> &gap,
                  const ActiveSet           &active,
                  const DenseMatrix         &pressure_compliance,
                  ContactState              &state)
    {
      std::vector<unsigned int> nodes;
      for (unsigned int i = 0; i < problem.n_nodes(); ++i)
        if (active[i])
          nodes.push_back(i);
      const std::size_t n = nodes.size();
      DenseMatrix matrix  = pressure_compliance(nodes, nodes), columns(n, 2);
      for (std::size_t i = 0; i < n; ++i)
        {
          columns(i, 0) = problem.operators.approach_share(nodes[i]);
          columns(i, 1) = gap[nodes[i]];
        }
      if (!solve_general(matrix, columns))
        return false;

      double load_of_unit_approach = 0., load_of_gap = 0.;
      for (std::size_t i = 0; i < n; ++i)
        {
          const double area = problem.operators.load_areas()[nodes[i]];
          load_of_unit_approach += area * columns(i, 0);
          load_of_gap += area * columns(i, 1);
        }
      if (problem.loads.normal_load && n > 0)
        state.approach =
          (*problem.loads.normal_load + load_of_gap) / load_of_unit_approach;
      state.pressure.assign(problem.n_nodes(), 0.);
      for (std::size_t i = 0; i < n; ++i)
        state.pressure[nodes[i]] =
          state.approach * columns(i, 0) - columns(i, 1);
      return true;
    }

    /**
     * Nodes to start from: those in contact now, else those nearest to it.
     */
    ActiveSet initial_set(const ContactProblem      &problem,
                          const std::vector<double> &gap,
                          const ContactState        &state)
    {
      ActiveSet active(problem.n_nodes());
      for (unsigned int i = 0; i < problem.n_nodes(); ++i)
        active[i] = state.pressure[i] > 0.;
      if (std::find(active.begin(), active.end(), true) != active.end())
        return active;
      const double lowest = *std::min_element(gap.begin(), gap.end());
      for (unsigned int i = 0; i < problem.n_nodes(); ++i)
        active[i] =
          problem.loads.normal_load
            ? gap[i] <= lowest
            : gap[i] < state.approach * problem.operators.approach_share(i);
      return active;
    }

    /**
     * The nodes whose sign condition is broken: a pull on an active node, an
     * overlap on another. Rounding of the size of the solve itself is no
     * overlap.
     */
    std::vector<unsigned int> violations(const ActiveSet           &active,
                                         const std::vector<double> &u_n,
                                         const ContactState        &state,
                                         const double overlap_tolerance)
    {
      std::vector<unsigned int> nodes;
      for (unsigned int i = 0; i < active.size(); ++i)
        if (active[i] ? state.pressure[i] <= 0. : u_n[i] < -overlap_tolerance)
          nodes.push_back(i);
      return nodes;
    }
  } // namespace

  SolverReport NormalActiveSet::solve(const ContactProblem &problem,
                                      ContactState         &state) const
  {
    SolverReport report;
    report.solver                = "active set";
    const bool          on_grid  = problem.operators.W().on_grid() != nullptr;
    const double        rounding = on_grid ? 10 * gap_left_on_grid : 1e-14;
    std::vector<double> gap      = problem.loads.gap;
    const auto          coupling =
      problem.operators.normal_displacement_of_traction(state.traction);
    for (unsigned int i = 0; i < problem.n_nodes(); ++i)
      gap[i] += coupling[i];
    if (!problem.loads.normal_load)
      state.approach = problem.loads.approach;

    ActiveSet           active = initial_set(problem, gap, state);
    std::set<ActiveSet> visited;
    bool                single_exchange = false;
    while (report.iterations < controls.max_iterations)
      {
        ++report.iterations;
        if (!(on_grid ? solve_pressure_on_grid(problem, gap, active, state)
                      : solve_on(problem,
                                 gap,
                                 active,
                                 problem.operators.pressure_compliance(),
                                 state)))
          {
            report.reason = "the compliance of the active nodes is singular";
            return report;
          }
        std::vector<double> u_n =
          problem.operators.normal_displacement(state.pressure);
        double largest = 0.;
        for (unsigned int i = 0; i < problem.n_nodes(); ++i)
          {
            largest = std::max(largest, u_n[i]);
            u_n[i] +=
              gap[i] - state.approach * problem.operators.approach_share(i);
          }
        const auto wrong = violations(active, u_n, state, rounding * largest);
        if (wrong.empty())
          {
            report.converged     = true;
            report.normal_solves = report.iterations;
            return report;
          }
        single_exchange = single_exchange || !visited.insert(active).second;
        for (const unsigned int node : wrong)
          {
            active[node] = !active[node];
            if (single_exchange)
              break;
          }
        if (problem.loads.normal_load &&
            std::find(active.begin(), active.end(), true) == active.end())
          active[std::min_element(gap.begin(), gap.end()) - gap.begin()] = true;
      }
    report.normal_solves = report.iterations;
    report.reason = "the active set of the normal problem did not settle";
    return report;
  }
} // namespace RollingContact
