#ifndef rolling_contact_modes_body_places_h
#define rolling_contact_modes_body_places_h

#include <rolling_contact/bodies/direct_body.h>

#include <array>
#include <vector>

namespace RollingContact
{
  /**
   * Where the unknowns of a body are, node by node, in its own frame (in 2D the
   * second coordinate is 0). Unknowns that belong to no place of the mesh, such
   * as masses attached to it, are left out. Units: m, kg.
   */
  struct BodyPlaces
  {
    struct Node
    {
      std::array<double, 3> point;
      std::array<int, 3>    unknowns{{-1, -1, -1}}; ///< -1: held
      double                mass = 0.;              ///< lumped
    };

    template <int dim>
    explicit BodyPlaces(const DirectBody<dim> &body);

    std::vector<Node> nodes;
  };
} // namespace RollingContact

#endif
