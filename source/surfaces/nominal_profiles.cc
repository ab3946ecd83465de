#include <rolling_contact/base/constants.h>
#include <rolling_contact/surfaces/nominal_profiles.h>

#include <array>
#include <cmath>

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

    const double side_slope = 1. / 20, lowest = 40.; // of a rail's head, mm

    /**
     * The field side of a head: tangent arcs, then the side. In mm.
     */
    std::vector<CurvePoint> half_head(const double first_joint,
                                      const double second_joint)
    {
      struct Arc
      {
        double radius, y, z, begin, end;
      };
      const std::array<double, 3> radii{{300., 80., 13.}};
      const double                a1 = std::asin(first_joint / radii[0]);
      Arc                         arcs[3];
      arcs[0]         = {radii[0], 0., radii[0], 0., a1};
      const auto next = [](const Arc &arc, const double radius) {
        const double change = arc.radius - radius;
        return Arc{radius,
                   arc.y + change * std::sin(arc.end),
                   arc.z - change * std::cos(arc.end),
                   arc.end,
                   0.};
      };
      arcs[1]     = next(arcs[0], radii[1]);
      arcs[1].end = std::asin((second_joint - arcs[1].y) / radii[1]);
      arcs[2]     = next(arcs[1], radii[2]);
      arcs[2].end = M_PI / 2 - std::atan(side_slope);

      std::vector<CurvePoint> points;
      for (const Arc &arc : arcs)
        {
          const int n = std::ceil((arc.end - arc.begin) * arc.radius / spacing);
          for (int k = 0; k < n; ++k)
            {
              const double angle = arc.begin + (arc.end - arc.begin) * k / n;
              points.push_back({mm * (arc.y + arc.radius * std::sin(angle)),
                                mm * (arc.z - arc.radius * std::cos(angle)),
                                angle});
            }
        }
      const double angle = arcs[2].end;
      const double y     = arcs[2].y + radii[2] * std::sin(angle),
                   z     = arcs[2].z - radii[2] * std::cos(angle);
      points.push_back({mm * y, mm * z, angle});
      points.push_back(
        {mm * (y + (lowest - z) / std::tan(angle)), mm * lowest, angle});
      return points;
    }

    ProfileCurve head(const double first_joint, const double second_joint)
    {
      const std::vector<CurvePoint> half = half_head(first_joint, second_joint);
      std::vector<CurvePoint>       points;
      for (std::size_t k = half.size(); k-- > 1;)
        points.push_back({-half[k].y, half[k].z, -half[k].angle});
      points.insert(points.end(), half.begin(), half.end());
      return ProfileCurve(points);
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

  ProfileCurve rail_60e1()
  {
    return head(10.228, 26.0265);
  }

  ProfileCurve rail_60e1_manchester()
  {
    return head(10.50058, 25.98807);
  }
} // namespace RollingContact::Profiles
