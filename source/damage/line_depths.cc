#include <rolling_contact/base/constants.h>
#include <rolling_contact/damage/line_depths.h>
#include <rolling_contact/references/checks.h>

namespace RollingContact::Damage
{
  double depth_per_passage(const NodeLine         &line,
                           const WearLaw          &law,
                           const DamageParameters &parameters)
  {
    if (line.lengths.size() != line.nodes.size())
      References::reject("Number of lengths",
                         line.lengths.size(),
                         "",
                         std::to_string(line.nodes.size()) + ", one each");
    double depth = 0.;
    for (std::size_t i = 0; i < line.nodes.size(); ++i)
      depth += law.rate(line.nodes[i], parameters) * line.lengths[i];
    return depth;
  }

  double wheel_depth_per_metre(const double depth_per_passage,
                               const double rolling_radius)
  {
    References::check_positive("Rolling radius", rolling_radius, "m");
    return depth_per_passage / (2 * pi * rolling_radius);
  }
} // namespace RollingContact::Damage
