#include <rolling_contact/parallel/interrupt.h>
#include <rolling_contact/solvers/coupled_newton.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace RollingContact
{
  namespace
  {
    /**
     * One linear system: unknowns node by node (tangential components, then
     * pressure) on the touching nodes, then the approach if the load is given.
     */
    class NewtonSystem
    {
    public:
      NewtonSystem(const ContactProblem &problem,
                   const SolverControls &controls,
                   const ContactState   &state);

      /**
       * The state after a full step; false if the matrix is singular.
       */
      bool
      solve(ContactState &target);

    private:
      std::size_t
      place(const std::size_t touching, const unsigned int component) const
      {
        return touching * n_components + component;
      }

      void
      add_column(const std::size_t touching, const unsigned int component);

      void
      add_edge_rows();

      void
      set_friction_rows(const std::size_t touching);

      const ContactProblem &problem;
      ContactState          now; ///< nothing carried by nodes that do not touch
      TangentialProblem     friction;
      const double          rho_n, rho_t;
      const unsigned int    n_tangential, n_components;

      std::vector<unsigned int> nodes;
      std::vector<std::size_t>  number; ///< of a node among the touching ones
      std::vector<double>       u_n;
      NodalField                slip;
      DenseMatrix               matrix, right;
    };



    /**
     * The state without tractions where p - rho u_n <= 0.
     */
    ContactState
    released(const ContactProblem &problem,
             const ContactState   &state,
             const double          rho)
    {
      const std::vector<double> u_n    = normal_gap(problem, state);
      ContactState              result = state;
      for (unsigned int i = 0; i < problem.n_nodes(); ++i)
        if (!(state.pressure[i] - rho * u_n[i] > 0.))
          {
            result.pressure[i] = 0.;
            for (unsigned int c = 0; c < problem.n_tangential(); ++c)
              result.traction(c, i) = 0.;
          }
      return result;
    }



    NewtonSystem::NewtonSystem(const ContactProblem &problem,
                               const SolverControls &controls,
                               const ContactState   &state)
      : problem(problem)
      , now(released(problem, state, 1 / problem.operators.normal_norm()))
      , friction(tangential_problem(problem, now))
      , rho_n(1 / problem.operators.normal_norm())
      , rho_t(problem.operators.tangential_norm() > 0.
                ? controls.tangential_augmentation /
                    problem.operators.tangential_norm()
                : 0.)
      , n_tangential(problem.n_tangential())
      , n_components(problem.n_tangential() + 1)
      , number(problem.n_nodes(), problem.n_nodes())
      , u_n(normal_gap(problem, state))
    {
      for (unsigned int i = 0; i < problem.n_nodes(); ++i)
        if (state.pressure[i] - rho_n * u_n[i] > 0.)
          {
            number[i] = nodes.size();
            nodes.push_back(i);
          }
      u_n  = normal_gap(problem, now);
      slip = friction.slip(now.traction);
      const std::size_t n =
        nodes.size() * n_components + (problem.loads.normal_load ? 1 : 0);
      matrix = DenseMatrix(n, n);
      right  = DenseMatrix(n, 1);
    }



    /**
     * What one unknown does to gap and slip of the touching nodes.
     */
    void
    NewtonSystem::add_column(const std::size_t  touching,
                             const unsigned int component)
    {
      const unsigned int N = problem.n_nodes();
      const NodalField   w =
        problem.operators.distortion_of_unit({component, nodes[touching]});
      std::vector<double> u_normal(N, 0.);
      for (const auto &entry : problem.operators.H_column(nodes[touching]))
        for (std::size_t i = 0; i < N; ++i)
          u_normal[i] += problem.operators.W()(n_tangential * N + i,
                                               component * N + entry.first) *
                         entry.second;
      const std::size_t column = place(touching, component);
      for (std::size_t k = 0; k < nodes.size(); ++k)
        {
          const unsigned int i                   = nodes[k];
          matrix(place(k, n_tangential), column) = u_normal[i];
          for (unsigned int c = 0; c < n_tangential; ++c)
            matrix(place(k, c), column) = friction.slip_of(w, {c, i});
        }
    }



    void
    NewtonSystem::add_edge_rows()
    {
      for (unsigned int c = 0; c < friction.rows.edge_rows.size(); ++c)
        for (std::size_t k = 0; k < nodes.size(); ++k)
          for (const auto &entry : friction.rows.edge_rows[c][nodes[k]])
            if (number[entry.first] < problem.n_nodes())
              matrix(place(k, c), place(number[entry.first], c)) +=
                entry.second;
    }



    /**
     * Turn the slip rows of a node into those of its friction law.
     */
    void
    NewtonSystem::set_friction_rows(const std::size_t touching)
    {
      const unsigned int i = nodes[touching];
      const double       p = now.pressure[i],
                   coefficient =
                     p > 0. ? friction.bound[i] / p : friction.friction[i],
                   bound = coefficient * std::max(0., p - rho_n * u_n[i]);
      std::array<double, 2> z{};
      for (unsigned int c = 0; c < n_tangential; ++c)
        z[c] = now.traction(c, i) - rho_t * slip(c, i);
      const double size = std::hypot(z[0], z[1]);
      if (size <= bound)
        {
          for (unsigned int c = 0; c < n_tangential; ++c)
            right(place(touching, c), 0) = -slip(c, i);
          return;
        }
      const std::array<double, 2> direction{{z[0] / size, z[1] / size}};
      // dq - b' direction - b/|z| (1 - direction direction^T) (dq - rho ds)
      const std::size_t n = matrix.n_columns();
      for (std::size_t column = 0; column < n; ++column)
        {
          std::array<double, 2> change{};
          for (unsigned int c = 0; c < n_tangential; ++c)
            change[c] = (column == place(touching, c) ? 1. : 0.) -
                        rho_t * matrix(place(touching, c), column);
          const double along =
            change[0] * direction[0] + change[1] * direction[1];
          for (unsigned int c = 0; c < n_tangential; ++c)
            matrix(place(touching, c), column) =
              (column == place(touching, c) ? 1. : 0.) -
              (column == place(touching, n_tangential)
                 ? coefficient * direction[c]
                 : 0.) -
              (n_tangential == 2
                 ? bound / size * (change[c] - along * direction[c])
                 : 0.);
        }
      for (unsigned int c = 0; c < n_tangential; ++c)
        right(place(touching, c), 0) =
          coefficient * p * direction[c] - now.traction(c, i);
    }



    bool
    NewtonSystem::solve(ContactState &target)
    {
      for (std::size_t k = 0; k < nodes.size(); ++k)
        for (unsigned int c = 0; c < n_components; ++c)
          add_column(k, c);
      add_edge_rows();
      const std::size_t n = matrix.n_rows();
      for (std::size_t k = 0; k < nodes.size(); ++k)
        {
          right(place(k, n_tangential), 0) = -u_n[nodes[k]];
          set_friction_rows(k);
        }
      if (problem.loads.normal_load)
        {
          for (std::size_t k = 0; k < nodes.size(); ++k)
            {
              matrix(place(k, n_tangential), n - 1) =
                -problem.operators.approach_share(nodes[k]);
              matrix(n - 1, place(k, n_tangential)) =
                problem.operators.load_areas()[nodes[k]];
            }
          right(n - 1, 0) =
            *problem.loads.normal_load - problem.operators.load(now.pressure);
        }
      if (n == 0 || !solve_general(matrix, right))
        return false;
      target = now;
      for (std::size_t k = 0; k < nodes.size(); ++k)
        {
          target.pressure[nodes[k]] += right(place(k, n_tangential), 0);
          for (unsigned int c = 0; c < n_tangential; ++c)
            target.traction(c, nodes[k]) += right(place(k, c), 0);
        }
      if (problem.loads.normal_load)
        target.approach += right(n - 1, 0);
      return true;
    }



    NaturalResidual
    residual_of(const ContactProblem &problem, const ContactState &state)
    {
      return natural_residual(problem,
                              tangential_problem(problem, state),
                              state);
    }



    /**
     * The given part of the way from one state to another, without pulls.
     */
    ContactState
    between(const ContactState &from, const ContactState &to, const double part)
    {
      ContactState state = to;
      for (std::size_t i = 0; i < state.pressure.size(); ++i)
        state.pressure[i] = std::max(
          0., from.pressure[i] + part * (to.pressure[i] - from.pressure[i]));
      state.traction -= from.traction;
      state.traction *= part;
      state.traction += from.traction;
      state.approach = from.approach + part * (to.approach - from.approach);
      return state;
    }



    /**
     * Step by the part 1, 1/2, ..., 1/64: the first that lowers the residual by
     * a tenth of the part, else the best of them. Returns the new residual.
     */
    NaturalResidual
    take_damped_step(const ContactProblem  &problem,
                     const ContactState    &target,
                     const NaturalResidual &before,
                     ContactState          &state)
    {
      const ContactState start = state;
      NaturalResidual    best{std::numeric_limits<double>::infinity(), 0.};
      for (double part = 1.; part > 0.01; part /= 2)
        {
          const ContactState    trial    = between(start, target, part);
          const NaturalResidual residual = residual_of(problem, trial);
          if (residual.worst() < best.worst() || part == 1.)
            {
              best  = residual;
              state = trial;
            }
          if (residual.worst() < (1 - 0.1 * part) * before.worst())
            break;
        }
      return best;
    }
  } // namespace



  SolverReport
  CoupledNewton::solve(const ContactProblem &problem, ContactState &state) const
  {
    const unsigned int max_steps = 100, patience = 15;
    SolverReport       report;
    report.solver = "coupled Newton";
    complete(problem, state);
    report.residual           = residual_of(problem, state);
    ContactState    best      = state;
    NaturalResidual lowest    = report.residual;
    unsigned int    n_stalled = 0;
    while (report.residual.worst() > controls.tolerance &&
           report.iterations < max_steps && n_stalled < patience)
      {
        throw_if_interrupted();
        ContactState target;
        if (!NewtonSystem(problem, controls, state).solve(target))
          break;
        report.residual =
          take_damped_step(problem, target, report.residual, state);
        report.history.push_back(report.residual);
        ++report.iterations;
        n_stalled =
          report.residual.worst() < 0.9 * lowest.worst() ? 0 : n_stalled + 1;
        if (report.residual.worst() < lowest.worst())
          {
            lowest = report.residual;
            best   = state;
          }
      }
    report.converged = report.residual.worst() <= controls.tolerance;
    if (!report.converged)
      {
        state           = best;
        report.residual = lowest;
        report.reason =
          "the Newton iteration for pressure and traction at once "
          "stopped falling";
      }
    report.normal_solves = report.tangential_solves = report.iterations;
    return report;
  }
} // namespace RollingContact
