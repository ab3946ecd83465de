#ifndef rolling_contact_distributed_distributed_dof_order_h
#define rolling_contact_distributed_distributed_dof_order_h

#include <rolling_contact/distributed/distributed_matrices.h>

#include <cstddef>
#include <vector>

namespace RollingContact
{
  /**
   * The degrees of freedom of this rank that are unknowns.
   */
  template <int dim>
  std::vector<dealii::types::global_dof_index>
  unknowns_here(const DistributedDiscretisation<dim> &body);

  /**
   * The unknowns of all ranks, numbered rank by rank, in the order of
   * BodyMotion: on the first rank or on all. Collective.
   */
  template <int dim>
  std::vector<std::size_t>
  portable_dof_order(const DistributedDiscretisation<dim> &body,
                     const bool                            on_all_ranks);
} // namespace RollingContact

#endif
