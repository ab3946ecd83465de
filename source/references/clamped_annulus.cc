#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/bessel.hpp>

#include <rolling_contact/base/constants.h>
#include <rolling_contact/references/checks.h>
#include <rolling_contact/references/clamped_annulus.h>
#include <rolling_contact/references/hertz_line.h>

#include <algorithm>
#include <cmath>

namespace RollingContact::References
{
  namespace
  {

    /**
     * c_0: potentials z and 1/z.
     */
    double ring_coefficient(const double hub_ratio, const double kappa)
    {
      const double square = hub_ratio * hub_ratio;
      return (kappa - 1) * (1 - square) / (2 + (kappa - 1) * square);
    }

    /**
     * c_1, with the net force: potentials (ln z, -kappa ln z), z^2, z^(-2) and
     * a translation.
     */
    double net_force_coefficient(const double hub_ratio, const double kappa)
    {
      const double square    = hub_ratio * hub_ratio;
      const double logarithm = -1 / (2 * (1 + kappa));
      const double growing   = logarithm * (kappa - 1 + 2 * square) /
                             (2 * (1 + kappa * square * square));
      const double decaying = square * (kappa * square * growing - logarithm);
      const double translation =
        2 * square * growing - 2 * kappa * std::log(hub_ratio) * logarithm;
      return decaying + logarithm - translation - (kappa - 2) * growing;
    }

    /**
     * c_n of the full disc.
     */
    double disc_coefficient(const unsigned int n, const double kappa)
    {
      return (kappa / (n + 1.) + 1 / (n - 1.)) / 2;
    }

    /**
     * Radial displacement times 2 G and stresses at the rim r = 1.
     */
    struct RimState
    {
      double displacement;
      double normal_plus_shear;
      double shear;
    };

    /**
     * Harmonic n >= 2 of the growing potentials alpha z^(n+1) and beta z^(n-1)
     * together with the decaying ones that clamp the hub; upper and lower are
     * the values of those, z^(1-n) and z^(-n-1), at the rim.
     */
    RimState clamped_rim_state(const unsigned int n,
                               const double       hub_ratio,
                               const double       kappa,
                               const double       alpha,
                               const double       beta)
    {
      const double square = hub_ratio * hub_ratio;
      const double decay  = std::pow(square, n - 1.);
      const double order  = n;
      const double upper =
        decay * ((order + 1) * square * alpha + beta) / kappa;
      const double lower =
        square * ((kappa + order - 1) * upper +
                  decay * (square * (kappa - order - 1) * alpha - beta));

      RimState state;
      state.displacement = (kappa - order - 1) * alpha - beta +
                           (kappa + order - 1) * upper - lower;
      state.normal_plus_shear =
        2 * (order + 1) * (alpha - (order - 1) * upper + lower);
      state.shear = (order - 1) * (beta - order * upper) +
                    (order + 1) * (order * alpha + lower);
      return state;
    }

    /**
     * c_n, n >= 2: the combination with unit pressure and no shear at the rim.
     */
    double annulus_coefficient(const unsigned int n,
                               const double       hub_ratio,
                               const double       kappa)
    {
      const RimState first  = clamped_rim_state(n, hub_ratio, kappa, 1, 0);
      const RimState second = clamped_rim_state(n, hub_ratio, kappa, 0, 1);
      return (first.displacement * second.shear -
              second.displacement * first.shear) /
             (first.normal_plus_shear * second.shear -
              second.normal_plus_shear * first.shear);
    }

    /**
     * Sum over n >= 2 of the full disc's c_n cos(n t), 0 < t < 2 pi, from the
     * sums of cos(n t)/n and sin(n t)/n.
     */
    double disc_kernel(const double angle, const double kappa)
    {
      const double cosine     = std::cos(angle);
      const double sine       = std::sin(angle);
      const double cosine_sum = -std::log(2 * std::sin(angle / 2));
      const double sine_sum   = (pi - angle) / 2;
      return ((kappa + 1) * cosine * cosine_sum +
              (kappa - 1) * sine * sine_sum - kappa * (1 + cosine / 2)) /
             2;
    }

    /**
     * Integral between two distances 0 <= from < to from the observed point,
     * with a logarithm at 0 and square roots at the edges of the patch.
     */
    template <typename Function>
    double
    integral(const Function &function, const double from, const double to)
    {
      static thread_local boost::math::quadrature::tanh_sinh<double> quadrature;
      constexpr double tolerance = 1e-12;
      return from < to ? quadrature.integrate(function, from, to, tolerance)
                       : 0;
    }
  } // namespace

  ClampedAnnulus::ClampedAnnulus(const Annulus &annulus)
    : annulus(annulus)
  {
    check_positive("Rim radius", annulus.rim_radius, "m");
    check_positive("Hub radius", annulus.hub_radius, "m");
    check_elasticity(annulus.young_modulus, annulus.poisson_ratio);
    const double hub_ratio = annulus.hub_radius / annulus.rim_radius;
    if (!(hub_ratio <= largest_hub_ratio))
      reject("Hub radius over rim radius", hub_ratio, "", "at most 0.999");

    kappa            = 3 - 4 * annulus.poisson_ratio;
    hub_coefficients = {ring_coefficient(hub_ratio, kappa),
                        net_force_coefficient(hub_ratio, kappa)};

    constexpr double negligible = 1e-18;
    for (unsigned int n = 2;
         1. * n * n * std::pow(hub_ratio, 2. * (n - 1)) > negligible;
         ++n)
      hub_coefficients.push_back(annulus_coefficient(n, hub_ratio, kappa) -
                                 disc_coefficient(n, kappa));
  }

  double ClampedAnnulus::radial_displacement(const double half_width,
                                             const double angle) const
  {
    check_positive("Half-width", half_width, "m");
    check_finite("Angle", angle, "rad");
    const double half_angle = half_width / annulus.rim_radius;
    if (!(half_angle < pi / 2))
      reject("Half-width over rim radius", half_angle, "", "less than pi/2");
    const double reduced_angle = std::abs(std::remainder(angle, 2 * pi));
    const double inverse_shear =
      (1 + annulus.poisson_ratio) / annulus.young_modulus;
    return -inverse_shear * 2 / (pi * half_angle) *
           (disc_response(half_angle, reduced_angle) +
            hub_response(half_angle, reduced_angle));
  }

  double ClampedAnnulus::disc_response(const double half_angle,
                                       const double angle) const
  {
    const HertzLine patch{half_angle, 1};
    const auto      before = [&](const double distance) {
      return patch.pressure(angle - distance) * disc_kernel(distance, kappa);
    };
    const auto after = [&](const double distance) {
      return patch.pressure(angle + distance) * disc_kernel(distance, kappa);
    };
    const double nearest = std::max(0., angle - half_angle);
    return (integral(before, nearest, angle + half_angle) +
            integral(after, 0, half_angle - angle)) /
           pi;
  }

  double ClampedAnnulus::hub_response(const double half_angle,
                                      const double angle) const
  {
    double response = hub_coefficients[0] * half_angle / 4;
    for (unsigned int n = 1; n < hub_coefficients.size(); ++n)
      response += hub_coefficients[n] *
                  boost::math::cyl_bessel_j(1, n * half_angle) / n *
                  std::cos(n * angle);
    return response;
  }
} // namespace RollingContact::References
