#ifndef rolling_contact_references_kalker_h
#define rolling_contact_references_kalker_h

#include <rolling_contact/base/creepages.h>
#include <rolling_contact/references/contact_modulus.h>
#include <rolling_contact/references/hertz_ellipse.h>

namespace RollingContact::References
{
  /**
   * Forces (N) and moment about the normal (N m) on the wheel.
   */
  struct CreepForces
  {
    double x;
    double y;
    double spin_moment;
  };

  /**
   * Dimensionless coefficients of Kalker's linear theory.
   */
  struct KalkerCoefficients
  {
    double C11;
    double C22;
    double C23;
    double C33;
  };

  /**
   * Coefficients of an elliptic patch from Kalker 1990, table E3: linear in the
   * smaller of a/b and b/a, 1/C quadratic in nu (0 <= nu <= 1/2); below 0.1
   * Kalker's asymptotes, which meet the table with steps of up to 7 % (C33 for
   * a > b: 17 %). a is the semi-axis in the rolling direction.
   */
  KalkerCoefficients kalker_coefficients(const double axis_ratio,
                                         const double poisson_ratio);

  /**
   * Forces of Kalker's linear theory, c = sqrt(a b), f the direction of the
   * material flow along x (1 or -1):
   *   Fx = -G c^2 C11 x,  Fy = -G c^2 (C22 y - f c C23 spin),
   *   Mz = -G c^3 (f C23 y + c C33 spin).
   * Kalker writes them for f = -1 (his leading edge is x = +a).
   */
  CreepForces kalker_forces(const Creepages          &creepages,
                            const HertzEllipse       &contact,
                            const CombinedElasticity &elasticity,
                            const int                 flow_direction = 1);
} // namespace RollingContact::References

#endif
