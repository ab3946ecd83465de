#include <rolling_contact/mesh/gap_lines.h>

#include <algorithm>

namespace RollingContact
{
  std::vector<GapLine> lines_across(const Profiles::ContactFrame &frame,
                                    const ApproachShare          &share)
  {
    const double         step = 2.5e-4, reach = 0.07, along = 5e-3;
    std::vector<GapLine> lines;
    for (int k = -reach / step; k <= reach / step; ++k)
      {
        GapLine line{k * step, 0., 0., 0.};
        if (!frame.covers(line.y) || share(line.y) < least_approach_share)
          continue;
        for (unsigned int round = 0; round < 2; ++round)
          {
            const auto left   = frame.gap(line.place - along, line.y),
                       middle = frame.gap(line.place, line.y),
                       right  = frame.gap(line.place + along, line.y);
            line.curvature    = 0.;
            if (!left || !middle || !right)
              break;
            line.curvature =
              (*left - 2 * *middle + *right) / (2 * along * along);
            if (!(line.curvature > 0.))
              break;
            const double shift =
              (*left - *right) / (4 * along * line.curvature);
            line.least = *middle - line.curvature * shift * shift;
            line.place += shift;
          }
        line.least /= share(line.y);
        line.curvature /= share(line.y);
        if (line.curvature > 0. && line.least < deepest_approach)
          lines.push_back(line);
      }
    return lines;
  }

  ZoneBox overlap(const std::vector<GapLine> &lines, const double depth)
  {
    ZoneBox box{{{1., 1.}}, {{-1., -1.}}};
    for (const GapLine &line : lines)
      if (line.least < depth)
        {
          const double half = std::sqrt((depth - line.least) / line.curvature);
          box.lower[0]      = std::min(box.lower[0], line.place - half);
          box.upper[0]      = std::max(box.upper[0], line.place + half);
          box.lower[1]      = std::min(box.lower[1], line.y);
          box.upper[1]      = std::max(box.upper[1], line.y);
        }
    const double step = 2.5e-4; // between lines
    return box.grown(0., step);
  }
} // namespace RollingContact
