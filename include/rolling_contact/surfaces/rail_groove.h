#ifndef rolling_contact_surfaces_rail_groove_h
#define rolling_contact_surfaces_rail_groove_h

#include <rolling_contact/surfaces/profile_file.h>

#include <optional>
#include <string>
#include <vector>

namespace RollingContact::Profiles
{
  /**
   * The groove of a grooved rail, between the head and the keeper or check rail
   * beside it. Units: m.
   */
  struct RailGroove
  {
    double      depth;    ///< below the lower of head and keeper
    double      floor_y;  ///< of the deepest point
    std::size_t deepest;  ///< its number
    bool        is_right; ///< the head is on the side of larger y
  };

  /**
   * The groove of points along a section, in the order of ascending y, z down:
   * the deepest place between two parts that stand at least 15 mm above it, one
   * of them as wide as the head of a rail; none if there is no such place.
   */
  std::optional<RailGroove> groove_of(const std::vector<MeasuredPoint> &points);

  /**
   * Leave out what is beyond the floor of a rail's groove: wheels run on the
   * head, and the gauge face is that of the head. Throws InputError if the
   * keeper is on the field side, or the rail upside down; @p name is that of
   * messages.
   */
  void leave_out_keeper(std::vector<MeasuredPoint> &points,
                        const std::string          &name);
} // namespace RollingContact::Profiles

#endif
