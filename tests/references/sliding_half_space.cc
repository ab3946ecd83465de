#include "sliding_half_space.h"

#include <rolling_contact/references/checks.h>

#include <algorithm>
#include <cmath>

namespace RollingContact::References
{
  namespace
  {
    using Complex = std::complex<double>;

    /**
     * The equation of the waves and its derivative by c.
     */
    struct WaveEquation
    {
      double mu;             ///< with the sense of sliding
      double squared_speeds; ///< (c_2 / c_1)^2

      static Complex root(const Complex x)
      {
        const Complex r = std::sqrt(x);
        return r.real() > 0. ? r : -r;
      }

      Complex operator()(const Complex c, Complex &derivative) const
      {
        const Complex i(0., 1.),
          a = root(1. - c * c * squared_speeds), b = root(1. - c * c),
          a_slope = -c * squared_speeds / a, b_slope = -c / b;
        derivative = i * (a_slope * c * c + 2. * a * c) -
                     2. * mu * (c + a_slope * b + a * b_slope);
        return i * a * c * c + mu * (2. - c * c - 2. * a * b);
      }
    };

    /**
     * Newton's method with steps of 0.1 at most; zero if it finds nothing.
     */
    Complex newton(const WaveEquation &equation, Complex c)
    {
      const double longest = 0.1, smallest = 1e-13, least_residual = 1e-10;
      Complex      slope;
      for (unsigned int step = 0; step < 60; ++step)
        {
          const Complex value = equation(c, slope);
          if (slope == 0.)
            break;
          Complex change = value / slope;
          change /= std::max(1., std::abs(change) / longest);
          c -= change;
          if (std::abs(change) < smallest)
            break;
        }
      return std::abs(equation(c, slope)) < least_residual ? c : 0.;
    }
  } // namespace

  std::vector<std::complex<double>>
  growing_sliding_waves(const double mu, const double poisson_ratio)
  {
    check_not_negative("Friction coefficient", mu);
    if (!(poisson_ratio > -1.) || !(poisson_ratio < 0.5))
      reject("Poisson's ratio",
             poisson_ratio,
             "",
             "greater than -1 and less than 1/2");
    const double         least_growth = 1e-7, least_speed = 1e-3, same = 1e-7;
    std::vector<Complex> waves;
    for (const double sense : {1., -1.})
      {
        const WaveEquation equation{sense * mu,
                                    (1 - 2 * poisson_ratio) /
                                      (2 * (1 - poisson_ratio))};
        for (unsigned int k = 0; k < 40; ++k)
          for (const double growth : {1e-3, 0.05, 0.2, 0.6})
            {
              const Complex c =
                newton(equation, {0.05 + 2.95 * k / 39, growth});
              const bool known =
                std::any_of(waves.begin(), waves.end(), [&](const Complex z) {
                  return std::abs(z - c) < same;
                });
              if (c.imag() > least_growth && c.real() > -1e-9 &&
                  std::abs(c) > least_speed && !known)
                waves.push_back(c);
            }
      }
    return waves;
  }
} // namespace RollingContact::References
