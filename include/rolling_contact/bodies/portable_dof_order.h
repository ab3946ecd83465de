#ifndef rolling_contact_bodies_portable_dof_order_h
#define rolling_contact_bodies_portable_dof_order_h

#include <deal.II/base/point.h>

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
   * The places of nodal values in the order of BodyMotion: by the node's
   * position, then by component. Vertices have the same coordinates to the last
   * bit whatever the number of ranks.
   */
  template <int dim>
  std::vector<std::size_t>
  in_portable_order(std::vector<NodeValue<dim>> values);
} // namespace RollingContact

#endif
