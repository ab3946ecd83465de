#include <rolling_contact/algebra/spectrogram.h>

#include <algorithm>

namespace RollingContact::Signals
{
  namespace
  {
    /// of Hann's window, in lines
    const double noise_bandwidth = 1.5;
  } // namespace

  Spectrogram spectrogram(const std::vector<double> &values,
                          const double               time_step,
                          const std::size_t          window,
                          const std::size_t          most)
  {
    Spectrogram result;
    if (window < 4 || values.size() < window)
      return result;
    const std::size_t room    = values.size() - window,
                      advance = std::max(
                        {std::size_t(1), window / 4, (room + most - 1) / most});
    for (std::size_t first = 0; first <= room; first += advance)
      {
        const auto          begin = values.begin() + first;
        const PowerSpectrum spectrum =
          welch({begin, begin + window}, time_step, window);
        result.frequency_step = spectrum.step;
        result.times.push_back(time_step * (static_cast<double>(first) +
                                            static_cast<double>(window) / 2));
        result.mean_squares.push_back(spectrum.density);
        for (double &value : result.mean_squares.back())
          value *= noise_bandwidth * spectrum.step;
      }
    return result;
  }
} // namespace RollingContact::Signals
