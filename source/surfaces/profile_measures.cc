#include <boost/math/tools/roots.hpp>

#include <rolling_contact/base/constants.h>
#include <rolling_contact/surfaces/profile_measures.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

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
} // namespace RollingContact::Profiles
