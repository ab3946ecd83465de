#ifndef rolling_contact_distributed_make_body_h
#define rolling_contact_distributed_make_body_h

#include <rolling_contact/elasticity/elastic_body.h>
#include <rolling_contact/scene/body_parameters.h>

namespace RollingContact
{
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

  /**
   * Throws InputError for any other name than those of BodySolver.
   */
  BodySolver
  body_solver_of(const std::string &name);

  /**
   * A body whose K is solved as asked for, direct or distributed. @p recovers:
   * displacements away from the contact will be asked for. @p model_rank has
   * the approximate compliance of a distributed body.
   */
  template <int dim>
  std::shared_ptr<ElasticBody<dim>>
  make_body(const BodySolver      solver,
            const BodyParameters &parameters,
            const Grading<dim>   &grading,
            const bool            recovers,
            const unsigned int    model_rank);

  /**
   * Bytes that factor and condensation of a body of this many unknowns need,
   * from runs of bodies in 2D and 3D; for bodies not analysed yet.
   */
  template <int dim>
  double
  direct_memory(const std::size_t n_unknowns);
} // namespace RollingContact

#endif
