#include <rolling_contact/base/choices.h>
#include <rolling_contact/scene/entries.h>
#include <rolling_contact/scene/solver_parameters.h>

namespace RollingContact
{
  void SolverParameters::declare(Entries &entries)
  {
    entries.section("Contact");
    entries.add("Solver", solver)
      .one_of(choice_names(contact_solver_kinds()))
      .help = choice_help(contact_solver_kinds());
    entries.add("Tolerance", controls.tolerance, "1").between(1e-15, 1.).help =
      "Largest natural residual of a solved state, relative to N and mu N.";
    entries.add("Maximal iterations", controls.max_iterations, "1")
      .at_least(1)
      .help = "Largest number of iterations of each iterative solver.";
    entries.add("Normal augmentation", controls.normal_augmentation, "1")
      .between(1e-12, 1e6)
      .help = "Product of ||W_nn H|| and rho_n of Solver = fixed point, which "
              "converges below 2.";
    entries
      .add("Tangential augmentation", controls.tangential_augmentation, "1")
      .between(1e-12, 1e6)
      .help =
      "Product of ||B1 W_tt H|| and rho_t of Solver = fixed point and active "
      "set.";
  }
} // namespace RollingContact
