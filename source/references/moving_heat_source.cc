#include <boost/math/special_functions/bessel.hpp>

#include <rolling_contact/base/constants.h>
#include <rolling_contact/references/moving_heat_source.h>

#include <cmath>

namespace RollingContact
{
  namespace References
  {
    namespace
    {
      /**
       * exp(u) K_n(u), by its asymptotic series where K_n would underflow.
       */
      double scaled_bessel(const int n, const double u)
      {
        if (u < 100.)
          return std::exp(u) * boost::math::cyl_bessel_k(n, u);
        const double mu = 4. * n * n, z = 8 * u;
        return std::sqrt(pi / (2 * u)) *
               (1 + (mu - 1) / z *
                      (1 + (mu - 9) / (2 * z) * (1 + (mu - 25) / (3 * z))));
      }

      /** Integrals from 0 to u of exp(t) K_0(|t|) and of t times that. */
      struct Moments
      {
        double zeroth = 0., first = 0.;
      };

      Moments moments(const double u)
      {
        const double v = std::abs(u);
        if (v < 1e-300)
          return {};
        const double K0 = scaled_bessel(0, v), K1 = scaled_bessel(1, v);
        if (u > 0.)
          return {v * (K0 + K1) - 1, (v * v * (K0 + K1) - v * K1 + 1) / 3};
        const double faded = std::exp(-2 * v); // exp(-v) K = exp(-2 v) exp(v) K
        return {-(v * (K0 - K1) * faded + 1),
                (v * v * (K0 - K1) * faded - v * K1 * faded + 1) / 3};
      }
    } // namespace

    std::vector<double> moving_heat_source(const std::vector<double> &x,
                                           const std::vector<double> &flux,
                                           const double               speed,
                                           const double conductivity,
                                           const double diffusivity)
    {
      const double        scale = 2 * diffusivity / std::abs(speed);
      const int           sign  = speed < 0. ? -1 : 1;
      std::vector<double> rise(x.size(), 0.);
      for (std::size_t i = 0; i < x.size(); ++i)
        {
          double  sum = 0., b = sign * (x[i] - x[0]) / scale;
          Moments at_b = moments(b);
          for (std::size_t j = 0; j + 1 < x.size(); ++j)
            {
              // f = f_a + slope (u - a) in u = V (x_i - x')/(2 kappa)
              const double  a     = b;
              const Moments at_a  = at_b;
              b                   = sign * (x[i] - x[j + 1]) / scale;
              at_b                = moments(b);
              const double slope  = (flux[j + 1] - flux[j]) / (b - a),
                           zeroth = at_b.zeroth - at_a.zeroth,
                           first  = at_b.first - at_a.first;
              // dx' = -sign scale du
              sum -=
                sign * scale * ((flux[j] - slope * a) * zeroth + slope * first);
            }
          rise[i] = sum / (pi * conductivity);
        }
      return rise;
    }
  } // namespace References
} // namespace RollingContact
