#ifndef rolling_contact_algebra_fourier_h
#define rolling_contact_algebra_fourier_h

#include <complex>
#include <functional>
#include <memory>
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

  /**
   * A symmetric matrix whose entries depend on how many places of a grid of
   * n_x times n_y are between two, along and across, whichever comes first: its
   * products cost Fourier transforms of the grid, four times as large.
   */
  class EvenToeplitz
  {
  public:
    /** @p entry: for distances along and across, not negative. */
    EvenToeplitz(const std::size_t                                  n_x,
                 const std::size_t                                  n_y,
                 const std::function<double(const int, const int)> &entry);

    /** The product with values row by row, x running fastest. */
    std::vector<double> multiply(const std::vector<double> &values);

  private:
    struct Circle;

    const std::size_t       n_x, n_y, wide, high; ///< of the larger grid
    std::shared_ptr<Circle> circle;
    std::vector<double>     factors; ///< of its Fourier sums
  };
} // namespace RollingContact::Signals

#endif
