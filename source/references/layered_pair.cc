#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/bessel.hpp>

#include <rolling_contact/base/constants.h>
#include <rolling_contact/references/checks.h>
#include <rolling_contact/references/layered_pair.h>

#include <algorithm>
#include <cmath>

namespace RollingContact::References
{
  namespace
  {
    using Gauss = boost::math::quadrature::gauss<double, 16>;

    /// k h from where a layer's material alone is felt
    const double deep = 18.;

    /** What a pair gives way by: p and q act on both. */
    SurfaceCompliance sum(const std::array<SurfaceCompliance, 2> &of)
    {
      return {of[0].normal + of[1].normal,
              of[0].tangential + of[1].tangential,
              of[0].coupling - of[1].coupling};
    }
  } // namespace

  SurfaceCompliance material_compliance(const LayeredPlane &body)
  {
    return body.thickness > 0.
             ? half_plane_compliance(body.young_modulus, body.poisson_ratio)
             : half_plane_compliance(body.core_young_modulus,
                                     body.core_poisson_ratio);
  }

  SurfaceCompliance of_materials(const LayeredPair &bodies)
  {
    return sum(
      {{material_compliance(bodies[0]), material_compliance(bodies[1])}});
  }

  SurfaceCompliance beyond_materials(const LayeredPair &bodies, const double k)
  {
    std::array<SurfaceCompliance, 2> rest{};
    for (unsigned int b = 0; b < 2; ++b)
      if (bodies[b].thickness > 0. && k * bodies[b].thickness < deep)
        {
          const auto all = compliance(bodies[b], k),
                     own = material_compliance(bodies[b]);
          rest[b]        = {all.normal - own.normal,
                            all.tangential - own.tangential,
                            all.coupling - own.coupling};
        }
    return sum(rest);
  }

  Eigen::VectorXd bessel_functions(const unsigned int n, const double z)
  {
    const double huge = 1e200;
    // as many above the last that counts, where J falls off ever more slowly
    const unsigned int start  = std::max<double>(n, z) + 70 + 8 * std::cbrt(z);
    Eigen::VectorXd    values = Eigen::VectorXd::Zero(n);
    double             above = 0., here = 1., norm = 0.;
    for (unsigned int m = start; m > 0; --m)
      {
        // here is J_m
        if (m <= n)
          values[m - 1] = here;
        norm += m % 2 == 0 ? 2 * here : 0.;
        const double below = 2 * m / z * here - above;
        above              = here;
        here               = below;
        if (std::abs(here) > huge)
          {
            above /= huge;
            here /= huge;
            norm /= huge;
            values /= huge;
          }
      }
    return values / (norm + here);
  }

  void
  over_wave_numbers(const LayeredPair &bodies,
                    const double       half_length,
                    const std::function<void(const double, const double)> &add)
  {
    double thickest = 0., end = 0.;
    for (const LayeredPlane &body : bodies)
      if (body.thickness > 0.)
        {
          thickest = std::max(thickest, body.thickness);
          end      = std::max(end, deep / body.thickness);
        }
    const double longest = std::min(4 / half_length, 1 / thickest);
    for (double k = 0., step = 1e-5 * longest; k < end; step *= 2)
      {
        const double width = std::min({step, longest, end - k});
        for (unsigned int i = 0; i < Gauss::abscissa().size(); ++i)
          for (const double side : {-1., 1.})
            add(k + width / 2 * (1 + side * Gauss::abscissa()[i]),
                width / 2 * Gauss::weights()[i]);
        k += width;
        if (end - k < 1e-12 * end)
          break;
      }
  }

  double layered_contact_modulus(const double radius, const LayeredPair &bodies)
  {
    check_positive("Radius of the patch", radius, "m");
    const double end = 60., step = 1.; // of k a: beyond it nothing is left
    double       mean = 0.;
    for (double begin = 0.; begin < end; begin += step)
      for (unsigned int i = 0; i < Gauss::abscissa().size(); ++i)
        for (const double side : {-1., 1.})
          {
            const double z =
                           begin + step / 2 * (1 + side * Gauss::abscissa()[i]),
                         pressure = z < 0.05 ? 1. / 3
                                             : (std::sin(z) - z * std::cos(z)) /
                                                 std::pow(z, 3),
                         depth    = 1 - boost::math::cyl_bessel_j(0, z);
            mean += step / 2 * Gauss::weights()[i] * pressure * depth *
                    beyond_materials(bodies, z / radius).normal;
          }
    // with a compliance that is the same for all waves the integral is pi/8
    return 2 / (of_materials(bodies).normal + mean / (pi / 8));
  }
} // namespace RollingContact::References
