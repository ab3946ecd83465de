#include <rolling_contact/base/choices.h>
#include <rolling_contact/solvers/accelerated_projection.h>
#include <rolling_contact/solvers/extragradient.h>
#include <rolling_contact/solvers/falling_friction.h>
#include <rolling_contact/solvers/fixed_point.h>
#include <rolling_contact/solvers/normal_active_set.h>
#include <rolling_contact/solvers/normal_tangential_split.h>
#include <rolling_contact/solvers/solver_chain.h>
#include <rolling_contact/solvers/tangential_active_set.h>

#include <cmath>

namespace RollingContact
{
  bool SolverReport::ends_with(const NaturalResidual &now,
                               const double           tolerance)
  {
    residual = now;
    history.push_back(now);
    converged          = now.worst() <= tolerance;
    const bool is_lost = !std::isfinite(now.worst());
    if (is_lost)
      reason = std::isfinite(now.normal) ? "the traction is not a number"
                                         : "the pressure is not a number";
    return converged || is_lost;
  }

  bool TangentialSolver::ends_with(const double  tangential_residual,
                                   SolverReport &report) const
  {
    return report.ends_with({0., tangential_residual},
                            0.5 * controls.tolerance);
  }

  void SolverReport::add_work(const SolverReport &part)
  {
    iterations += part.iterations;
    normal_solves += part.normal_solves;
    tangential_solves += part.tangential_solves;
    passes += part.passes;
    corrections += part.corrections;
    friction_rounds += part.friction_rounds;
    force_rounds += part.force_rounds;
    history.insert(history.end(), part.history.begin(), part.history.end());
  }

  void SolverReport::add_friction_round(const SolverReport &part)
  {
    solver        = part.solver;
    used_fallback = part.used_fallback;
    edges_settled = part.edges_settled;
    residual      = part.residual;
    reason        = part.reason;
    add_work(part);
    ++friction_rounds;
  }

  namespace
  {
    /**
     * Pressure by active sets and traction by the first of @p Tangential that
     * converges, in turn.
     */
    template <class... Tangential>
    std::unique_ptr<ContactSolver> alternating(const SolverControls &controls,
                                               const bool            economical)
    {
      std::vector<std::unique_ptr<TangentialSolver>> tangential;
      (tangential.push_back(std::make_unique<Tangential>(controls)), ...);
      return std::make_unique<NormalTangentialSplit>(
        std::make_unique<NormalActiveSet>(controls),
        std::move(tangential),
        controls,
        economical);
    }

    std::unique_ptr<ContactSolver> automatic(const SolverControls &controls)
    {
      return std::make_unique<SolverChain>(
        alternating<TangentialActiveSet, Extragradient>(controls, false),
        controls);
    }

    /**
     * The second solver where the first finds nothing, or edges that did not
     * settle.
     */
    class IfUnsettled : public ContactSolver
    {
    public:
      IfUnsettled(std::unique_ptr<ContactSolver> first,
                  std::unique_ptr<ContactSolver> second)
        : first(std::move(first))
        , second(std::move(second))
      {}

      SolverReport solve(const ContactProblem &problem,
                         ContactState         &state) const override
      {
        const ContactState start  = state;
        const SolverReport report = first->solve(problem, state);
        if (report.converged && report.edges_settled)
          return report;
        state               = start;
        SolverReport result = second->solve(problem, state);
        result.add_work(report);
        return result;
      }

    private:
      const std::unique_ptr<ContactSolver> first, second;
    };

    std::unique_ptr<ContactSolver> economical(const SolverControls &controls)
    {
      return std::make_unique<SolverChain>(
        std::make_unique<IfUnsettled>(
          alternating<TangentialActiveSet, Extragradient>(controls, true),
          alternating<TangentialActiveSet, Extragradient>(controls, false)),
        controls);
    }

    template <class Tangential>
    std::unique_ptr<ContactSolver> alternating(const SolverControls &controls)
    {
      return alternating<Tangential>(controls, false);
    }

    template <class Solver>
    std::unique_ptr<ContactSolver> make(const SolverControls &controls)
    {
      return std::make_unique<Solver>(controls);
    }
  } // namespace

  const std::vector<ContactSolverKind> &contact_solver_kinds()
  {
    static const std::vector<ContactSolverKind> kinds{
      {"automatic",
       "active set, and the other solvers where it fails",
       &automatic},
      {"economical",
       "as automatic in about half the time. It solves the rounds of the edge "
       "law only as far as they matter. Now and then the edges of stick "
       "settle elsewhere, within the error of the mesh. A table takes it for "
       "`automatic`",
       &economical},
      {"active set",
       "pressure and traction by active sets, in 3D traction by Newton's "
       "method",
       &alternating<TangentialActiveSet>},
      {"extragradient",
       "traction by projection and correction",
       &alternating<Extragradient>},
      {"accelerated projection",
       "traction by projections with Anderson acceleration",
       &alternating<AcceleratedProjection>},
      {"fixed point", "Lai et al. 2017", &make<FixedPoint>}};
    return kinds;
  }

  std::unique_ptr<ContactSolver>
  make_contact_solver(const std::string &name, const SolverControls &controls)
  {
    const ContactSolverKind &kind =
      choice(contact_solver_kinds(), name, "Contact/Solver");
    return std::make_unique<FallingFriction>(kind.make(controls), controls);
  }
} // namespace RollingContact
