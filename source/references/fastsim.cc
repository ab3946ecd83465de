#include <rolling_contact/base/constants.h>
#include <rolling_contact/references/checks.h>
#include <rolling_contact/references/fastsim.h>

#include <algorithm>
#include <cmath>

namespace RollingContact::References
{
  namespace
  {
    /**
     * Springs and bound on the ellipse.
     */
    struct Springs
    {
      Creepages    rates; ///< x/L1, y/L2, spin/L3 (Pa/m, Pa/m, Pa/m^2)
      HertzEllipse contact;
      double       bound; ///< in the middle, Pa
      int          flow;

      TangentialForce strip(const double y, const unsigned int n_steps) const;
    };

    /**
     * Force per width (N/m) of the strip at @p y, by the midpoint rule: from
     * one middle to the next with the slip in between.
     */
    TangentialForce Springs::strip(const double       y,
                                   const unsigned int n_steps) const
    {
      const double across = y / contact.half_width_y;
      const double length =
        2 * contact.half_width_x * std::sqrt(1 - across * across);
      const double    step = length / n_steps;
      double          qx = 0, qy = 0, previous = -length / 2;
      TangentialForce sum{0, 0};
      for (unsigned int k = 0; k < n_steps; ++k)
        {
          const double middle = -length / 2 + (k + 0.5) * step;
          const double rolled = middle - previous;
          qx -= (rates.x - rates.spin * y) * rolled;
          qy -=
            (rates.y + rates.spin * flow * (middle + previous) / 2) * rolled;
          const double along = middle / contact.half_width_x;
          const double limit =
            bound * std::max(0., 1 - along * along - across * across);
          const double size = std::hypot(qx, qy);
          if (size > limit)
            {
              qx *= limit / size;
              qy *= limit / size;
            }
          sum.x += qx * step;
          sum.y += qy * step;
          previous = middle;
        }
      return sum;
    }
  } // namespace

  TangentialForce fastsim(const Creepages          &creepages,
                          const HertzEllipse       &contact,
                          const CombinedElasticity &elasticity,
                          const double              friction_coefficient,
                          const int                 flow_direction,
                          const unsigned int        n_strips)
  {
    check_not_negative("Friction coefficient", friction_coefficient);
    const double load = contact.load();
    if (load <= 0)
      return {0, 0};
    const double             a = contact.half_width_x, b = contact.half_width_y;
    const KalkerCoefficients kalker =
      kalker_coefficients(a / b, elasticity.poisson_ratio);
    const double    G = elasticity.shear_modulus;
    const Springs   springs{{creepages.x * 3 * G * kalker.C11 / (8 * a),
                             creepages.y * 3 * G * kalker.C22 / (8 * a),
                             creepages.spin * 4 * G * kalker.C23 /
                               (pi * a * std::sqrt(a / b))},
                          contact,
                          friction_coefficient * 2 * load / (pi * a * b),
                          flow_direction};
    TangentialForce force{0, 0};
    for (unsigned int k = 0; k < n_strips; ++k)
      {
        const TangentialForce strip =
          springs.strip(b * (-1 + (2 * k + 1.) / n_strips), n_strips);
        force.x += strip.x * 2 * b / n_strips;
        force.y += strip.y * 2 * b / n_strips;
      }
    return force;
  }
} // namespace RollingContact::References
