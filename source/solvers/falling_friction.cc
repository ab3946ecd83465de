#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/contact/friction_memory.h>
#include <rolling_contact/contact/sliding_response.h>
#include <rolling_contact/solvers/falling_friction.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace RollingContact
{
  /**
   * A state that holds the mu it was solved with, and what belongs to its slip.
   */
  struct FallingFriction::Iterate
  {
    ContactState        state;
    std::vector<double> own; ///< mu of the friction law
    NaturalResidual     residual;
  };

  namespace
  {
    /// decay speeds after which nothing of a law is left to change
    const double fast = 1e9;

    /**
     * The largest mu that the law gives a node: at rest, or sliding fast if mu
     * rises.
     */
    double highest_friction(const ContactLoads &loads, const unsigned int node)
    {
      const FrictionLaw &law = *loads.friction_law;
      return loads.friction[node] *
             std::max(1., 1 - law.drop(fast * law.decay_speed()));
    }

    /**
     * newton_target() where mu at a node depends on how all nodes before it
     * slide.
     */
    std::vector<double>
    newton_target_with_memory(const ContactProblem            &problem,
                              const ContactState              &state,
                              const std::vector<unsigned int> &nodes,
                              const std::vector<double>       &speeds,
                              const DenseMatrix               &R,
                              std::vector<double>              own)
    {
      const DenseMatrix D = FrictionMemory(problem, speeds).derivative(nodes);
      DenseMatrix       matrix = problem.loads.speed * D * R *
                           as_vector(state.pressure)(nodes).asDiagonal();
      matrix.diagonal().array() += 1.;
      Eigen::VectorXd d =
        as_vector(own)(nodes) - as_vector(state.friction)(nodes);
      if (!solve_general(matrix, d))
        return own;
      for (std::size_t k = 0; k < nodes.size(); ++k)
        {
          const unsigned int i = nodes[k];
          own[i] = std::min(std::max(state.friction[i] + d[k], 0.),
                            highest_friction(problem.loads, i));
        }
      return own;
    }

    /**
     * held + d with (1 - G) d = own - held on the slipping nodes, G = d own /
     * d held: less mu_j p_j lets node i slide R_ij faster, see
     * sliding_response(). Elsewhere own.
     */
    std::vector<double> newton_target(const ContactProblem      &problem,
                                      const ContactState        &state,
                                      const std::vector<double> &own)
    {
      const TangentialProblem tangential = tangential_problem(problem, state);
      const auto nodes = slipping_nodes(tangential, state.traction);
      const auto speeds =
        tangential.sliding_speeds(tangential.slip(state.traction));
      const DenseMatrix R = sliding_response(tangential, state.traction, nodes);
      std::vector<double> target = own;
      if (R.size() == 0)
        return target;
      if (problem.loads.memory_length > 0.)
        return newton_target_with_memory(problem, state, nodes, speeds, R, own);
      DenseMatrix matrix = R * as_vector(state.pressure)(nodes).asDiagonal();
      for (std::size_t k = 0; k < nodes.size(); ++k)
        matrix.row(k) *= -problem.loads.friction[nodes[k]] *
                         problem.loads.speed *
                         problem.loads.friction_law->slope(speeds[nodes[k]]);
      matrix.diagonal().array() += 1.;
      Eigen::VectorXd d =
        as_vector(own)(nodes) - as_vector(state.friction)(nodes);
      if (!solve_general(matrix, d))
        return target;
      for (std::size_t k = 0; k < nodes.size(); ++k)
        {
          const unsigned int i = nodes[k];
          target[i] = std::min(std::max(state.friction[i] + d[k], 0.),
                               highest_friction(problem.loads, i));
        }
      return target;
    }

    /**
     * Outer iterations at most, and how many may pass without halving the
     * lowest residual. Empirical: larger numbers only cost time where friction
     * does not settle.
     */
    const unsigned int max_iterations = 200, patience = 50;

    /**
     * mu of the friction law where everything slides fast: so many decay speeds
     * that nothing is left to fall.
     */
    std::vector<double> friction_of_fast_sliding(const ContactProblem &problem)
    {
      const FrictionLaw  &law      = *problem.loads.friction_law;
      std::vector<double> friction = problem.loads.friction;
      for (double &mu : friction)
        mu *= 1 - law.drop(fast * law.decay_speed());
      return friction;
    }
  } // namespace

  bool FallingFriction::solve_with(const std::vector<double> &friction,
                                   const ContactProblem      &problem,
                                   Iterate                   &iterate,
                                   SolverReport              &report) const
  {
    throw_if_interrupted();
    ContactState &state         = iterate.state;
    state.friction              = friction;
    state.holds_friction        = true;
    const SolverReport fixed_mu = fixed_mu_solver->solve(problem, state);
    report.add_friction_round(fixed_mu);
    if (!fixed_mu.converged)
      return false;
    state.holds_friction        = false;
    const TangentialProblem own = tangential_problem(problem, state);
    state.holds_friction        = true;
    iterate.own                 = own.friction;
    iterate.residual            = natural_residual(problem, own, state);
    report.residual             = iterate.residual;
    report.history.push_back(iterate.residual);
    return true;
  }

  bool FallingFriction::try_newton(const ContactProblem &problem,
                                   Iterate              &iterate,
                                   SolverReport         &report) const
  {
    Iterate trial = iterate;
    if (!solve_with(newton_target(problem, iterate.state, iterate.own),
                    problem,
                    trial,
                    report) ||
        !(trial.residual.worst() < 0.5 * iterate.residual.worst()))
      return false;
    iterate = std::move(trial);
    return true;
  }

  void FallingFriction::settle(const ContactProblem &problem,
                               const double          part,
                               ContactState         &state,
                               SolverReport         &report) const
  {
    double       lowest    = std::numeric_limits<double>::infinity();
    unsigned int n_stalled = 0, pause = 1, n_plain = 1;
    Iterate      iterate{state, {}, {}};
    report.converged = false;
    bool solved      = solve_with(state.friction, problem, iterate, report);
    for (unsigned int k = 0;
         solved && k < max_iterations && n_stalled < patience;
         ++k)
      {
        const double residual = iterate.residual.worst();
        report.converged      = residual <= controls.tolerance;
        if (report.converged)
          break;
        n_stalled = residual < 0.5 * lowest ? 0 : n_stalled + 1;
        lowest    = std::min(lowest, residual);
        if (n_plain >= pause)
          {
            if (try_newton(problem, iterate, report))
              continue;
            pause *= 2;
            n_plain = 0;
          }
        ++n_plain;
        std::vector<double> next = iterate.own;
        for (std::size_t i = 0; i < next.size(); ++i)
          next[i] = iterate.state.friction[i] +
                    part * (next[i] - iterate.state.friction[i]);
        solved = solve_with(next, problem, iterate, report);
      }
    state                = iterate.state;
    state.holds_friction = false;
    if (!solved)
      return;
    report.residual = iterate.residual;
    if (report.converged)
      report.reason.clear();
    else
      report.reason = "friction and sliding speed did not settle: friction may "
                      "fall too steeply";
  }

  SolverReport FallingFriction::solve(const ContactProblem &problem,
                                      ContactState         &state) const
  {
    if (!problem.loads.friction_law || problem.n_tangential() == 0)
      return fixed_mu_solver->solve(problem, state);
    if (state.friction.size() != problem.n_nodes())
      state.friction = problem.loads.friction;
    ContactState fast  = state;
    fast.friction      = friction_of_fast_sliding(problem);
    const auto   start = state;
    SolverReport report;
    for (const ContactState *from : {&start, &std::as_const(fast)})
      for (const double part : {1., 0.5})
        {
          state = *from;
          settle(problem, part, state, report);
          if (report.converged && from != &start)
            report.solver += ", from fast sliding";
          if (report.converged)
            return report;
        }
    return report;
  }
} // namespace RollingContact
