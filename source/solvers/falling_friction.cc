#include <rolling_contact/contact/sliding_response.h>
#include <rolling_contact/parallel/interrupt.h>
#include <rolling_contact/solvers/falling_friction.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace RollingContact
{
  /**
   * A state that holds the mu it was solved with, and what belongs to its slip.
   */
  struct FallingFriction::Round
  {
    ContactState        state;
    std::vector<double> own; ///< mu of the friction law
    NaturalResidual     residual;
  };



  namespace
  {
    void
    add_round(const SolverReport &round, SolverReport &report)
    {
      report.solver        = round.solver;
      report.used_fallback = round.used_fallback;
      report.add_work(round);
      ++report.friction_rounds;
      report.residual = round.residual;
      report.reason   = round.reason;
    }



    /**
     * held + d with (1 - G) d = own - held on the slipping nodes, G = d own /
     * d held: less mu_j p_j lets node i slide R_ij faster, see
     * sliding_response(). Elsewhere own.
     */
    std::vector<double>
    newton_target(const ContactProblem      &problem,
                  const ContactState        &state,
                  const std::vector<double> &own)
    {
      const TangentialProblem tangential = tangential_problem(problem, state);
      const auto nodes = slipping_nodes(tangential, state.traction);
      const auto speeds =
        tangential.sliding_speeds(tangential.slip(state.traction));
      const DenseMatrix R = sliding_response(tangential, state.traction, nodes);
      std::vector<double> target = own;
      if (R.n_rows() == 0)
        return target;
      DenseMatrix matrix(nodes.size(), nodes.size()), d(nodes.size(), 1);
      for (std::size_t k = 0; k < nodes.size(); ++k)
        {
          const unsigned int i    = nodes[k];
          const double       fall = problem.friction[i] * problem.speed *
                              problem.friction_law->slope(speeds[i]);
          for (std::size_t l = 0; l < nodes.size(); ++l)
            matrix(k, l) =
              (k == l ? 1. : 0.) - fall * R(k, l) * state.pressure[nodes[l]];
          d(k, 0) = own[i] - state.friction[i];
        }
      if (!solve_general(matrix, d))
        return target;
      for (std::size_t k = 0; k < nodes.size(); ++k)
        {
          const unsigned int i = nodes[k];
          target[i] = std::min(std::max(state.friction[i] + d(k, 0), 0.),
                               problem.friction[i]);
        }
      return target;
    }



    /**
     * mu of the friction law where everything slides fast.
     */
    std::vector<double>
    friction_of_fast_sliding(const ContactProblem &problem)
    {
      const FrictionLaw  &law      = *problem.friction_law;
      std::vector<double> friction = problem.friction;
      for (double &mu : friction)
        mu *= 1 - law.drop(1e9 * law.decay_speed());
      return friction;
    }
  } // namespace



  bool
  FallingFriction::solve_with(const std::vector<double> &friction,
                              const ContactProblem      &problem,
                              Round                     &round,
                              SolverReport              &report) const
  {
    throw_if_interrupted();
    ContactState &state         = round.state;
    state.friction              = friction;
    state.holds_friction        = true;
    const SolverReport fixed_mu = coulomb->solve(problem, state);
    add_round(fixed_mu, report);
    if (!fixed_mu.converged)
      return false;
    state.holds_friction        = false;
    const TangentialProblem own = tangential_problem(problem, state);
    state.holds_friction        = true;
    round.own                   = own.friction;
    round.residual              = natural_residual(problem, own, state);
    report.residual             = round.residual;
    report.history.push_back(round.residual);
    return true;
  }



  bool
  FallingFriction::try_newton(const ContactProblem &problem,
                              Round                &round,
                              SolverReport         &report) const
  {
    Round trial = round;
    if (!solve_with(newton_target(problem, round.state, round.own),
                    problem,
                    trial,
                    report) ||
        !(trial.residual.worst() < 0.5 * round.residual.worst()))
      return false;
    round = std::move(trial);
    return true;
  }



  void
  FallingFriction::settle(const ContactProblem &problem,
                          const double          part,
                          ContactState         &state,
                          SolverReport         &report) const
  {
    const unsigned int max_rounds = 200, patience = 50;
    double             lowest    = std::numeric_limits<double>::infinity();
    unsigned int       n_stalled = 0, pause = 1, n_plain = 1;
    Round              round{state, {}, {}};
    report.converged = false;
    bool solved      = solve_with(state.friction, problem, round, report);
    for (unsigned int k = 0; solved && k < max_rounds && n_stalled < patience;
         ++k)
      {
        const double residual = round.residual.worst();
        report.converged      = residual <= controls.tolerance;
        if (report.converged)
          break;
        n_stalled = residual < 0.5 * lowest ? 0 : n_stalled + 1;
        lowest    = std::min(lowest, residual);
        if (n_plain >= pause)
          {
            if (try_newton(problem, round, report))
              continue;
            pause *= 2;
            n_plain = 0;
          }
        ++n_plain;
        std::vector<double> next = round.own;
        for (std::size_t i = 0; i < next.size(); ++i)
          next[i] = round.state.friction[i] +
                    part * (next[i] - round.state.friction[i]);
        solved = solve_with(next, problem, round, report);
      }
    state                = round.state;
    state.holds_friction = false;
    if (!solved)
      return;
    report.residual = round.residual;
    if (report.converged)
      report.reason.clear();
    else
      report.reason = "friction and sliding speed did not settle: friction may "
                      "fall too steeply";
  }



  SolverReport
  FallingFriction::solve(const ContactProblem &problem,
                         ContactState         &state) const
  {
    if (!problem.friction_law || problem.n_tangential == 0)
      return coulomb->solve(problem, state);
    if (state.friction.size() != problem.n_nodes)
      state.friction = problem.friction;
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
