#include <rolling_contact/base/constants.h>
#include <rolling_contact/surfaces/nominal_profiles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace RollingContact::Profiles
{
  namespace
  {
    const double spacing = 0.2; // of points, mm

    /**
     * A zone of a wheel profile: a polynomial in y, or an arc of a circle. In
     * mm.
     */
    struct Zone
    {
      double              begin, end;
      std::vector<double> polynomial; ///< lowest power first; empty for an arc
      double              centre_y = 0., centre_z = 0., radius = 0.;
      int                 side = 0; ///< 1: z above the centre's, -1: below it

      CurvePoint at(const double y) const
      {
        double z = 0., slope = 0.;
        for (std::size_t k = polynomial.size(); k-- > 0;)
          {
            slope = slope * y + z;
            z     = z * y + polynomial[k];
          }
        if (polynomial.empty())
          {
            const double t    = y - centre_y,
                         half = std::sqrt(radius * radius - t * t);
            z                 = centre_z + side * half;
            slope             = -side * t / half;
          }
        return {mm * y, mm * z, std::atan(slope)};
      }
    };

    // EN 13715, from the flange's back to the field side
    const std::array<Zone, 8> s1002_zones{
      {{-70., -62.764705882, {}, -49.5, 9.519259302, 20.5, 1},
       {-62.764705882, -49.662510381, {}, -55., 16., 12., 1},
       {-49.662510381, -39.764473993, {}, -58.558326413, 8.834924130, 20., 1},
       {-39.764473993, -38.426669071, {-93.576667419, -2.747477419}},
       {-38.426669071, -35., {}, -26.210665, 16.446, 13., -1},
       {-35.,
        -26.,
        {-4.320221063e3,
         -1.038384026e3,
         -1.065501873e2,
         -6.051367875,
         -2.054332446e-1,
         -4.169739389e-3,
         -4.687195829e-5,
         -2.252755540e-7}},
       {-26.,
        32.15796,
        {0.,
         -3.358537058e-2,
         1.565681624e-3,
         -2.810427944e-5,
         5.844240864e-8,
         -1.562379023e-8,
         5.309217349e-15,
         -5.957839843e-12,
         2.646656573e-13}},
       {32.15796, 60., {1.364323640, -0.066666667}}}};

    /**
     * Points of a zone, the steeper the closer, without the last.
     */
    void add_zone(const Zone &zone, std::vector<CurvePoint> &points)
    {
      // the back of the flange is vertical
      const double begin =
        zone.begin + (zone.at(zone.begin).angle == M_PI / 2 ? 1e-6 : 0.);
      for (double y = begin; y < zone.end - 1e-9;)
        {
          points.push_back(zone.at(y));
          y += spacing * std::max(0.02, std::cos(points.back().angle));
        }
    }

    const double lowest = 40.; // of a rail's head, mm

    /**
     * The head of a rail: tangent arcs from the crown outwards, the places
     * where each meets the next, and sides. In mm.
     */
    struct Head
    {
      std::string         name;
      std::vector<double> radii, joints; ///< joints: |y|
      double              side_slope;    ///< growth of |y| over z
    };

    const std::vector<Head> &heads()
    {
      // EN 13674-1, which gives twice the joints; 54E1 to 49E1 have the head
      // of UIC 54, DIN S54 and DIN S49
      static const std::vector<Head> all{
        {"60E1", {300., 80., 13.}, {20.456 / 2, 52.053 / 2}, 1. / 20},
        {"60E2",
         {200., 70., 16., 8.},
         {23.778 / 2, 48.913 / 2, 70.774 / 2},
         1. / 20},
        {"54E1", {300., 80., 13.}, {20.024 / 2, 49.727 / 2}, 1. / 20},
        {"54E3", {300., 80., 13.}, {15.267 / 2, 46.835 / 2}, 1. / 17.2},
        {"49E1", {300., 80., 13.}, {15.267 / 2, 46.835 / 2}, 1. / 17.2},
        {"60E1 Manchester", {300., 80., 13.}, {10.50058, 25.98807}, 1. / 20}};
      return all;
    }

    /**
     * Points of the field side of a head. In m.
     */
    std::vector<CurvePoint> half_head(const Head &head)
    {
      std::vector<CurvePoint> points;
      double centre_y = 0., centre_z = head.radii[0], begin = 0.;
      for (std::size_t arc = 0; arc < head.radii.size(); ++arc)
        {
          const double radius = head.radii[arc];
          if (arc > 0) // the centre moves along the common normal
            {
              const double change = head.radii[arc - 1] - radius;
              centre_y += change * std::sin(begin);
              centre_z -= change * std::cos(begin);
            }
          const double end =
            arc < head.joints.size()
              ? std::asin((head.joints[arc] - centre_y) / radius)
              : M_PI / 2 - std::atan(head.side_slope);
          const int n = std::ceil((end - begin) * radius / spacing);
          for (int k = arc == 0 ? 0 : 1; k <= n; ++k)
            {
              const double angle = begin + (end - begin) * k / n;
              points.push_back({mm * (centre_y + radius * std::sin(angle)),
                                mm * (centre_z - radius * std::cos(angle)),
                                angle});
            }
          begin = end;
        }
      const CurvePoint last = points.back();
      points.push_back({last.y + (mm * lowest - last.z) / std::tan(last.angle),
                        mm * lowest,
                        last.angle});
      return points;
    }
  } // namespace

  ProfileCurve s1002()
  {
    std::vector<CurvePoint> points;
    for (const Zone &zone : s1002_zones)
      add_zone(zone, points);
    points.push_back(s1002_zones.back().at(s1002_zones.back().end));
    return ProfileCurve(points);
  }

  std::vector<std::string> rail_names()
  {
    std::vector<std::string> names;
    for (const Head &head : heads())
      names.push_back(head.name);
    return names;
  }

  ProfileCurve rail_head(const std::string &name)
  {
    const auto head =
      std::find_if(heads().begin(), heads().end(), [&](const Head &it) {
        return it.name == name;
      });
    if (head == heads().end())
      throw std::invalid_argument("No rail is called " + name + ".");
    const std::vector<CurvePoint> half = half_head(*head);
    std::vector<CurvePoint>       points;
    for (std::size_t k = half.size(); k-- > 1;)
      points.push_back({-half[k].y, half[k].z, -half[k].angle});
    points.insert(points.end(), half.begin(), half.end());
    return ProfileCurve(points);
  }
} // namespace RollingContact::Profiles
