#ifndef rolling_contact_mesh_gap_lines_h
#define rolling_contact_mesh_gap_lines_h

#include <rolling_contact/mesh/zone_box.h>
#include <rolling_contact/surfaces/contact_frame.h>

#include <cmath>
#include <vector>

namespace RollingContact
{
  /**
   * The largest approach at which profiles are looked for a contact. Units: m.
   */
  constexpr double deepest_approach = 1e-3;

  /**
   * The least share of an approach that closes a gap, see ApproachShare:
   * steeper surfaces are beside the contact.
   */
  constexpr double least_approach_share = 0.05;

  /**
   * The gap along a line across the plane: its least value, where that is
   * and gap = least + curvature (x - place)^2.
   */
  struct GapLine
  {
    double y, least, place, curvature;
  };

  /** What share of an approach closes the gap at a place. */
  class ApproachShare
  {
  public:
    ApproachShare(const Profiles::ContactFrame &frame, const double load_angle)
      : frame(frame)
      , load_angle(load_angle)
    {}

    /** Whether approach and load have one direction with all normals. */
    bool is_one() const
    {
      return frame.kind() == Profiles::SurfaceKind::plane;
    }

    double operator()(const double s) const
    {
      return is_one() ? 1. : std::cos(frame.surface(s).angle + load_angle);
    }

  private:
    const Profiles::ContactFrame &frame;
    const double                  load_angle;
  };

  /**
   * Lines over the whole of the profiles, with gaps of up to a millimetre
   * along the approach.
   */
  std::vector<GapLine> lines_across(const Profiles::ContactFrame &frame,
                                    const ApproachShare          &share);

  /**
   * The rectangle around all places where the gap is below @p depth; lower
   * above upper if there is none.
   */
  ZoneBox overlap(const std::vector<GapLine> &lines, const double depth);
} // namespace RollingContact

#endif
