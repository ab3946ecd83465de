#include <rolling_contact/modes/track_decay.h>

#include <array>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /// places to strike at, in bays
    const std::array<double, 29> bays{
      {0.,  0.25, 0.5, 0.75, 1.,  1.25, 1.5, 1.75, 2.,  2.25,
       2.5, 3.,   3.5, 4.,   5.,  6.,   7.,  8.,   10., 12.,
       16., 20.,  24., 30.,  36., 42.,  48., 54.,  66.}};

    /// 10 lg e, dB
    const double decibels_of_energy = 10 / std::log(10.);

    const std::vector<DecayBand> all_bands{{100., {}, {}},
                                           {125., {}, {}},
                                           {160., {}, {}},
                                           {200., {}, {}},
                                           {250., 2., 2.04},
                                           {315., 2., 1.38},
                                           {400., 6., 0.94},
                                           {500., 6., 0.64},
                                           {630., 6., 0.43},
                                           {800., 2.19, .29},
                                           {1000., 0.8, 0.2},
                                           {1250., 0.8, 0.2},
                                           {1600., .8, .32},
                                           {2000., 0.8, 0.5},
                                           {2500., 0.8, 0.5},
                                           {3150., 0.8, 0.5},
                                           {4000., 0.8, 0.5},
                                           {5000., 0.8, 0.5}};
  } // namespace

  DecayGrid::DecayGrid(const double bay)
  {
    for (const double n : bays)
      x.push_back(n * bay);
  }

  double DecayGrid::rate(const std::vector<double> &energies) const
  {
    double sum = 0.;
    for (std::size_t n = 0; n < x.size(); ++n)
      {
        const double behind = n == 0 ? 0. : x[n] - x[n - 1],
                     ahead  = n + 1 == x.size() ? behind : x[n + 1] - x[n];
        sum += energies[n] * (behind + ahead) / 2;
      }
    return decibels_of_energy * energies[0] / sum;
  }

  double DecayGrid::floor() const
  {
    return decibels_of_energy / x.back();
  }

  Signals::ThirdOctave DecayBand::exact() const
  {
    Signals::ThirdOctave band;
    band.centre = std::pow(10., std::round(10 * std::log10(nominal)) / 10);
    return band;
  }

  std::vector<double> DecayBand::mean(
    const unsigned int                                      n_lines,
    const std::function<std::vector<double>(const double)> &at) const
  {
    const auto   band  = exact();
    const double width = (band.upper_edge() - band.lower_edge()) / n_lines;
    std::vector<double> sum;
    for (unsigned int line = 0; line < n_lines; ++line)
      {
        const std::vector<double> values =
          at(band.lower_edge() + (line + 0.5) * width);
        sum.resize(values.size(), 0.);
        for (std::size_t i = 0; i < sum.size(); ++i)
          sum[i] += values[i] / n_lines;
      }
    return sum;
  }

  std::vector<DecayBand> decay_bands(const double lowest, const double highest)
  {
    std::vector<DecayBand> result;
    for (const DecayBand &band : all_bands)
      if (band.nominal >= lowest && band.nominal <= highest)
        result.push_back(band);
    return result;
  }
} // namespace RollingContact
