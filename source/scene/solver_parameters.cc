#include <deal.II/base/parameter_handler.h>

#include <rolling_contact/base/choices.h>
#include <rolling_contact/scene/solver_parameters.h>

namespace RollingContact
{
  using namespace dealii;

  void
  SolverParameters::declare(ParameterHandler &prm)
  {
    prm.enter_subsection("Contact");
    prm.add_parameter("Solver",
                      solver,
                      choice_help(contact_solver_kinds()),
                      Patterns::Selection(
                        choice_names(contact_solver_kinds())));
    prm.add_parameter(
      "Tolerance",
      controls.tolerance,
      "Largest natural residual of a solved state, over N and mu N. "
      "Units: 1.",
      Patterns::Double(1e-15, 1.));
    prm.add_parameter("Maximal iterations",
                      controls.max_iterations,
                      "Limit of each iterative solver. Units: 1.",
                      Patterns::Integer(1));
    prm.add_parameter(
      "Normal augmentation",
      controls.normal_augmentation,
      "rho_n of the fixed point times ||W_nn H||; it converges below 2. "
      "Units: 1.",
      Patterns::Double(1e-12, 1e6));
    prm.add_parameter(
      "Tangential augmentation",
      controls.tangential_augmentation,
      "rho_t of the fixed point and the active set times ||B1 W_tt H||. "
      "Units: 1.",
      Patterns::Double(1e-12, 1e6));
    prm.leave_subsection();
  }
} // namespace RollingContact
