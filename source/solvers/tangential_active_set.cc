#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/solvers/semismooth_newton.h>
#include <rolling_contact/solvers/tangential_active_set.h>

#include <set>

namespace RollingContact
{
  namespace
  {
    /**
     * State of a node in the active set: open and stick nodes are 0 and 2, slip
     * nodes carry the sign of their traction.
     */
    enum class NodeState : signed char
    {
      slip_negative = -1,
      open          = 0,
      slip_positive = 1,
      stick         = 2
    };

    using States = std::vector<NodeState>;

    States classify(const TangentialProblem &problem,
                    const NodalField        &traction,
                    const NodalField        &slip,
                    const double             rho)
    {
      States states(traction.n_nodes());
      for (std::size_t i = 0; i < states.size(); ++i)
        {
          const double trial = traction(0, i) - rho * slip(0, i);
          states[i]          = problem.bound[i] <= 0.     ? NodeState::open
                               : trial > problem.bound[i] ? NodeState::slip_positive
                               : trial < -problem.bound[i] ? NodeState::slip_negative
                                                           : NodeState::stick;
        }
      return states;
    }

    /**
     * Traction of the given states: the bound where slip, zero slip where
     * stick.
     */
    bool solve_on(const TangentialProblem &problem,
                  const DenseMatrix       &slip_compliance,
                  const States            &states,
                  NodalField              &traction)
    {
      std::vector<unsigned int> stick;
      for (unsigned int i = 0; i < states.size(); ++i)
        {
          if (states[i] == NodeState::stick)
            stick.push_back(i);
          traction(0, i) =
            states[i] == NodeState::slip_positive   ? problem.bound[i]
            : states[i] == NodeState::slip_negative ? -problem.bound[i]
                                                    : 0.;
        }
      const NodalField known  = problem.slip(traction);
      DenseMatrix      matrix = slip_compliance(stick, stick);
      Eigen::VectorXd  column = -as_vector(known.values())(stick);
      if (!solve_general(matrix, column))
        return false;
      for (std::size_t i = 0; i < stick.size(); ++i)
        traction(0, stick[i]) = column[i];
      return true;
    }
  } // namespace

  SolverReport TangentialActiveSet::solve(const TangentialProblem &problem,
                                          ContactState            &state) const
  {
    if (problem.contact.n_tangential() == 2)
      return SemismoothNewton(controls).solve(problem, state);
    SolverReport report;
    report.solver = "active set";
    std::vector<NodalIndex> unknowns;
    for (unsigned int i = 0; i < problem.contact.n_nodes(); ++i)
      unknowns.push_back({0, i});
    const DenseMatrix slip_compliance = problem.slip_compliance(unknowns);
    const double      norm = problem.contact.operators.tangential_norm();
    double rho = norm > 0. ? controls.tangential_augmentation / norm : 0.;
    problem.project(state.traction);
    const unsigned int max_halvings = 12, patience = 100;
    std::set<States>   visited;
    States             states;
    for (unsigned int halvings = 0; halvings < max_halvings;)
      {
        const States next =
          classify(problem, state.traction, problem.slip(state.traction), rho);
        if (next == states)
          {
            report.converged = true;
            break;
          }
        states = next;
        if (!visited.insert(states).second || visited.size() > patience)
          {
            ++halvings;
            rho /= 2;
            visited.clear();
          }
        if (report.iterations == controls.max_iterations)
          break;
        ++report.iterations;
        if (!solve_on(problem, slip_compliance, states, state.traction))
          {
            report.reason = "the slip operator is singular on the stick nodes";
            return report;
          }
      }
    report.tangential_solves = report.iterations;
    if (!report.converged)
      report.reason = "the stick and slip sets did not settle";
    return report;
  }
} // namespace RollingContact
