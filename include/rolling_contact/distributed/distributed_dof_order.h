#ifndef rolling_contact_distributed_distributed_dof_order_h
#define rolling_contact_distributed_distributed_dof_order_h

#include <rolling_contact/distributed/distributed_matrices.h>

#include <cstddef>
#include <vector>

namespace RollingContact
{
  /**
   * Degrees of freedom that this rank owns and that are not constrained. Not
   * collective.
   */
  template <int dim>
  std::vector<dealii::types::global_dof_index>
  unknowns_here(const DistributedDiscretisation<dim> &body);

  /**
   * The order of BodyMotion, which does not depend on the number of ranks: with
   * the unknowns_here() of all ranks counted rank by rank, entry k is the
   * number of the unknown that stands at place k. Result: on all ranks, or only
   * on the first one and empty on others. Collective.
   */
  template <int dim>
  std::vector<std::size_t>
  portable_dof_order(const DistributedDiscretisation<dim> &body,
                     const bool                            on_all_ranks);
} // namespace RollingContact

#endif
