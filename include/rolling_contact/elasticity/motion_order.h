#ifndef rolling_contact_elasticity_motion_order_h
#define rolling_contact_elasticity_motion_order_h

#include <deal.II/base/point.h>

#include <rolling_contact/elasticity/distributed_matrices.h>

#include <cstddef>
#include <vector>

namespace RollingContact
{
  /**
   * A component of a nodal value and where it is kept.
   */
  template <int dim>
  struct NodeValue
  {
    dealii::Point<dim> position;
    unsigned int       component;
    std::size_t        place;
  };

  /**
   * The places in the order of BodyMotion: by the node's position, then by
   * component. Vertices have the same coordinates to the last bit whatever the
   * number of ranks.
   */
  template <int dim>
  std::vector<std::size_t>
  in_motion_order(std::vector<NodeValue<dim>> values);

  /**
   * The degrees of freedom of this rank that are unknowns.
   */
  template <int dim>
  std::vector<dealii::types::global_dof_index>
  unknowns_here(const DistributedDiscretisation<dim> &body);

  /**
   * The unknowns of all ranks, numbered rank by rank, in the order of
   * BodyMotion: on the first rank or on all.
   */
  template <int dim>
  std::vector<std::size_t>
  motion_order(const DistributedDiscretisation<dim> &body,
               const bool                            on_all_ranks);
} // namespace RollingContact

#endif
