#ifndef rolling_contact_algebra_fourier_h
#define rolling_contact_algebra_fourier_h

#include <complex>
#include <vector>

namespace RollingContact::Signals
{
  /**
   * The Fourier sums X_k = sum_j x_j exp(-2 pi i j k / n), k = 0 ... n/2, of n
   * real values, by FFTW.
   */
  std::vector<std::complex<double>> fourier_sums(std::vector<double> values);

  /**
   * The n values of fourier_sums(), which it inverts.
   */
  std::vector<double>
  values_of_fourier_sums(std::vector<std::complex<double>> sums,
                         const std::size_t                 n);

  /**
   * Amplitudes a_k with x_j = sum_k a_k cos(pi j k / (n - 1)) of values that
   * continue as mirror images beyond both ends (discrete cosine transform of
   * the first kind). At least two values.
   */
  std::vector<double> cosine_amplitudes(std::vector<double> values);

  /**
   * The values of cosine_amplitudes(), which it inverts.
   */
  std::vector<double>
  values_of_cosine_amplitudes(std::vector<double> amplitudes);
} // namespace RollingContact::Signals

#endif
