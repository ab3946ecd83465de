#include <fmt/format.h>

#include <rolling_contact/base/constants.h>
#include <rolling_contact/surfaces/profile_writer.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace RollingContact::Profiles
{
  namespace
  {
    std::string rows(const std::vector<CurvePoint> &points,
                     const double                   sign,
                     const std::string             &margin)
    {
      std::string text;
      for (const CurvePoint &point : points)
        text += fmt::format("{}{:.9f} {:.9f}\n",
                            margin,
                            sign * point.y / mm,
                            sign * point.z / mm);
      return text;
    }

    std::string simpack(const ProfileCurve &curve,
                        const ProfileKind   kind,
                        const std::string  &title)
    {
      std::vector<CurvePoint> points(curve.points());
      if (kind == ProfileKind::wheel)
        std::reverse(points.begin(), points.end());
      return "! " + title +
             "\n! Smoothing length = 0\n"
             "header.begin\n  version = 1\n  type = " +
             (kind == ProfileKind::wheel ? "1" : "0") +
             "\nheader.end\n"
             "spline.begin\n  approx.smooth = 0.\n  mirror.y = 0\n"
             "  mirror.z = 0\n  inversion = 0\n  units.len.f = 1000.\n"
             "  units.ang.f = 1.\n  point.begin\n" +
             rows(points, 1., "    ") + "  point.end\nspline.end\n";
    }
  } // namespace

  std::string profile_text(const ProfileCurve &curve,
                           const ProfileKind   kind,
                           const ProfileFormat format,
                           const std::string  &title)
  {
    const std::size_t n = curve.points().size();
    if (n > most_profile_points)
      throw std::invalid_argument("A profile is written with 10000 points at "
                                  "most.");
    switch (format)
      {
        case ProfileFormat::simpack:
          return simpack(curve, kind, title);
        case ProfileFormat::miniprof:
          return fmt::format("Comment=\"{}; Smoothing length = 0\"\n"
                             "XYPoints={}\nColumnDef=X,Y\n\n",
                             title,
                             n) +
                 rows(curve.points(), -1., "");
        case ProfileFormat::columns:
          break;
      }
    return "# " + title +
           "\n# y towards the field side, z down, mm\n"
           "# Smoothing length = 0\n" +
           rows(curve.points(), 1., "");
  }
} // namespace RollingContact::Profiles
