#ifndef rolling_contact_bodies_half_space_influence_h
#define rolling_contact_bodies_half_space_influence_h

#include <rolling_contact/algebra/grid_compliance.h>
#include <rolling_contact/mesh/material.h>

#include <array>
#include <vector>

namespace RollingContact
{
  /**
   * How the plane surface of an elastic half-space answers to forces on the
   * nodes of equal elements: tractions are bilinear, so that a nodal force is
   * spread over the four elements around its node as a hat, and displacements
   * are those at the nodes. In closed form: the kernels 1/r, x^2/r^3, y^2/r^3,
   * xy/r^3, x/r^2, y/r^2 of point forces (Johnson 1985, 3.2, 3.6), integrated
   * twice along x and y, and the second differences of that. Axes of a body, z
   * out of it. Units: m, N.
   */
  class HalfSpaceInfluence
  {
  public:
    HalfSpaceInfluence(const Material              &material,
                       const std::array<double, 2> &element_size)
      : material(material)
      , size(element_size)
    {}

    /**
     * Displacement (row) at (x, y) from the node of a unit force (column).
     * Units: m to m/N.
     */
    Eigen::Matrix3d at(const double x, const double y) const;

    /**
     * The influence at distances of whole elements, so many along x and y, in
     * some components.
     */
    InfluenceTable table(const std::array<std::size_t, 2> &n,
                         const std::vector<unsigned int>  &components) const;

  private:
    const Material              material;
    const std::array<double, 2> size;
  };
} // namespace RollingContact

#endif
