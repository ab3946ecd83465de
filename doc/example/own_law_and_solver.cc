#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/solvers/falling_friction.h>
#include <rolling_contact/solvers/normal_active_set.h>
#include <rolling_contact/state/state_finder.h>
#include <rolling_contact/tables/quiet_context.h>

#include <cmath>
#include <cstdio>

// A friction law and a contact solver of one's own, on the contact problem that
// the library makes of a scene: two cylinders of steel that roll at 10 m/s.

using namespace RollingContact;

namespace
{
  /**
   * Friction that falls in two ways with the sliding speed v (m/s), over a
   * short range as a film breaks and over a long one as the surface heats:
   * drop(v) = sum of a_k (1 - exp(-v / v_k)).
   */
  class TwoRanges : public FrictionLaw
  {
  public:
    double drop(const double v) const override
    {
      return 0.15 * (1 - std::exp(-v / 0.02)) + 0.35 * (1 - std::exp(-v / 0.5));
    }

    double slope(const double v) const override
    {
      return 0.15 / 0.02 * std::exp(-v / 0.02) +
             0.35 / 0.5 * std::exp(-v / 0.5);
    }

    double decay_speed() const override
    {
      return 0.02;
    }
  };

  /**
   * Pressure by the library's active set, then traction by guessing which nodes
   * stick, in 2D: those that stick have no slip, all others +-mu p. A node that
   * would carry more than mu p slips from then on, one that slips along its
   * traction sticks, until nothing changes.
   */
  class StickOrSlip : public ContactSolver
  {
  public:
    explicit StickOrSlip(const SolverControls &controls)
      : controls(controls)
    {}

    SolverReport solve(const ContactProblem &problem,
                       ContactState         &state) const override
    {
      complete(problem, state);
      SolverReport report = NormalActiveSet(controls).solve(problem, state);
      report.solver       = "stick or slip";
      if (!report.converged)
        return report;
      report.converged                 = false;
      const TangentialProblem friction = tangential_problem(problem, state);
      std::vector<NodalIndex> nodes;
      for (unsigned int i = 0; i < problem.n_nodes(); ++i)
        if (friction.bound[i] > 0.)
          nodes.push_back({0, i});
      const DenseMatrix S = friction.slip_compliance(nodes);
      std::vector<bool> sticks(nodes.size(), true);
      do
        {
          stick(friction, nodes, S, sticks, state.traction);
          ++report.iterations;
          if (report.ends_with(natural_residual(problem, friction, state),
                               controls.tolerance))
            break;
      } while (report.iterations < 100 &&
               guess_again(friction, nodes, state.traction, sticks));
      return report;
    }

  private:
    /** Tractions of the nodes that stick, those of the others being given. */
    static void stick(const TangentialProblem       &friction,
                      const std::vector<NodalIndex> &nodes,
                      const DenseMatrix             &S,
                      const std::vector<bool>       &sticks,
                      NodalField                    &traction)
    {
      std::vector<std::size_t> unknowns;
      for (std::size_t k = 0; k < nodes.size(); ++k)
        if (sticks[k])
          {
            traction(0, nodes[k].node) = 0.;
            unknowns.push_back(k);
          }
      const NodalField  slip = friction.slip(traction);
      const std::size_t n    = unknowns.size();
      DenseMatrix       A(n, n), q(n, 1);
      for (std::size_t i = 0; i < n; ++i)
        {
          q(i, 0) = -slip(0, nodes[unknowns[i]].node);
          for (std::size_t j = 0; j < n; ++j)
            A(i, j) = S(unknowns[i], unknowns[j]);
        }
      solve_general(A, q);
      for (std::size_t i = 0; i < n; ++i)
        traction(0, nodes[unknowns[i]].node) = q(i, 0);
    }

    /** Cut tractions to mu p, and tell whether any node changed. */
    static bool guess_again(const TangentialProblem       &friction,
                            const std::vector<NodalIndex> &nodes,
                            NodalField                    &traction,
                            std::vector<bool>             &sticks)
    {
      bool             changed = false;
      const NodalField slip    = friction.slip(traction);
      for (std::size_t k = 0; k < nodes.size(); ++k)
        {
          const unsigned int i = nodes[k].node;
          double            &q = traction(0, i);
          if (sticks[k] && std::abs(q) > friction.bound[i])
            {
              q         = std::copysign(friction.bound[i], q);
              sticks[k] = false;
              changed   = true;
            }
          else if (!sticks[k] && slip(0, i) * q > 0.)
            changed = sticks[k] = true;
        }
      return changed;
    }

    SolverControls controls;
  };

  void print(const char           *name,
             const ContactProblem &problem,
             ContactState         &state,
             const ContactSolver  &solver)
  {
    const SolverReport report = solver.solve(problem, state);
    const Resultants   result = resultants(problem, state);
    std::printf("%-34s T/N = %.6f, %3u iterations, residual %.1e\n",
                name,
                result.force_x / result.normal_force,
                report.iterations,
                report.residual.worst());
  }
} // namespace

int main()
{
  SceneParameters scene;
  scene.contact.approach           = 0.22e-3;
  scene.contact.creepages.x        = 0.004;
  scene.contact.speed              = 10.;
  scene.contact.slip_operator      = SlipOperatorKind::upwind_1;
  scene.mesh.elements_across_patch = 24;
  scene.check();

  QuietContext context;

  SteadyState<2> steady =
    solve_steady_state<2>(Situation(scene), StateDemands(), context.run);
  ContactProblem      &problem = steady.problem;
  const SolverControls controls;
  const auto           library = make_contact_solver("automatic", controls);

  ContactState state = open_state(problem);
  print("constant friction, library", problem, state, *library);
  state = open_state(problem);
  print("constant friction, stick or slip",
        problem,
        state,
        StickOrSlip(controls));

  problem.loads.friction_law = std::make_shared<TwoRanges>();
  problem.loads.speed        = 10.;
  state                      = open_state(problem);
  print("two ranges, library", problem, state, *library);
  state = open_state(problem);
  print("two ranges, stick or slip",
        problem,
        state,
        FallingFriction(std::make_unique<StickOrSlip>(controls), controls));
}
