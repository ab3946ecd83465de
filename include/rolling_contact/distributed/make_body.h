#ifndef rolling_contact_distributed_make_body_h
#define rolling_contact_distributed_make_body_h

#include <rolling_contact/distributed/body_solver.h>
#include <rolling_contact/elasticity/elastic_body.h>

namespace RollingContact
{
  /**
   * A body whose K is solved as asked for, direct or distributed. @p recovers:
   * displacements away from the contact will be asked for. @p model_rank has
   * the approximate compliance of a distributed body.
   */
  template <int dim>
  std::shared_ptr<ElasticBody<dim>>
  make_body(const BodySolver                        solver,
            const std::shared_ptr<const BodyShape> &shape,
            const Material                         &material,
            const double                            thickness,
            const Grading<dim>                     &grading,
            const bool                              recovers,
            const unsigned int                      model_rank);

  /**
   * Bytes that factor and condensation of a body of this many unknowns need,
   * from runs of bodies in 2D and 3D; for bodies not analysed yet.
   */
  template <int dim>
  double
  direct_memory(const std::size_t n_unknowns);
} // namespace RollingContact

#endif
