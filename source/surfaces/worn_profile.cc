#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/surfaces/profile_measures.h>
#include <rolling_contact/surfaces/wear_deposit.h>
#include <rolling_contact/surfaces/worn_profile.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace RollingContact::Profiles
{
  namespace
  {
    using Numbers = std::vector<double>;

    // m: the curvature of layers is a mean, with a kernel that has no negative
    // values, nor its transform, so that steps as deep do not amplify waves
    const double width_of_mean = 1e-3;

    const double share_at_end = 1e-3; // of the largest depth

    [[noreturn]] void refuse(const ProfileKind  kind,
                             const CurvePoint  &place,
                             const std::string &what)
    {
      throw InputError(
        "Wear of the " +
        std::string(kind == ProfileKind::wheel ? "wheel" : "rail") +
        "'s profile at y = " + millimetres(place.y, 4) +
        ", z = " + millimetres(place.z, 4) + ": " + what);
    }

    double into_body(const ProfileKind kind)
    {
      return kind == ProfileKind::wheel ? -1. : 1.;
    }

    std::size_t previous(const std::size_t k)
    {
      return k == 0 ? 0 : k - 1;
    }

    std::size_t next(const Numbers &arc, const std::size_t k)
    {
      return std::min(k + 1, arc.size() - 1);
    }

    /** Derivatives at points, those of the parabola through three of them. */
    Numbers slopes(const Numbers &arc, const Numbers &values)
    {
      Numbers    found(arc.size());
      const auto secant = [&](const std::size_t a, const std::size_t b) {
        return (values[b] - values[a]) / (arc[b] - arc[a]);
      };
      for (std::size_t k = 0; k < arc.size(); ++k)
        {
          const std::size_t a = previous(k), b = next(arc, k);
          found[k] = a == k || b == k ? secant(a, b)
                                      : (secant(a, k) * (arc[b] - arc[k]) +
                                         secant(k, b) * (arc[k] - arc[a])) /
                                          (arc[b] - arc[a]);
        }
      return found;
    }

    /** The turn of the tangent at a point, over half of both segments. */
    double turn(const ProfileCurve &curve, const std::size_t k)
    {
      const auto &points = curve.points();
      return (points[next(curve.arc_lengths(), k)].angle -
              points[previous(k)].angle) /
             2;
    }

    /** Curvatures at points, means over width_of_mean. Units: m, 1/m. */
    Numbers mean_curvatures(const ProfileCurve &curve)
    {
      Numbers turns;
      for (std::size_t k = 0; k < curve.points().size(); ++k)
        turns.push_back(turn(curve, k));
      return depths_of(curve, smoothed(curve, turns, width_of_mean));
    }

    /** Throws InputError if points have overtaken each other. */
    void check_order(const ProfileCurve            &curve,
                     const std::vector<CurvePoint> &moved,
                     const ProfileKind              kind)
    {
      for (std::size_t k = 1; k < moved.size(); ++k)
        {
          const CurvePoint &a = curve.points()[k - 1], &b = curve.points()[k];
          const double along = (moved[k].y - moved[k - 1].y) * (b.y - a.y) +
                               (moved[k].z - moved[k - 1].z) * (b.z - a.z);
          if (!(along > 0.))
            refuse(kind,
                   b,
                   "it is deeper than the radius of curvature there, so that "
                   "points of the profile would run backwards. Take smaller "
                   "steps, or a profile without a corner there.");
        }
    }

    void check_ends(const ProfileCurve &curve,
                    const ProfileKind   kind,
                    const Numbers      &depths)
    {
      double largest = 0.;
      for (const double depth : depths)
        largest = std::max(largest, std::abs(depth));
      for (const bool at_front : {true, false})
        {
          const double depth = at_front ? depths.front() : depths.back();
          if (std::abs(depth) > share_at_end * largest)
            refuse(kind,
                   at_front ? curve.points().front() : curve.points().back(),
                   millimetres(depth) +
                     " wear at the end of the profile, beyond which the body "
                     "is not known. Give a profile that goes on there.");
        }
    }

    /**
     * Throws InputError if the curve crosses itself, or the tread's side of a
     * flange is behind the first point, which is on its back.
     */
    void check_worn_through(const ProfileCurve &curve, const ProfileKind kind)
    {
      std::vector<MeasuredPoint> points;
      for (const CurvePoint &point : curve.points())
        points.push_back({point.y, point.z});
      std::size_t place = points.size();
      if (const auto found = first_crossing(points))
        place = found->second;
      else if (kind == ProfileKind::wheel)
        {
          const auto tip = std::max_element(points.begin(),
                                            points.end(),
                                            [](const auto &a, const auto &b) {
                                              return a.z < b.z;
                                            });
          place          = std::find_if(tip,
                               points.end(),
                               [&](const MeasuredPoint &point) {
                                 return point.y < points.front().y;
                               }) -
                  points.begin();
        }
      if (place < points.size())
        refuse(kind,
               curve.points()[place],
               "the body is worn through there to its other side.");
    }

    /** Distances along the normals of layers with these depths. */
    Numbers layers(const ProfileCurve &curve,
                   const ProfileKind   kind,
                   const Numbers      &depths)
    {
      Numbers distances = mean_curvatures(curve);
      for (std::size_t k = 0; k < depths.size(); ++k)
        {
          // what is deeper than a layer can be runs backwards in any case
          const double square =
            1 - 2 * into_body(kind) * distances[k] * depths[k];
          distances[k] = 2 * depths[k] / (1 + std::sqrt(std::max(0., square)));
        }
      return distances;
    }
  } // namespace

  ProfileCurve subdivided(const ProfileCurve &curve, const double spacing)
  {
    if (!(spacing > 0.))
      throw std::invalid_argument(
        "Points of a profile need a spacing above 0.");
    const Numbers          &arc = curve.arc_lengths();
    std::vector<CurvePoint> points(1, curve.points().front());
    for (std::size_t k = 1; k < arc.size(); ++k)
      {
        const double length = arc[k] - arc[k - 1];
        // parts may be longer than the spacing by what is lost in rounding
        const double n = std::ceil(length / spacing - 1e-6);
        for (double part = 1; part < n; ++part)
          {
            CurvePoint point = curve.at(arc[k - 1] + length * part / n);
            // angles go on without jumps of a full turn
            point.angle =
              points.back().angle +
              std::remainder(point.angle - points.back().angle, 2 * pi);
            points.push_back(point);
          }
        points.push_back(curve.points()[k]);
      }
    return ProfileCurve(points);
  }

  ProfileCurve offset_into_body(const ProfileCurve        &curve,
                                const ProfileKind          kind,
                                const std::vector<double> &distances)
  {
    check_number_of_points(curve, distances);
    const Numbers          &arc  = curve.arc_lengths();
    const Numbers           rise = slopes(arc, distances);
    const double            side = into_body(kind);
    std::vector<CurvePoint> points(curve.points());
    for (std::size_t k = 0; k < points.size(); ++k)
      if (distances[k] != 0. || rise[k] != 0.)
        {
          CurvePoint  &point = points[k];
          const double by    = side * distances[k];
          point.y -= by * std::sin(point.angle);
          point.z += by * std::cos(point.angle);
          const double curvature =
            2 * turn(curve, k) / (arc[next(arc, k)] - arc[previous(k)]);
          point.angle += std::atan2(side * rise[k], 1 - by * curvature);
        }
    check_order(curve, points, kind);
    return ProfileCurve(points);
  }

  ProfileCurve worn(const ProfileCurve        &curve,
                    const ProfileKind          kind,
                    const std::vector<double> &amounts)
  {
    const Numbers depths = depths_of(curve, amounts);
    check_ends(curve, kind, depths);
    Numbers      distances = layers(curve, kind, depths);
    double       all       = 0.;
    const double total = std::accumulate(amounts.begin(), amounts.end(), 0.);
    for (const double amount : amounts)
      all += std::abs(amount);
    ProfileCurve found = offset_into_body(curve, kind, distances);
    // what adds up to nothing has no scale
    if (std::abs(total) > 1e-3 * all)
      for (unsigned int round = 0; round < 3; ++round)
        {
          const double scale = total / worn_area(curve, found, kind);
          for (double &distance : distances)
            distance *= scale;
          found = offset_into_body(curve, kind, distances);
        }
    if (all > 0.)
      check_worn_through(found, kind);
    return found;
  }
} // namespace RollingContact::Profiles
