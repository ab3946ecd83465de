#include <rolling_contact/base/text.h>
#include <rolling_contact/results/linearity_check.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  StrainMeasures strain_measures(const PairSpec   &scene,
                                 const Resultants &result,
                                 const double      approach)
  {
    StrainMeasures measures;
    for (const BodySpec *body : {&scene.wheel, &scene.rail})
      {
        if (body->radius != 0.)
          measures.angle =
            std::max(measures.angle,
                     result.half_width_x / std::abs(body->radius));
        if (body->rigid)
          continue;
        measures.pressure = std::max(measures.pressure,
                                     result.max_pressure /
                                       body->surface_material().young_modulus);
        measures.approach =
          std::max(measures.approach,
                   std::abs(approach) /
                     (body->has_cover()
                        ? body->cover_thickness
                        : body->body_shape()->thickness_below()));
      }
    return measures;
  }

  void warn_of_large_strains(const StrainMeasures &measures, Log &log)
  {
    const auto warn =
      [&](const double value, const double limit, const std::string &what) {
        if (value > limit)
          log.warning(what + " is " + significant(value, 3) + ", above " +
                      significant(limit, 2) +
                      ": beyond the small strains that linear elasticity holds "
                      "for; the numbers are those of the linear theory.");
      };
    warn(measures.pressure, 0.05, "Peak pressure over Young's modulus");
    warn(measures.angle, 0.3, "The half-width over the radius of a body");
    warn(measures.approach,
         0.05,
         "The approach over the thickness of a body or its cover");
  }
} // namespace RollingContact
