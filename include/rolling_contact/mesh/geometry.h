#ifndef rolling_contact_mesh_geometry_h
#define rolling_contact_mesh_geometry_h

#include <memory>

namespace RollingContact
{
  /**
   * Depth of a circular profile below its crown at distance @p x from it,
   * x^2 / (R + sqrt(R^2 - x^2)); R = 0 is flat, R < 0 concave. Beyond |R|/2 the
   * profile goes on along its tangent. Units: m.
   */
  double
  crown_depth(const double radius, const double x);

  enum class Shape
  {
    disc,
    block,
    mesh_file
  };

  struct FileMesh;

  /**
   * Geometry of one body in its own frame: the contact point is the origin, z
   * points out of the body. The program builds or reads every body this way;
   * the wheel is its mirror image in z. Units: m.
   */
  struct BodyGeometry
  {
    Shape  shape          = Shape::disc;
    bool   rigid          = false;
    double radius         = 0.;   ///< in the rolling direction; 0 flat
    double lateral_radius = 0.;   ///< across; 0 flat
    double hub_radius     = 0.;   ///< of the inner circle of a disc
    double length         = 0.;   ///< of a block, in the rolling direction
    double depth          = 0.;   ///< of a block, down to its bottom, the hub
    double width          = 0.;   ///< across, 3D only
    bool   hub_clamped    = true; ///< otherwise nothing holds the body

    std::shared_ptr<const FileMesh> mesh; ///< of a mesh file

    /**
     * Thickness of material under the contact point.
     */
    double
    thickness_below() const
    {
      return shape == Shape::disc ? radius - hub_radius : depth;
    }

    /**
     * Height of the undeformed surface at (@p x, @p y), 0 at the contact point
     * and negative where the surface falls away.
     */
    double
    surface_height(const double x, const double y) const
    {
      return -crown_depth(radius, x) - crown_depth(lateral_radius, y);
    }

    bool
    operator==(const BodyGeometry &other) const;
  };
} // namespace RollingContact

#endif
