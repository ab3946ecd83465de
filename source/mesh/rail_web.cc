#include <rolling_contact/mesh/rail_web.h>
#include <rolling_contact/mesh/section_strip.h>

namespace RollingContact
{
  namespace
  {
    const double half_at_top = 13e-3, half_at_bottom = 17e-3; // m, roughly

    const double inner_share = 0.5; ///< of the thickness

    SectionPoint point_at(const double across, const double up)
    {
      return {{across, up, 0.}};
    }
  } // namespace

  std::vector<SectionPoint> row_with_sides(const SectionPoint &left,
                                           const SectionPoint &right,
                                           const double        inner_half,
                                           const std::vector<double> &columns,
                                           const unsigned int         beside)
  {
    auto points = equal_parts(left, point_at(-inner_half, left[1]), beside);
    for (std::size_t i = 1; i + 1 < columns.size(); ++i)
      points.push_back(point_at(inner_half * columns[i], left[1]));
    const auto others =
      equal_parts(point_at(inner_half, left[1]), right, beside);
    points.insert(points.end(), others.begin(), others.end());
    return points;
  }

  RailWeb::RailWeb(const Profiles::Outline &half_section)
    : line(half_section.part(half_section.nearest({{half_at_top, top}}),
                             half_section.nearest({{half_at_bottom, bottom}})))
  {}

  double RailWeb::half(const double height) const
  {
    const auto &points = line.points();
    for (std::size_t k = 1; k < points.size(); ++k)
      if (points[k][1] <= height)
        {
          const double t =
            (height - points[k - 1][1]) / (points[k][1] - points[k - 1][1]);
          return points[k - 1][0] + t * (points[k][0] - points[k - 1][0]);
        }
    return points.back()[0];
  }

  std::vector<SectionPoint> RailWeb::row(const double               height,
                                         const std::vector<double> &columns,
                                         const unsigned int beside) const
  {
    const double half_here = half(height);
    return row_with_sides(point_at(-half_here, height),
                          point_at(half_here, height),
                          inner_share * half_here,
                          columns,
                          beside);
  }
} // namespace RollingContact
