#ifndef rolling_contact_bodies_body_solver_h
#define rolling_contact_bodies_body_solver_h

namespace RollingContact
{
  /**
   * How the displacements of a body are found.
   */
  enum class BodySolver
  {
    automatic,
    direct,
    distributed
  };

  /**
   * The largest Poisson ratio of a distributed body: conjugate gradients with
   * multigrid fail on nearly incompressible ones.
   */
  constexpr double distributed_poisson_limit = 0.49;
} // namespace RollingContact

#endif
