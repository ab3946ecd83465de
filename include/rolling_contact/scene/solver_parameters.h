#ifndef rolling_contact_scene_solver_parameters_h
#define rolling_contact_scene_solver_parameters_h

#include <rolling_contact/solvers/contact_solver.h>

#include <string>

namespace RollingContact
{
  class Entries;

  /**
   * The entries of section `Contact` that choose and limit the solver.
   */
  struct SolverParameters
  {
    void declare(Entries &entries);

    std::string    solver = "automatic";
    SolverControls controls;
  };
} // namespace RollingContact

#endif
