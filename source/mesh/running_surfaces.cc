#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/mesh/running_surfaces.h>
#include <rolling_contact/mesh/wheel_section_mesh.h>
#include <rolling_contact/surfaces/rail_section.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  using Profiles::Outline;
  using Profiles::ProfileCurve;
  using Profiles::rail_60e1_height;

  namespace
  {

    /// how far the ends of a profile may be from the head of a 60E1
    const double largest_misfit = 6 * mm;

    /// where the strip begins, on the back side of the flange's tip
    const Outline::Point tip_place{{-61.5 * mm, 26 * mm}};

    /// a wheel's profile must reach so far towards its back
    const double back_of_core = -60 * mm;

    /**
     * From an end of the profile along the head of a 60E1 to its lower corner,
     * (across, down), @p side -1 on the gauge side.
     */
    std::vector<Outline::Point> line_to_lower_corner(const Outline::Point &end,
                                                     const double          side)
    {
      const Outline half = Profiles::half_section_60e1();
      const double last = half.nearest(Profiles::landmarks_60e1().lower_corner);
      const Outline::Point there{{side * end[0], rail_60e1_height - end[1]}};
      const double         nearest = half.nearest(there);
      const auto           on      = half.at(nearest);
      const double misfit = std::hypot(on[0] - there[0], on[1] - there[1]);
      if (misfit > largest_misfit)
        throw InputError(
          "Profiles/Body sections = true: the rail's profile ends " +
          significant(misfit, 3) +
          " m from the head of a 60E1 in its place, whose web and foot it would "
          "have; take Body sections = plain.");
      const double skip = misfit < 1e-2 * mm ? 0. : 2 * mm + misfit;
      std::vector<Outline::Point> line{end};
      if (nearest + skip >= last)
        return line;
      const Outline rest = half.part(nearest + skip, last);
      for (const auto &point : rest.points())
        line.push_back({{side * point[0], rail_60e1_height - point[1]}});
      return line;
    }
  } // namespace

  RunningSurface rail_surface(const PlacedProfile &placed)
  {
    const auto  &profile = placed.profile;
    const double lowest =
      rail_60e1_height - Profiles::landmarks_60e1().side_end[1];
    std::array<double, 2> ends{{0., profile.length()}};
    const double          top = profile.highest();
    for (unsigned int side = 0; side < 2; ++side)
      if (profile.at(ends[side]).z > lowest)
        {
          double above = top, below = ends[side];
          for (unsigned int round = 0; round < 60; ++round)
            {
              const double middle = (above + below) / 2;
              (profile.at(middle).z > lowest ? below : above) = middle;
            }
          ends[side] = (above + below) / 2;
        }
    const auto end = [&](const unsigned int side) {
      const auto point = profile.at(ends[side]);
      return Outline::Point{{point.y, point.z}};
    };
    return {placed,
            ends,
            line_to_lower_corner(end(0), -1.),
            line_to_lower_corner(end(1), 1.)};
  }

  double flange_tip(const ProfileCurve &profile)
  {
    const auto &points = profile.points();
    const auto  away   = [](const auto &point) {
      return std::hypot(point.y - tip_place[0], point.z - tip_place[1]);
    };
    const auto nearest = std::min_element(points.begin(),
                                          points.end(),
                                          [&](const auto &p, const auto &q) {
                                            return away(p) < away(q);
                                          });
    return profile.arc_lengths()[nearest - points.begin()];
  }

  RunningSurface wheel_surface(const PlacedProfile &placed)
  {
    const ProfileCurve &profile = placed.profile;
    const double        tip     = flange_tip(profile);
    const auto   begin = profile.at(0.), end = profile.at(profile.length());
    const double least_back = 2 * mm;
    if (!(tip > least_back && begin.y < back_of_core))
      throw InputError(
        "Profiles/Body sections = true: the wheel's profile ends at y = " +
        significant(begin.y, 3) +
        " m, before the back of its flange; a wheel with its flange needs "
        "points over the tip, or take Body sections = plain.");
    if (!(end.y > 0.03 && end.y < WheelMeasures::hub_end))
      throw InputError(
        "Profiles/Body sections = true: the wheel's profile ends at y = " +
        significant(end.y, 3) +
        " m on the field side; a rim ends between 0.03 and 0.08 m. Take Body "
        "sections = plain.");
    return {placed,
            {{tip, profile.length()}},
            {},
            {{{end.y, end.z}},
             {{end.y + WheelMeasures::chamfer,
               end.z - WheelMeasures::chamfer}}}};
  }
} // namespace RollingContact
