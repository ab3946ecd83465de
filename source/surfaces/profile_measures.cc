#include <boost/math/tools/roots.hpp>

#include <rolling_contact/base/constants.h>
#include <rolling_contact/surfaces/profile_measures.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace RollingContact::Profiles
{
  namespace
  {
    // m: levels of the measures
    const double below_tread = 10e-3, above_tip = 2e-3;

    const double steep = 80. / 180 * pi; // the back of a flange

    /**
     * The first place from an arc length on at which the curve is no deeper
     * than z any more; nothing if there is none.
     */
    std::optional<CurvePoint>
    rise_to(const ProfileCurve &curve, const double from, const double z)
    {
      const auto &arc    = curve.arc_lengths();
      const auto  excess = [&](const double s) { return curve.at(s).z - z; };
      double      begin  = from;
      for (auto k = std::upper_bound(arc.begin(), arc.end(), from);
           k != arc.end();
           begin = *k++)
        if (excess(*k) <= 0.)
          {
            std::uintmax_t rounds = 100;
            const auto     found  = boost::math::tools::toms748_solve(
              excess,
              begin,
              *k,
              boost::math::tools::eps_tolerance<double>(),
              rounds);
            return curve.at((found.first + found.second) / 2);
          }
      return {};
    }

    double back_of_flange(const ProfileCurve &wheel, const double otherwise)
    {
      const auto &points = wheel.points();
      if (std::abs(points.front().angle) < steep)
        return otherwise;
      return std::min_element(points.begin(),
                              points.end(),
                              [](const CurvePoint &a, const CurvePoint &b) {
                                return a.y < b.y;
                              })
        ->y;
    }

    /** 1/2 integral (y dz - z dy) about a point, along a curve. */
    double swept(const ProfileCurve &curve, const CurvePoint &about)
    {
      const double                                   far = std::sqrt(0.6) / 2;
      const std::array<std::pair<double, double>, 3> gauss{
        {{0.5 - far, 5. / 18}, {0.5, 8. / 18}, {0.5 + far, 5. / 18}}};
      const auto &arc = curve.arc_lengths();
      double      sum = 0.;
      for (std::size_t k = 1; k < arc.size(); ++k)
        for (const auto &[place, weight] : gauss)
          {
            const double length = arc[k] - arc[k - 1];
            const auto   at = curve.derivatives(arc[k - 1] + place * length);
            sum += weight * length / 2 *
                   ((at.y - about.y) * at.dz - (at.z - about.z) * at.dy);
          }
      return sum;
    }

    /** The share of swept() of a straight line. */
    double
    swept(const CurvePoint &from, const CurvePoint &to, const CurvePoint &about)
    {
      return ((from.y - about.y) * (to.z - about.z) -
              (from.z - about.z) * (to.y - about.y)) /
             2;
    }

    /**
     * The least distance from a point at which the line along its normal meets
     * a curve, with its sign, positive downwards from the curve; nothing if it
     * does not.
     */
    std::optional<double> distance_along_normal(const CurvePoint   &from,
                                                const ProfileCurve &to)
    {
      const double cosine = std::cos(from.angle), sine = std::sin(from.angle);
      const auto   along = [&](const auto &point) {
        return cosine * (point.y - from.y) + sine * (point.z - from.z);
      };
      const auto           &points = to.points();
      const auto           &arc    = to.arc_lengths();
      std::optional<double> least;
      double                last = along(points[0]);
      for (std::size_t k = 1; k < points.size(); ++k)
        {
          const double next = along(points[k]);
          if ((last <= 0.) != (next <= 0.))
            {
              const auto at = to.derivatives(
                arc[k - 1] + (arc[k] - arc[k - 1]) * last / (last - next));
              const double distance =
                cosine * (at.z - from.z) - sine * (at.y - from.y);
              if (!least || std::abs(distance) < std::abs(*least))
                least = distance;
            }
          last = next;
        }
      return least;
    }
  } // namespace

  std::optional<FlangeMeasures> flange_measures(const ProfileCurve &wheel,
                                                const double        flange_back)
  {
    const ArcLengthAtY place(wheel);
    if (!place.covers(0.))
      return {};
    const double tread = wheel.at(place(0.)).z;
    // turned by a half turn the lowest point is the highest
    const double tip    = wheel.turned(pi).highest();
    const double lowest = wheel.at(tip).z;
    if (tip == 0. || wheel.at(tip).y > 0. ||
        lowest - tread < below_tread + above_tip)
      return {};
    const auto near_tip = rise_to(wheel, tip, lowest - above_tip),
               flank    = rise_to(wheel, tip, tread + below_tread);
    if (!near_tip || !flank)
      return {};
    return FlangeMeasures{lowest - tread,
                          flank->y - back_of_flange(wheel, flange_back),
                          flank->y - near_tip->y};
  }

  double worn_area(const ProfileCurve &before,
                   const ProfileCurve &after,
                   const ProfileKind   kind)
  {
    const CurvePoint &about = before.points().front();
    const double      area =
      swept(before, about) +
      swept(before.points().back(), after.points().back(), about) -
      swept(after, about) + swept(after.points().front(), about, about);
    return kind == ProfileKind::wheel ? -area : area;
  }

  WornDepth largest_worn_depth(const ProfileCurve &before,
                               const ProfileCurve &after,
                               const ProfileKind   kind)
  {
    const double side = kind == ProfileKind::wheel ? -1. : 1.;
    WornDepth    found{0., 0.};
    for (std::size_t k = 0; k < before.points().size(); ++k)
      if (const auto distance =
            distance_along_normal(before.points()[k], after))
        if (side * *distance > found.depth)
          found = {side * *distance, before.arc_lengths()[k]};
    return found;
  }
} // namespace RollingContact::Profiles
