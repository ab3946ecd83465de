#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/solvers/alternation.h>
#include <rolling_contact/solvers/extragradient.h>
#include <rolling_contact/solvers/falling_friction.h>
#include <rolling_contact/solvers/fixed_point.h>
#include <rolling_contact/solvers/normal_active_set.h>
#include <rolling_contact/solvers/solver_chain.h>
#include <rolling_contact/solvers/tangential_active_set.h>

namespace RollingContact
{
  namespace
  {
    /**
     * For friction coefficients that do not depend on the slip.
     */
    std::unique_ptr<ContactSolver>
    make_coulomb_solver(const std::string &name, const SolverControls &controls)
    {
      if (name == "fixed point")
        return std::make_unique<FixedPoint>(controls);
      std::vector<std::unique_ptr<TangentialSolver>> tangential;
      if (name == "active set" || name == "automatic")
        tangential.push_back(std::make_unique<TangentialActiveSet>(controls));
      if (name == "extragradient" || name == "automatic")
        tangential.push_back(std::make_unique<Extragradient>(controls));
      if (tangential.empty())
        throw InputError("Contact/Solver = " + name +
                         ": choose automatic, active set, extragradient or "
                         "fixed point.");
      auto alternation =
        std::make_unique<Alternation>(std::make_unique<NormalActiveSet>(
                                        controls),
                                      std::move(tangential),
                                      controls);
      if (name == "automatic")
        return std::make_unique<SolverChain>(std::move(alternation), controls);
      return alternation;
    }
  } // namespace



  std::unique_ptr<ContactSolver>
  make_contact_solver(const std::string &name, const SolverControls &controls)
  {
    return std::make_unique<FallingFriction>(make_coulomb_solver(name,
                                                                 controls),
                                             controls);
  }
} // namespace RollingContact
