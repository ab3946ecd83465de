#ifndef rolling_contact_scene_solver_parameters_h
#define rolling_contact_scene_solver_parameters_h

#include <deal.II/base/parameter_acceptor.h>

#include <rolling_contact/solvers/contact_solver.h>

#include <string>

namespace RollingContact
{
  /**
   * The entries of section `Contact` that choose and limit the solver.
   */
  struct SolverParameters : public dealii::ParameterAcceptor
  {
    SolverParameters();

    std::string    solver = "automatic";
    SolverControls controls;
  };
} // namespace RollingContact

#endif
