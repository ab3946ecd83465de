#include <rolling_contact/algebra/third_octaves.h>

#include <algorithm>
#include <cmath>

namespace RollingContact::Signals
{
  double ThirdOctave::lower_edge() const
  {
    return centre * std::pow(10., -0.05);
  }

  double ThirdOctave::upper_edge() const
  {
    return centre * std::pow(10., 0.05);
  }

  std::vector<ThirdOctave> third_octaves(const PowerSpectrum &spectrum)
  {
    const double least_lines = 4.;
    const double step        = spectrum.step,
                 highest     = step * (spectrum.density.size() - 1);
    std::vector<ThirdOctave> bands;
    if (!(step > 0.) || spectrum.density.size() < 2)
      return bands;
    for (int k = static_cast<int>(std::floor(10 * std::log10(step)));; ++k)
      {
        ThirdOctave band;
        band.centre        = std::pow(10., k / 10.);
        const double lower = band.lower_edge(), upper = band.upper_edge();
        if (upper > highest * (1 + 1e-12))
          return bands;
        if (upper - lower >= least_lines * step)
          {
            double sum = 0.;
            for (std::size_t line = 1; line < spectrum.density.size(); ++line)
              {
                const double share =
                  std::min(upper / step, line + 0.5) -
                  std::max(lower / step, static_cast<double>(line) - 0.5);
                if (share > 0.)
                  sum += share * spectrum.density[line] * step;
              }
            band.mean_square = sum;
          }
        bands.push_back(band);
      }
  }

  double level(const double mean_square, const double reference)
  {
    return 10 * std::log10(mean_square / (reference * reference));
  }
} // namespace RollingContact::Signals
