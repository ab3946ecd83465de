#include <rolling_contact/algebra/fourier.h>
#include <rolling_contact/algebra/welch.h>
#include <rolling_contact/base/constants.h>

#include <cmath>
#include <numeric>

namespace RollingContact::Signals
{
  namespace
  {
    /** Hann's window, periodic; its squares sum up to 3 n / 8. */
    std::vector<double> hann(const std::size_t n)
    {
      std::vector<double> window(n);
      for (std::size_t j = 0; j < n; ++j)
        window[j] = (1 - std::cos(2 * pi * j / n)) / 2;
      return window;
    }
  } // namespace

  std::size_t chosen_segment(const std::size_t n_values)
  {
    return n_values < 256 ? n_values : n_values / 4;
  }

  std::vector<std::vector<std::complex<double>>>
  segment_amplitudes(const std::vector<double> &values,
                     const std::size_t          segment)
  {
    const std::vector<double> window = hann(segment);
    const double              mean =
      std::accumulate(values.begin(), values.end(), 0.) / values.size();
    std::vector<std::vector<std::complex<double>>> amplitudes;
    const std::size_t advance = segment - segment / 2;
    for (std::size_t first = 0; first + segment <= values.size();
         first += advance)
      {
        std::vector<double> part(segment);
        for (std::size_t j = 0; j < segment; ++j)
          part[j] = window[j] * (values[first + j] - mean);
        amplitudes.push_back(fourier_sums(std::move(part)));
      }
    const double squares =
      std::inner_product(window.begin(), window.end(), window.begin(), 0.);
    const double once  = 1 / std::sqrt(squares * segment * amplitudes.size()),
                 twice = std::sqrt(2.) * once; // stands for -f as well
    for (auto &lines : amplitudes)
      for (std::size_t k = 0; k < lines.size(); ++k)
        lines[k] *= k > 0 && 2 * k < segment ? twice : once;
    return amplitudes;
  }

  PowerSpectrum welch(const std::vector<double> &values,
                      const double               time_step,
                      const std::size_t          segment)
  {
    const auto    amplitudes = segment_amplitudes(values, segment);
    PowerSpectrum spectrum;
    spectrum.step       = 1 / (segment * time_step);
    spectrum.n_segments = amplitudes.size();
    spectrum.density.assign(segment / 2 + 1, 0.);
    for (const auto &lines : amplitudes)
      for (std::size_t k = 0; k < lines.size(); ++k)
        spectrum.density[k] += std::norm(lines[k]) / spectrum.step;
    return spectrum;
  }
} // namespace RollingContact::Signals
