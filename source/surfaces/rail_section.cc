#include <rolling_contact/base/constants.h>
#include <rolling_contact/surfaces/rail_section.h>

#include <cmath>

namespace RollingContact::Profiles
{
  namespace
  {
    using Point = Outline::Point;

    const double arc_spacing = 0.25; // mm, of points on arcs

    /// all in mm; slopes are those of the drawing
    const double underside_slope = 1 / 2.75, toe_slope = 1. / 14,
                 head_slope     = 1. / 20;
    const double head_underside = 121., foot_top = 31.5, toe_top = 11.5,
                 half_foot = 75., half_web = 8.25;
    const double web_radius = 120., fillet_radius = 35., inner_radius = 7.,
                 head_corner = 3., foot_radius = 40., toe_radius = 4.,
                 sole_corner = 2.;

    /// fitted: where the web begins to widen, and by which angle
    const double upper_web = 92.37, upper_angle = 0.22187, lower_web = 60.40,
                 lower_angle = 0.23609;

    /// of the head: joints of its arcs
    const double first_joint = 10.228, second_joint = 26.0265;

    Point plus(const Point &a, const double t, const Point &direction)
    {
      return {{a[0] + t * direction[0], a[1] + t * direction[1]}};
    }

    double angle_of(const Point &point, const Point &centre)
    {
      const double angle =
        std::atan2(point[1] - centre[1], point[0] - centre[0]);
      return angle < -1e-9 ? angle + 2 * M_PI : angle;
    }

    void add_arc(const Point        &centre,
                 const double        radius,
                 const double        begin,
                 const double        end,
                 std::vector<Point> &points)
    {
      const int n =
        std::max(2., std::ceil(std::abs(end - begin) * radius / arc_spacing));
      for (int k = 0; k <= n; ++k)
        {
          const double angle = begin + (end - begin) * k / n;
          points.push_back({{centre[0] + radius * std::cos(angle),
                             centre[1] + radius * std::sin(angle)}});
        }
    }

    /**
     * The centre that lies at these distances along their normals from two
     * lines, each given by a point on it.
     */
    Point centre_between(const Point &normal_1,
                         const Point &on_1,
                         const Point &normal_2,
                         const Point &on_2,
                         const double radius)
    {
      const double b1 = normal_1[0] * on_1[0] + normal_1[1] * on_1[1] + radius,
                   b2 = normal_2[0] * on_2[0] + normal_2[1] * on_2[1] + radius,
                   determinant =
                     normal_1[0] * normal_2[1] - normal_1[1] * normal_2[0];
      return {{(b1 * normal_2[1] - b2 * normal_1[1]) / determinant,
               (normal_1[0] * b2 - normal_2[0] * b1) / determinant}};
    }

    /** The head down to its lower corner. */
    struct HeadOutline
    {
      std::vector<Point> points;
      Point              side_end, lower_corner, underside;
    };

    HeadOutline head()
    {
      HeadOutline  head;
      const double a1 = std::asin(first_joint / 300),
                   a3 = M_PI / 2 - std::atan(head_slope);
      const Point c1{{0., rail_60e1_height / mm - 300}},
        c2            = plus(c1, 220., {{std::sin(a1), std::cos(a1)}});
      const double a2 = std::asin((second_joint - c2[0]) / 80);
      const Point  c3 = plus(c2, 67., {{std::sin(a2), std::cos(a2)}});
      add_arc(c1, 300., M_PI / 2, M_PI / 2 - a1, head.points);
      add_arc(c2, 80., M_PI / 2 - a1, M_PI / 2 - a2, head.points);
      add_arc(c3, 13., M_PI / 2 - a2, M_PI / 2 - a3, head.points);

      const double slope = std::atan(underside_slope);
      const Point  into_side{
        {-std::cos(std::atan(head_slope)), -std::sin(std::atan(head_slope))}},
        into_underside{{-std::sin(slope), std::cos(slope)}};
      const Point centre = centre_between(into_side,
                                          head.points.back(),
                                          into_underside,
                                          {{0., head_underside}},
                                          head_corner);
      head.side_end      = plus(centre, -head_corner, into_side);
      head.underside     = plus(centre, -head_corner, into_underside);
      const double begin = std::atan2(-into_side[1], -into_side[0]),
                   end   = std::atan2(-into_underside[1], -into_underside[0]);
      head.lower_corner =
        plus(centre,
             head_corner,
             {{std::cos((begin + end) / 2), std::sin((begin + end) / 2)}});
      add_arc(centre, head_corner, begin, end, head.points);
      return head;
    }

    /**
     * From the web to a sloping line: arcs of 120, 35 and 7 mm, from the web
     * outwards, with @p way 1 upwards and -1 downwards.
     */
    std::vector<Point> fillet(const double web_end,
                              const double way,
                              const double angle,
                              const double line_height)
    {
      const double slope = std::atan(underside_slope);
      const Point  c120{{half_web + web_radius, web_end}},
        towards{{-std::cos(angle), way * std::sin(angle)}},
        on_120 = plus(c120, web_radius, towards),
        c35    = plus(c120, web_radius - fillet_radius, towards);
      // the centre of the arc of 7 mm: 28 mm from that of 35 mm, 7 mm from the
      // line on its open side
      const Point open{{std::sin(slope), -way * std::cos(slope)}},
        along{{std::cos(slope), way * std::sin(slope)}};
      const Point  start = plus({{0., line_height}}, inner_radius, open);
      const double dx = start[0] - c35[0], dy = start[1] - c35[1],
                   b = dx * along[0] + dy * along[1],
                   d = fillet_radius - inner_radius,
                   t = -b - std::sqrt(b * b - (dx * dx + dy * dy - d * d));
      const Point c7 = plus(start, t, along),
                  joint{{c35[0] + (c7[0] - c35[0]) * fillet_radius / d,
                         c35[1] + (c7[1] - c35[1]) * fillet_radius / d}},
                  on_line = plus(c7, -inner_radius, open);
      std::vector<Point> points;
      add_arc(c120, web_radius, M_PI, angle_of(on_120, c120), points);
      add_arc(c35,
              fillet_radius,
              angle_of(on_120, c35),
              angle_of(joint, c35),
              points);
      add_arc(
        c7, inner_radius, angle_of(joint, c7), angle_of(on_line, c7), points);
      return points;
    }

    void add_foot(std::vector<Point> &points)
    {
      const double steep = std::atan(underside_slope),
                   flat  = std::atan(toe_slope);
      const Point up_steep{{std::sin(steep), std::cos(steep)}},
        up_flat{{std::sin(flat), std::cos(flat)}};
      const Point toe_line{{half_foot, toe_top}};
      const Point blend = centre_between(
        up_steep, {{0., foot_top}}, up_flat, toe_line, foot_radius);
      add_arc(blend, foot_radius, -M_PI / 2 - steep, -M_PI / 2 - flat, points);
      Point toe{{half_foot - toe_radius, 0.}};
      toe[1] = (up_flat[0] * toe_line[0] + up_flat[1] * toe_line[1] -
                toe_radius - up_flat[0] * toe[0]) /
               up_flat[1];
      add_arc(toe, toe_radius, M_PI / 2 - flat, 0., points);
      add_arc({{half_foot - sole_corner, sole_corner}},
              sole_corner,
              0.,
              -M_PI / 2,
              points);
      points.push_back({{0., 0.}});
    }
  } // namespace

  Outline half_section_60e1()
  {
    std::vector<Point> points = head().points;
    const auto upper = fillet(upper_web, 1., upper_angle, head_underside),
               lower = fillet(lower_web, -1., lower_angle, foot_top);
    points.insert(points.end(), upper.rbegin(), upper.rend());
    points.insert(points.end(), lower.begin(), lower.end());
    add_foot(points);
    return Outline(points).scaled(mm, mm);
  }

  RailLandmarks landmarks_60e1()
  {
    const HeadOutline head_mm = head();
    const auto        scaled  = [](const Point &point) {
      return Point{{mm * point[0], mm * point[1]}};
    };
    return {scaled(head_mm.side_end), scaled(head_mm.lower_corner)};
  }
} // namespace RollingContact::Profiles
