#ifndef rolling_contact_modes_node_rings_h
#define rolling_contact_modes_node_rings_h

#include <rolling_contact/base/constants.h>
#include <rolling_contact/mesh/body_shape.h>
#include <rolling_contact/modes/body_places.h>

#include <vector>

namespace RollingContact
{
  /**
   * Where a point is round an axle: unit vectors along the axle, away from it
   * and around it, and its cylindrical coordinates. The angle is 0 at the top
   * of z and grows along @p around. Units: m, rad.
   */
  struct CylindricalPlace
  {
    CylindricalPlace(const Axle &axle, const std::array<double, 3> &point);

    std::array<double, 3> along, outwards, around;
    double                axial = 0., radius = 0., angle = 0.;
  };

  /**
   * Nodes of a body on a circle round its axle, by angle, with the weights of
   * the trapezoidal rule for means over the circle.
   */
  struct NodeRing
  {
    struct Node
    {
      const BodyPlaces::Node *node;
      CylindricalPlace        place;
      double                  weight; ///< of the circle, their sum is 1
    };

    /**
     * Sort the nodes, find weights and the widest gap between neighbours.
     */
    void close();

    std::vector<Node> nodes;
    double            mass = 0.;     ///< of all nodes, kg
    double            gap  = 2 * pi; ///< rad
  };

  /// widest gap of a ring between nodes that Fourier series are taken from
  const double widest_ring_gap = 0.8; // rad

  /**
   * All circles of nodes that go the whole way round, without a gap wider than
   * widest_ring_gap. Keeps pointers into @p places.
   */
  std::vector<NodeRing> node_rings(const BodyPlaces &places, const Axle &axle);
} // namespace RollingContact

#endif
