#include <boost/math/quadrature/gauss.hpp>

#include <rolling_contact/surfaces/conicity.h>

#include <algorithm>
#include <cmath>

namespace RollingContact::Profiles
{
  namespace
  {
    const unsigned int n_phases = 4000; // of a quarter of the oscillation
  }

  double RadiusDifference::at(const double there) const
  {
    const std::size_t k = std::clamp<std::ptrdiff_t>(
      std::upper_bound(shift.begin(), shift.end(), there) - shift.begin() - 1,
      0,
      shift.size() - 2);
    const double t = (there - shift[k]) / (shift[k + 1] - shift[k]);
    return (1 - t) * difference[k] + t * difference[k + 1];
  }

  bool RadiusDifference::covers(const double amplitude) const
  {
    const double rounding = 1e-9 * amplitude;
    return shift.size() > 1 && shift.front() <= -amplitude + rounding &&
           shift.back() >= amplitude - rounding;
  }

  double harmonic_conicity(const RadiusDifference &dr, const double amplitude)
  {
    double sum = 0.;
    for (unsigned int k = 0; k < 4 * n_phases; ++k)
      {
        const double sine = std::sin(M_PI / 2 * (k + 0.5) / n_phases);
        sum += dr.at(amplitude * sine) * sine;
      }
    return sum / (4 * n_phases) / amplitude;
  }

  double equivalent_conicity(const RadiusDifference &dr, const double amplitude)
  {
    // energy P(y) = integral of dr about the middle, mean of both sides
    const auto restoring = [&](const double y) {
      return (dr.at(y) - dr.at(-y)) / 2;
    };
    // P(A) - P(A sin phi) at the ends and, of odd index, the middles of steps
    std::vector<double> energy(2 * n_phases + 1, 0.);
    const auto          place = [&](const unsigned int k) {
      return amplitude * std::sin(M_PI / 4 * k / n_phases);
    };
    for (unsigned int k = 2 * n_phases; k-- > 0;)
      energy[k] =
        energy[k + 1] +
        boost::math::quadrature::gauss<double, 7>::integrate(restoring,
                                                             place(k),
                                                             place(k + 1));
    // a quarter of the wave: integral of dy / sqrt(2 (P(A) - P(y)) / (e r0))
    double quarter = 0.;
    for (unsigned int k = 0; k < 2 * n_phases; k += 2)
      {
        if (!(energy[k + 1] > 0.))
          return std::nan("");
        quarter += (place(k + 2) - place(k)) / std::sqrt(2 * energy[k + 1]);
      }
    const double wave = 4 * quarter;
    return std::pow(2 * M_PI / wave, 2) / 2;
  }
} // namespace RollingContact::Profiles
