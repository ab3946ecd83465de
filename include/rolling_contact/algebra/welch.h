#ifndef rolling_contact_algebra_welch_h
#define rolling_contact_algebra_welch_h

#include <complex>
#include <cstddef>
#include <vector>

namespace RollingContact::Signals
{
  /**
   * One-sided power spectral density at the frequencies k * step, k = 0, 1, ...
   * up to half the sampling rate. Its sum times step is the mean square.
   */
  struct PowerSpectrum
  {
    double              step = 0.; ///< Hz
    std::vector<double> density;   ///< square of the values' unit / Hz
    std::size_t         n_segments = 0;
  };

  /**
   * Number of values in a segment that is chosen for so many values: a quarter
   * of them, which makes seven segments that overlap by half, or all of them if
   * there are fewer than 256.
   */
  std::size_t chosen_segment(const std::size_t n_values);

  /**
   * Amplitudes of the lines of the segments that welch() takes, by segment: the
   * squares of their sizes, summed over the segments, are its densities times
   * the step between its lines.
   */
  std::vector<std::vector<std::complex<double>>>
  segment_amplitudes(const std::vector<double> &values,
                     const std::size_t          segment);

  /**
   * The spectrum of values at equal time steps about their mean, after Welch
   * (IEEE Trans. Audio Electroacoust. 15, 1967): the mean over segments that
   * overlap by half, under Hann's window. A tone of amplitude A in the middle
   * of a line's band has A^2/2 there and in the two lines beside it. What is
   * left behind the last whole segment does not count. A segment has at least
   * 4 values and at most all. Units: s.
   */
  PowerSpectrum welch(const std::vector<double> &values,
                      const double               time_step,
                      const std::size_t          segment);
} // namespace RollingContact::Signals

#endif
