#ifndef rolling_contact_results_reference_2d_h
#define rolling_contact_results_reference_2d_h

#include <rolling_contact/references/carter.h>
#include <rolling_contact/references/hertz_line.h>
#include <rolling_contact/references/layered_line.h>
#include <rolling_contact/scene/pair_spec.h>
#include <rolling_contact/state/steady_state.h>

#include <optional>

namespace RollingContact
{
  /**
   * Closed forms a 2D state is compared with, at the computed load: Hertz
   * always, Carter when half-planes of these materials uncouple (Dundurs' beta
   * = 0) and friction is constant, the exact load of two clamped discs when the
   * approach is given. Carter is exact for mirror-identical bodies; others
   * differ from it by their unequal bulk strains.
   */
  struct Reference2D
  {
    References::HertzLine             hertz;
    std::optional<References::Carter> carter;
    bool                              carter_is_exact = false;
    std::optional<double>             normal_force; ///< N

    /** The pressure of half-planes with covers in place of Hertz's, without
     * friction, of which hertz is half-width and peak; none without covers. */
    std::optional<References::LayeredLine> layered;

    /** The closed form of the pressure (Pa) at x (m). */
    double pressure(const double x) const
    {
      return layered ? layered->pressure(x) : hertz.pressure(x);
    }
  };

  Reference2D reference_2d(const PairSpec &scene, const SteadyState<2> &steady);

  /**
   * Differences from the reference: forces over mu N, tractions over mu p0,
   * lengths in elements. With x in units of a and the error e of the
   * RecoveredTractions known at the nodes, L2 = sqrt(integral e^2 dx / a) by
   * the trapezoidal rule. The sawtooth is that of the state itself, max |e(i+1)
   * - 2 e(i) + e(i-1)| / 4.
   */
  struct Errors2D
  {
    std::optional<double> normal_force; ///< relative
    double                pressure_l2 = 0.;
    double                force = 0., traction_l2 = 0., sawtooth = 0.;
    double                stick_boundary = 0.; ///< elements
  };

  Errors2D errors_2d(const PairSpec       &scene,
                     const SteadyState<2> &steady,
                     const Reference2D    &reference);
} // namespace RollingContact

#endif
