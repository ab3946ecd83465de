#ifndef rolling_contact_bodies_make_body_h
#define rolling_contact_bodies_make_body_h

#include <rolling_contact/bodies/elastic_body.h>
#include <rolling_contact/mesh/body_model.h>

namespace RollingContact
{
  /**
   * Mesh a body whose K is solved as @p solver says, direct or distributed. A
   * direct body keeps its factors if it @p recovers displacements away from the
   * contact. @p model_rank will hold the model of a distributed body.
   * Collective for a distributed body.
   */
  template <int dim>
  std::shared_ptr<ElasticBody<dim>>
  make_body(const BodySolver                        solver,
            const std::shared_ptr<const BodyShape> &shape,
            const Material                         &material,
            const double                            thickness,
            const Grading<dim>                     &grading,
            const bool                              recovers,
            const unsigned int                      model_rank,
            const BodyModel                        &model = {});

  /**
   * Estimated memory in bytes for factor and condensation of a direct body that
   * was not analysed, fitted to runs of bodies in 2D and 3D.
   */
  template <int dim>
  double direct_memory(const std::size_t n_unknowns);
} // namespace RollingContact

#endif
