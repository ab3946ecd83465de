#ifndef rolling_contact_scene_velocity_points_h
#define rolling_contact_scene_velocity_points_h

#include <array>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * A named point of a body whose velocity a transient run records. Of a wheel
   * @p place is the radius from the axle (m), the angle from the contact
   * (degrees, positive towards +x) and the position along the axle from the
   * contact (m, positive towards +y); of a rail x, y and z from the contact
   * (m), z upwards.
   */
  struct VelocityPoint
  {
    std::string           name;
    std::array<double, 3> place;
  };

  /**
   * The points of an entry, "name: a, b, c; name: a, b, c", of the body of this
   * @p section, `Wheel` or `Rail`. Throws InputError that names the entry where
   * a name or a number is missing or not allowed, or a name comes twice, and in
   * 2D where the point is not in the plane.
   */
  std::vector<VelocityPoint> read_velocity_points(const std::string &section,
                                                  const std::string &text,
                                                  const unsigned int dimension);

  /**
   * The column of history.csv with the velocity of a point along an axis, 'x',
   * 'y' or 'z'.
   */
  std::string velocity_column(const std::string &point, const char axis);
} // namespace RollingContact

#endif
