#include <boost/test/unit_test.hpp>

#include "scratch_folder.h"

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/surfaces/nominal_profiles.h>
#include <rolling_contact/surfaces/profile_measures.h>
#include <rolling_contact/surfaces/profile_writer.h>
#include <rolling_contact/surfaces/wear_deposit.h>
#include <rolling_contact/surfaces/worn_profile.h>

#include <cmath>
#include <functional>
#include <numeric>
#include <random>

using namespace RollingContact;
using namespace RollingContact::Profiles;

BOOST_AUTO_TEST_SUITE(worn_profiles)

namespace
{
  const double mm = 1e-3, um = 1e-6;

  const ProfileKind wheel = ProfileKind::wheel, rail = ProfileKind::rail;

  ProfileCurve dense_s1002()
  {
    return subdivided(s1002(), 0.1 * mm);
  }

  double sum(const std::vector<double> &values)
  {
    return std::accumulate(values.begin(), values.end(), 0.);
  }

  double moment(const ProfileCurve &curve, const std::vector<double> &amounts)
  {
    return std::inner_product(amounts.begin(),
                              amounts.end(),
                              curve.arc_lengths().begin(),
                              0.);
  }

  /** Lines side by side from one place to another. */
  std::vector<WearLine> lines_of(const double                         from,
                                 const double                         to,
                                 const unsigned int                   n,
                                 const std::function<double(double)> &depth)
  {
    std::vector<WearLine> lines;
    for (unsigned int k = 0; k < n; ++k)
      {
        const double t = (k + 0.5) / n;
        lines.push_back({from + t * (to - from), (to - from) / n, depth(t)});
      }
    return lines;
  }

  double parabola(const double t)
  {
    return 4 * t * (1 - t);
  }

  double hat(const double t)
  {
    return 1 - std::abs(2 * t - 1);
  }

  /** Lines about a place of the profile. */
  std::vector<WearLine> patch(const ProfileCurve &curve,
                              const double        y,
                              const double        width,
                              const double        depth)
  {
    const double s = arc_length_across(curve, y);
    return lines_of(s - width / 2, s + width / 2, 12, [&](const double t) {
      return depth * parabola(t);
    });
  }

  bool same(const ProfileCurve &a, const ProfileCurve &b)
  {
    if (a.points().size() != b.points().size())
      return false;
    for (std::size_t k = 0; k < a.points().size(); ++k)
      if (a.points()[k].y != b.points()[k].y ||
          a.points()[k].z != b.points()[k].z ||
          a.points()[k].angle != b.points()[k].angle ||
          a.arc_lengths()[k] != b.arc_lengths()[k])
        return false;
    return true;
  }

  /** The part of a curve from one point to another. */
  ProfileCurve
  part(const ProfileCurve &curve, const std::size_t from, const std::size_t to)
  {
    return ProfileCurve(
      std::vector<CurvePoint>(curve.points().begin() + from,
                              curve.points().begin() + to + 1));
  }

  /** An arc of a circle, convex upwards as a rail, about the vertical. */
  ProfileCurve arc_of_circle(const double       radius,
                             const double       half_angle,
                             const unsigned int n)
  {
    std::vector<CurvePoint> points;
    for (unsigned int k = 0; k <= n; ++k)
      {
        const double angle = half_angle * (2. * k / n - 1);
        points.push_back(
          {radius * std::sin(angle), -radius * std::cos(angle), angle});
      }
    return ProfileCurve(points);
  }

  /** The area below each other of two curves by many small trapezia. */
  double area_by_polygons(const ProfileCurve &before, const ProfileCurve &after)
  {
    std::vector<MeasuredPoint> points;
    const unsigned int         n = 200'000;
    for (unsigned int k = 0; k <= n; ++k)
      {
        const CurvePoint at = before.at(before.length() * k / n);
        points.push_back({at.y, at.z});
      }
    for (unsigned int k = n + 1; k-- > 0;)
      {
        const CurvePoint at = after.at(after.length() * k / n);
        points.push_back({at.y, at.z});
      }
    double area = 0.;
    for (std::size_t k = 0; k < points.size(); ++k)
      {
        const auto &a = points[k], &b = points[(k + 1) % points.size()];
        area += (a.y - b.y) * (a.z + b.z - 2 * points[0].z) / 2;
      }
    return std::abs(area);
  }

  std::string refusal(const std::function<void()> &action)
  {
    try
      {
        action();
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }

  bool names(const std::string &text, const std::string &part)
  {
    return text.find(part) != std::string::npos;
  }
} // namespace

BOOST_AUTO_TEST_CASE(further_points_are_on_the_same_curve)
{
  for (const ProfileCurve &curve : {s1002(), rail_head("60E1")})
    {
      const ProfileCurve dense  = subdivided(curve, 0.1 * mm);
      double             widest = 0., farthest = 0.;
      for (std::size_t k = 1; k < dense.points().size(); ++k)
        widest =
          std::max(widest, dense.arc_lengths()[k] - dense.arc_lengths()[k - 1]);
      BOOST_TEST(widest < 0.1 * mm * (1 + 1e-5));
      BOOST_TEST(dense.length() == curve.length(),
                 boost::test_tools::tolerance(1e-9));
      const double ratio = dense.length() / curve.length();
      for (double s = 0.; s < curve.length(); s += 0.0137 * mm)
        {
          const CurvePoint a = curve.at(s), b = dense.at(ratio * s);
          farthest = std::max(farthest,
                              std::abs(std::cos(a.angle) * (b.z - a.z) -
                                       std::sin(a.angle) * (b.y - a.y)));
        }
      BOOST_TEST_MESSAGE("subdivided is off by " << farthest << " m");
      BOOST_TEST(farthest < 1e-13);
      std::size_t found = 0;
      for (const CurvePoint &point : dense.points())
        if (found < curve.points().size() &&
            point.y == curve.points()[found].y &&
            point.z == curve.points()[found].z &&
            point.angle == curve.points()[found].angle)
          ++found;
      BOOST_TEST(found == curve.points().size());
    }
  BOOST_CHECK_THROW(subdivided(s1002(), 0.), std::invalid_argument);
}

// wide lines and narrow ones, between points and beyond both ends
BOOST_AUTO_TEST_CASE(deposits_keep_the_amount_of_the_lines)
{
  std::mt19937                           engine(3);
  std::uniform_real_distribution<double> uniform(0., 1.);
  const ProfileCurve                     coarse = s1002();
  const ProfileCurve                     curve  = dense_s1002();
  for (const ProfileCurve *profile : {&coarse, &curve})
    for (const double width : {0.013, 0.08, 0.3, 2.})
      for (const double first : {-5., -0.2, 40., 170.})
        BOOST_TEST_CONTEXT("width " << width << ", from " << first)
        {
          std::vector<WearLine> lines;
          double                amount = 0., first_moment = 0., s = first * mm;
          for (unsigned int k = 0; k < 12; ++k)
            {
              const double w = width * mm * (0.5 + uniform(engine));
              lines.push_back({s, w, um * uniform(engine)});
              s += width * mm;
            }
          std::shuffle(lines.begin(), lines.end(), engine);
          const std::vector<double> amounts = deposited(*profile, lines);
          for (const WearLine &line : lines)
            {
              amount += line.depth * line.width;
              first_moment += line.depth * line.width * line.s;
            }
          BOOST_TEST(std::abs(sum(amounts) / amount - 1) < 1e-12);
          for (const double found : amounts)
            BOOST_TEST(found >= -1e-12 * amount);
          if (first == -5. && width < 0.3)
            BOOST_TEST(std::abs(amounts[0] / amount - 1) < 1e-12);
        }
  // the hats of like lines are their mean places, and so are their depths
  const auto lines = lines_of(50 * mm, 60 * mm, 12, parabola);
  const auto found = deposited(curve, lines);
  double     mean  = 0.;
  for (const WearLine &line : lines)
    mean += line.depth * line.width * line.s;
  BOOST_TEST(std::abs(moment(curve, found) / mean - 1) < 1e-12);
  const auto level =
    depths_of(curve,
              deposited(curve, lines_of(30 * mm, 90 * mm, 77, [](double) {
                          return um;
                        })));
  for (std::size_t k = 0; k < level.size(); ++k)
    {
      const double s = curve.arc_lengths()[k];
      if (s > 31 * mm && s < 89 * mm)
        BOOST_TEST(std::abs(level[k] / um - 1) < 1e-9);
      if (s < 29 * mm || s > 91 * mm)
        BOOST_TEST(level[k] == 0.);
    }
  // lines of a graded mesh stand for half of both distances
  std::vector<WearLine> graded;
  double                place = 40 * mm, step = 0.2 * mm;
  for (unsigned int k = 0; k < 12; ++k, step *= 1.3)
    {
      graded.push_back({place, (1 + 1 / 1.3) * step / 2, um});
      place += step;
    }
  const auto even = depths_of(curve, deposited(curve, graded));
  for (std::size_t k = 0; k < even.size(); ++k)
    if (curve.arc_lengths()[k] > 40.2 * mm &&
        curve.arc_lengths()[k] < graded.back().s - 0.2 * mm)
      BOOST_TEST(std::abs(even[k] / um - 1) < 1e-9);
  // between two patches nothing is worn
  auto two = lines_of(40 * mm, 43 * mm, 10, parabola);
  for (const WearLine &line : lines_of(50 * mm, 53 * mm, 10, parabola))
    two.push_back(line);
  const auto apart = deposited(curve, two);
  for (std::size_t k = 0; k < apart.size(); ++k)
    if (curve.arc_lengths()[k] > 43.3 * mm &&
        curve.arc_lengths()[k] < 49.7 * mm)
      BOOST_TEST(apart[k] == 0.);
  BOOST_CHECK_THROW(deposited(curve, {{0., 0., um}}), std::invalid_argument);
  BOOST_CHECK_THROW(deposited(curve, {{NAN, mm, um}}), std::invalid_argument);
}

// a depth that grows in proportion to the length, over points that are unevenly
// far apart: differences of depths would be those of the distances otherwise
BOOST_AUTO_TEST_CASE(depths_do_not_depend_on_the_distances_of_points)
{
  std::vector<CurvePoint> points;
  for (const double y : {0., 1., 2., 2.001, 3., 3.2, 3.4, 4., 5., 6.})
    points.push_back({mm * y, 0., 0.});
  const ProfileCurve curve(points);
  const auto         depth = depths_of(
    curve, deposited(curve, lines_of(-2 * mm, 8 * mm, 20, [](const double t) {
                       return um * (t + 0.1);
                     })));
  for (std::size_t k = 1; k + 1 < points.size(); ++k)
    BOOST_TEST(depth[k] == um * (points[k].y / (10 * mm) + 0.3),
               boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(smoothing_keeps_amount_and_mean_place)
{
  const ProfileCurve curve = dense_s1002();
  for (const double place : {0.4 * mm, 46. * mm, curve.length() - 0.7 * mm})
    for (const double width : {0., 0.03 * mm, 0.4 * mm, 3 * mm})
      BOOST_TEST_CONTEXT("at " << place << ", width " << width)
      {
        const auto amounts = deposited(
          curve, lines_of(place - 0.4 * mm, place + 0.4 * mm, 6, [](double t) {
            return um * hat(t);
          }));
        const auto found = smoothed(curve, amounts, width);
        BOOST_TEST(std::abs(sum(found) / sum(amounts) - 1) < 1e-12);
        BOOST_TEST(std::abs(moment(curve, found) / moment(curve, amounts) - 1) <
                   1e-12);
        BOOST_TEST((found == amounts) == (width == 0.));
      }
  // a wave as long as twice the width of the kernel: (sin(x)/x)^2 at pi/2
  std::vector<double> wave(curve.points().size());
  for (std::size_t k = 1; k + 1 < wave.size(); ++k)
    wave[k] = um * std::cos(2 * M_PI * curve.arc_lengths()[k] / (4 * mm)) *
              (curve.arc_lengths()[k + 1] - curve.arc_lengths()[k - 1]) / 2;
  const auto flat = depths_of(curve, smoothed(curve, wave, 2 * mm));
  double     most = 0.;
  for (std::size_t k = 200; k < 1000; ++k)
    most = std::max(most, flat[k] / um);
  BOOST_TEST(most == 4 / (M_PI * M_PI), boost::test_tools::tolerance(2e-3));
}

BOOST_AUTO_TEST_CASE(without_wear_a_profile_stays_to_the_bit)
{
  for (const ProfileCurve &curve : {s1002(), dense_s1002(), rail_head("60E1")})
    for (const ProfileKind kind : {wheel, rail})
      {
        const std::vector<double> none(curve.points().size(), 0.);
        BOOST_TEST(same(worn(curve, kind, none), curve));
        BOOST_TEST(same(worn(curve, kind, smoothed(curve, none, mm)), curve));
        BOOST_TEST(same(offset_into_body(curve, kind, none), curve));
        BOOST_TEST(worn_area(curve, curve, kind) == 0.);
      }
  // nor do points beside what wears
  const ProfileCurve curve = dense_s1002();
  const double       s     = arc_length_across(curve, 0.);
  const ProfileCurve found =
    worn(curve, wheel, deposited(curve, patch(curve, 0., 10 * mm, 50 * um)));
  for (std::size_t k = 0; k < curve.points().size(); ++k)
    if (std::abs(curve.arc_lengths()[k] - s) > 6 * mm)
      {
        BOOST_TEST(found.points()[k].y == curve.points()[k].y);
        BOOST_TEST(found.points()[k].z == curve.points()[k].z);
        BOOST_TEST(found.points()[k].angle == curve.points()[k].angle);
      }
}

// a rail's crown shrinks about its centre, and as the hollow of a wheel it
// grows
BOOST_AUTO_TEST_CASE(a_circle_wears_to_a_circle)
{
  const double       radius = 13 * mm, half = 0.7, depth = 0.3 * mm;
  const ProfileCurve circle = arc_of_circle(radius, half, 180);
  for (const ProfileKind kind : {rail, wheel})
    {
      const double side  = kind == rail ? 1. : -1.,
                   after = radius - side * depth;
      const ProfileCurve found =
        offset_into_body(circle,
                         kind,
                         std::vector<double>(circle.points().size(), depth));
      for (std::size_t k = 0; k < circle.points().size(); ++k)
        {
          const CurvePoint &at = found.points()[k];
          BOOST_TEST(std::abs(std::hypot(at.y, at.z) / after - 1) < 1e-14);
          BOOST_TEST(at.angle == circle.points()[k].angle);
        }
      BOOST_TEST(worn_area(circle, found, kind) ==
                   side * half * (radius * radius - after * after),
                 boost::test_tools::tolerance(1e-8));
      const WornDepth most = largest_worn_depth(circle, found, kind);
      BOOST_TEST(std::abs(most.depth - depth) < 1e-12);
      BOOST_TEST(largest_worn_depth(found, circle, kind).depth == 0.);
      // of points elsewhere
      const WornDepth other =
        largest_worn_depth(circle, arc_of_circle(after, half, 137), kind);
      BOOST_TEST(std::abs(other.depth - depth) < 1e-10);
    }
}

// the tangents are those of the curve that is worn, to the second order of the
// distance of points: a bump on a circle, r(phi) = r0 - h(phi), tan = r' / r
BOOST_AUTO_TEST_CASE(tangents_follow_the_depth)
{
  const double radius = 13 * mm, height = 0.2 * mm, wave = 0.5;
  for (const ProfileKind kind : {rail, wheel})
    for (const unsigned int n : {400u, 1600u})
      {
        const ProfileCurve  circle = arc_of_circle(radius, 0.7, n);
        const double        side   = kind == rail ? 1. : -1.;
        std::vector<double> depths;
        for (const CurvePoint &point : circle.points())
          depths.push_back(height *
                           (1 + std::cos(2 * M_PI * point.angle / wave)) / 2);
        const ProfileCurve found = offset_into_body(circle, kind, depths);
        double             most  = 0.;
        for (std::size_t k = 1; k + 1 < depths.size(); ++k)
          {
            const double angle = circle.points()[k].angle,
                         rise  = -height * M_PI / wave *
                                std::sin(2 * M_PI * angle / wave),
                         turn =
                           std::atan2(side * rise, radius - side * depths[k]);
            most =
              std::max(most, std::abs(found.points()[k].angle - angle - turn));
          }
        BOOST_TEST(most < (n == 400 ? 32e-6 : 2e-6));
      }
}

// what is between the curves is what was taken, on the tread, in the root and
// on the flank at 70 degrees, each by itself and together
BOOST_AUTO_TEST_CASE(the_area_between_the_curves_is_the_amount)
{
  const ProfileCurve curve = dense_s1002();
  const double       flank = arc_length_across(curve, -39.1 * mm);
  BOOST_TEST(std::abs(curve.at(flank).angle * 180 / M_PI + 70) < 1e-3);
  auto on_flank =
    deposited(curve,
              lines_of(flank - 1.5 * mm, flank + 1.5 * mm, 12, [](double t) {
                return 100 * um * hat(t);
              }));
  auto all = on_flank;
  for (const double y : {0., -32.})
    {
      const auto more =
        deposited(curve, patch(curve, y * mm, 6 * mm, 100 * um));
      std::transform(
        all.begin(), all.end(), more.begin(), all.begin(), std::plus<double>());
    }
  for (const auto *amounts : {&on_flank, &all})
    {
      const ProfileCurve found = worn(curve, wheel, *amounts);
      BOOST_TEST_MESSAGE("area over amount - 1: "
                         << worn_area(curve, found, wheel) / sum(*amounts) - 1
                         << ", by polygons "
                         << area_by_polygons(curve, found) / sum(*amounts) - 1);
      BOOST_TEST(std::abs(worn_area(curve, found, wheel) / sum(*amounts) - 1) <
                 1e-9);
      BOOST_TEST(std::abs(area_by_polygons(curve, found) / sum(*amounts) - 1) <
                 1e-6);
      BOOST_TEST(
        std::abs(largest_worn_depth(curve, found, wheel).depth / (100 * um) -
                 1) < 0.1);
    }
  // each place has its own
  const ProfileCurve found = worn(curve, wheel, all);
  for (const auto &[from, to] :
       {std::pair<double, double>(-42., -36.8), {-36.8, -10.}, {-10., 10.}})
    {
      const auto at = [&](const double y) {
        return std::upper_bound(curve.arc_lengths().begin(),
                                curve.arc_lengths().end(),
                                arc_length_across(curve, y * mm)) -
               curve.arc_lengths().begin();
      };
      const std::size_t begin = at(from), end = at(to);
      const double      amount = std::accumulate(all.begin() + begin,
                                            all.begin() + end + 1,
                                            0.),
                   area        = worn_area(part(curve, begin, end),
                                    part(found, begin, end),
                                    wheel);
      BOOST_TEST_MESSAGE(
        "from " << from << " mm: area over amount - 1: " << area / amount - 1);
      BOOST_TEST(std::abs(area / amount - 1) < 3e-4);
    }
  // as much the other way, and in many steps
  ProfileCurve slow         = curve;
  double       sum_of_steps = 0.;
  for (unsigned int step = 0; step < 20; ++step)
    {
      const auto amounts =
        smoothed(slow,
                 deposited(slow, patch(slow, -30 * mm, 12 * mm, 50 * um)),
                 mm);
      sum_of_steps += sum(amounts);
      slow = worn(slow, wheel, amounts);
    }
  BOOST_TEST(std::abs(worn_area(curve, slow, wheel) / sum_of_steps - 1) < 1e-6);
}

// smoothed as wide as lines are apart, the curvature of what is worn is that of
// the depth, and has no comb of the lines
BOOST_AUTO_TEST_CASE(smoothed_wear_has_the_curvature_of_its_depth)
{
  std::vector<CurvePoint> points;
  for (int k = -200; k <= 200; ++k)
    points.push_back({0.1 * mm * k, 0., 0.});
  const ProfileCurve level(points);
  const double       width = 12 * mm, depth = 100 * um,
               exact = 8 * depth / (width * width);
  const auto amounts = deposited(level, patch(level, 0., width, depth));
  const auto largest = [&](const ProfileCurve &found) {
    double most = 0.;
    for (double s = 16 * mm; s < 24 * mm; s += 0.03 * mm)
      most = std::max(most, std::abs(found.curvature(s) + exact));
    return most / exact;
  };
  const ProfileCurve comb   = worn(level, rail, amounts),
                     smooth = worn(level, rail, smoothed(level, amounts, mm));
  BOOST_TEST_MESSAGE("curvature off by " << largest(comb) << ", smoothed "
                                         << largest(smooth));
  BOOST_TEST(largest(comb) > 1.);
  BOOST_TEST(largest(smooth) < 1e-3);
}

BOOST_AUTO_TEST_CASE(a_worn_profile_is_read_as_it_was_written)
{
  const ScratchFolder place;
  const ProfileCurve  curve = dense_s1002();
  auto amounts = deposited(curve, patch(curve, -30 * mm, 12 * mm, 100 * um));
  const auto tread = deposited(curve, patch(curve, 2 * mm, 14 * mm, 100 * um));
  for (std::size_t k = 0; k < amounts.size(); ++k)
    amounts[k] += tread[k];
  const ProfileCurve worn_wheel =
    worn(curve, wheel, smoothed(curve, amounts, 1.2 * mm));
  const ProfileCurve head = subdivided(rail_head("60E1"), 0.1 * mm);
  const ProfileCurve worn_rail =
    worn(head,
         rail,
         smoothed(head,
                  deposited(head, patch(head, -10 * mm, 12 * mm, 100 * um)),
                  1.2 * mm));
  FileOptions plain;
  plain.smoothing_length = 0.;
  for (const auto &[file, kind] :
       {std::pair<std::string, ProfileKind>("wheel_100km.txt", wheel),
        {"wheel.whl", wheel},
        {"wheel.prw", wheel},
        {"rail.txt", rail},
        {"rail.ban", rail},
        {"rail.PRR", rail}})
    BOOST_TEST_CONTEXT(file)
    {
      const auto          path    = place.scratch / file;
      const ProfileCurve &written = kind == wheel ? worn_wheel : worn_rail;
      const std::string   text =
        profile_text(written, kind, format_of(path), "worn, 100 km");
      BOOST_TEST(names(text, "worn, 100 km"));
      BOOST_TEST(names(text, "Smoothing length = 0"));
      write(path, text);
      const ProfileCurve found = read_profile(path, kind, plain);
      const double       most =
        std::max(largest_worn_depth(written, found, wheel).depth,
                 largest_worn_depth(written, found, rail).depth);
      double             between = 0.;
      const ProfileCurve halves  = subdivided(written, 0.034 * mm);
      between = std::max(largest_worn_depth(halves, found, wheel).depth,
                         largest_worn_depth(halves, found, rail).depth);
      BOOST_TEST_MESSAGE(file << ": off by " << most << " m at points, "
                              << between << " m between");
      BOOST_TEST(most < 0.1 * um);
      BOOST_TEST(between < 0.1 * um);
      BOOST_TEST(std::abs(found.points().front().y -
                          written.points().front().y) < 1e-11);
      BOOST_TEST(std::abs(found.points().back().z - written.points().back().z) <
                 1e-11);
    }
  BOOST_CHECK_THROW(profile_text(subdivided(curve, 0.01 * mm),
                                 wheel,
                                 ProfileFormat::columns,
                                 "many"),
                    std::invalid_argument);
}

// the drawing: 28 mm high, 32.5 mm thick
BOOST_AUTO_TEST_CASE(the_flange_of_s1002_has_the_measures_of_its_drawing)
{
  const auto found = flange_measures(s1002());
  BOOST_REQUIRE(found.has_value());
  BOOST_TEST_MESSAGE("S1002: Sh " << found->height / mm << ", Sd "
                                  << found->thickness / mm << ", qR "
                                  << found->qr / mm << " mm");
  BOOST_TEST(std::abs(found->height - 28 * mm) < 1e-8);
  BOOST_TEST(std::abs(found->thickness - 32.5 * mm) < 0.05 * mm);
  BOOST_TEST(std::abs(found->qr - 10.8 * mm) < 0.05 * mm);
  // moved, as with a radius counted from elsewhere, they are the same
  const auto moved = flange_measures(s1002().shifted(0., 3 * mm));
  BOOST_TEST(std::abs(moved->height - found->height) < 1e-12);
  BOOST_TEST(std::abs(moved->thickness - found->thickness) < 1e-12);
  BOOST_TEST(std::abs(moved->qr - found->qr) < 1e-12);
  // without its back, from a plane
  const ProfileCurve curve = s1002();
  const ProfileCurve front = part(curve, 40, curve.points().size() - 1);
  BOOST_TEST(front.points().front().y > -69 * mm);
  BOOST_TEST(std::abs(flange_measures(front)->thickness - found->thickness) <
             2e-9);
  BOOST_TEST(std::abs(flange_measures(front, -0.065)->thickness + 5 * mm -
                      found->thickness) < 2e-9);
  // its own back counts where it has one
  BOOST_TEST(flange_measures(curve, -0.065)->thickness == found->thickness);
  // what has no flange, or ends before the tape circle
  BOOST_TEST(!flange_measures(rail_head("60E1")).has_value());
  BOOST_TEST(!flange_measures(part(curve, 0, 300)).has_value());
  BOOST_TEST(curve.points()[300].y < -10 * mm);
  BOOST_TEST(
    !flange_measures(part(curve, 300, curve.points().size() - 1)).has_value());
}

// a flank at an angle that is worn by h along its normal is thinner by
// h / sin(angle), and a tread that is worn makes the flange higher; where S1002
// is measured it is the root of 13 mm about y = -26.210665, z = 16.446 mm
BOOST_AUTO_TEST_CASE(measures_change_as_the_flange_wears)
{
  const ProfileCurve curve = dense_s1002();
  const auto         first = *flange_measures(curve);
  const double       s = arc_length_across(curve, first.thickness - 70 * mm);
  const CurvePoint   place = curve.at(s);
  BOOST_TEST(std::abs(place.z - 10 * mm) < 1e-8);
  const double angle = std::abs(place.angle), level = 6.446 * mm;
  const auto   half = [&](const double radius) {
    return std::sqrt(radius * radius - level * level);
  };
  double last = first.thickness;
  for (const double depth : {0.001, 0.01, 0.25, 0.5, 1.})
    {
      std::vector<double> distances;
      for (const double at : curve.arc_lengths())
        distances.push_back(
          depth * mm *
          std::clamp((9 * mm - std::abs(at - s)) / (6 * mm), 0., 1.));
      const ProfileCurve found = offset_into_body(curve, wheel, distances);
      const auto         now   = flange_measures(found);
      BOOST_REQUIRE(now.has_value());
      BOOST_TEST(now->thickness < last);
      const double thinner = first.thickness - now->thickness;
      BOOST_TEST_MESSAGE("worn by " << depth << " mm: thinner by "
                                    << thinner / mm << " mm, h / sin "
                                    << depth / std::sin(angle));
      BOOST_TEST(thinner == half(13 * mm + depth * mm) - half(13 * mm),
                 boost::test_tools::tolerance(1e-4));
      if (depth <= 0.01)
        BOOST_TEST(thinner == depth * mm / std::sin(angle),
                   boost::test_tools::tolerance(1e-3));
      BOOST_TEST(std::abs(now->height - first.height) < 1e-12);
      BOOST_TEST(now->qr < first.qr);
      last = now->thickness;
    }
  const ProfileCurve hollow =
    worn(curve, wheel, deposited(curve, patch(curve, 0., 20 * mm, mm)));
  BOOST_TEST(std::abs(flange_measures(hollow)->height - 29 * mm) < 20 * um);
  BOOST_TEST(flange_measures(hollow)->thickness > first.thickness);
}

// Waves of 0.7 mm, as long as a kernel with negative parts would feed on, of
// 0.1 um at first, under deep steps on and beside the joint of flank and root:
// layers thin out in hollows and do not amplify them.
BOOST_AUTO_TEST_CASE(steps_do_not_amplify_waves)
{
  const ProfileCurve  curve = dense_s1002();
  const double        s     = arc_length_across(curve, -38 * mm);
  std::vector<double> wave;
  for (const double at : curve.arc_lengths())
    wave.push_back(std::abs(at - s) > 6 * mm
                     ? 0.
                     : 0.05 * um * (1 + std::cos(2 * M_PI * at / (0.7 * mm))));
  const auto step = [&](const ProfileCurve &now, const double middle) {
    const auto lines =
      lines_of(middle - 8 * mm, middle + 8 * mm, 16, [](const double t) {
        return 0.5 * mm * parabola(t);
      });
    return worn(now, wheel, smoothed(now, deposited(now, lines), 2 * mm));
  };
  ProfileCurve plain = curve, wavy = offset_into_body(curve, wheel, wave);
  for (unsigned int k = 0; k < 6; ++k)
    {
      plain = step(plain, s);
      wavy  = step(wavy, s);
    }
  const double apart = std::max(largest_worn_depth(plain, wavy, wheel).depth,
                                largest_worn_depth(plain, wavy, rail).depth);
  BOOST_TEST_MESSAGE("waves of 0.1 um: " << apart / um << " um after 3 mm");
  BOOST_TEST(apart < 0.2 * um);
}

BOOST_AUTO_TEST_CASE(wear_that_leaves_no_profile_is_refused_with_its_place)
{
  const ProfileCurve curve = dense_s1002();
  // the tip of the flange has a radius of 12 mm
  const std::string deep = refusal([&] {
    worn(curve,
         wheel,
         deposited(curve, patch(curve, -55 * mm, 4 * mm, 13 * mm)));
  });
  BOOST_TEST(names(deep, "radius of curvature"));
  BOOST_TEST(names(deep, "y = -5"));
  const std::string backwards = refusal([&] {
    offset_into_body(arc_of_circle(13 * mm, 0.7, 100),
                     rail,
                     std::vector<double>(101, 13.1 * mm));
  });
  BOOST_TEST(names(backwards, "run backwards"));
  BOOST_TEST(names(backwards, "rail"));
  BOOST_TEST(names(backwards, " mm"));
  BOOST_TEST(refusal([&] {
               offset_into_body(arc_of_circle(13 * mm, 0.7, 100),
                                rail,
                                std::vector<double>(101, 12.9 * mm));
             }) == "");
  // beyond the field side
  for (const double y : {59., 60., 62., 75.})
    {
      const std::string end = refusal([&] {
        worn(curve,
             wheel,
             deposited(curve, patch(curve, y * mm, 6 * mm, 10 * um)));
      });
      BOOST_TEST(names(end, "end of the profile"));
      BOOST_TEST(names(end, "y = 60 mm"));
    }
  BOOST_TEST(refusal([&] {
               worn(curve,
                    wheel,
                    deposited(curve, patch(curve, 55 * mm, 6 * mm, 10 * um)));
             }) == "");
  // a flange that is worn from its flank to behind its back
  ProfileCurve      thin = curve;
  const std::size_t middle =
    std::lower_bound(curve.arc_lengths().begin(),
                     curve.arc_lengths().end(),
                     arc_length_across(curve, -38 * mm)) -
    curve.arc_lengths().begin();
  unsigned int      steps   = 0;
  const std::string through = refusal([&] {
    for (; steps < 100; ++steps)
      {
        const double s = thin.arc_lengths()[middle];
        const auto   lines =
          lines_of(s - 8 * mm, s + 8 * mm, 16, [](const double t) {
            return mm * parabola(t);
          });
        thin =
          worn(thin, wheel, smoothed(thin, deposited(thin, lines), 2 * mm));
      }
  });
  BOOST_TEST_MESSAGE("after " << steps << " mm: " << through);
  BOOST_TEST(names(through, "worn through"));
  // a thin head, from one side to the other
  std::vector<CurvePoint> points;
  for (int k = 0; k < 300; ++k)
    points.push_back({-3 * mm, (30 - 0.1 * k) * mm, -M_PI / 2});
  for (int k = 0; k <= 90; ++k)
    points.push_back({-3 * mm * std::cos(M_PI * k / 90),
                      -3 * mm * std::sin(M_PI * k / 90),
                      M_PI * (k / 90. - 0.5)});
  for (int k = 1; k <= 300; ++k)
    points.push_back({3 * mm, 0.1 * k * mm, M_PI / 2});
  ProfileCurve      head = ProfileCurve(points);
  const std::string slot = refusal([&] {
    for (unsigned int step = 0; step < 100; ++step)
      {
        const double s = head.arc_lengths()[150];
        const auto   lines =
          lines_of(s - 6 * mm, s + 6 * mm, 12, [](const double t) {
            return 0.2 * mm * parabola(t);
          });
        head = worn(head, rail, smoothed(head, deposited(head, lines), 2 * mm));
      }
  });
  BOOST_TEST(names(slot, "worn through"));
  BOOST_TEST(names(slot, "rail"));
  BOOST_CHECK_THROW(worn(curve, wheel, {1., 2.}), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
