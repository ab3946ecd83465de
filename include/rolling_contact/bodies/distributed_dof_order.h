#ifndef rolling_contact_bodies_distributed_dof_order_h
#define rolling_contact_bodies_distributed_dof_order_h

#include <rolling_contact/bodies/body_motion.h>
#include <rolling_contact/bodies/distributed_matrices.h>

#include <utility>

namespace RollingContact
{
  /**
   * Displacement and velocity of all ranks in the order of BodyMotion, which
   * does not depend on their number; on the first rank, empty on others.
   * Collective.
   */
  template <int dim>
  BodyMotion in_portable_order(const DistributedDiscretisation<dim> &body,
                               const DistributedVector &displacement,
                               const DistributedVector &velocity);

  /**
   * Displacement and velocity of a motion that is the same on all ranks.
   * Collective.
   */
  template <int dim>
  std::pair<DistributedVector, DistributedVector>
  from_portable_order(const DistributedDiscretisation<dim> &body,
                      const BodyMotion                     &motion);
} // namespace RollingContact

#endif
