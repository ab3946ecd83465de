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
   * A block Toeplitz matrix with Toeplitz blocks, symmetric both along and
   * across a grid of n_x times n_y places: an entry depends on how many places
   * along and across two are apart. Its products are those of a circulant
   * matrix of twice as many places in each direction, by Fourier transforms. To
   * be used by one thread; copies share their work space.
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

    const std::size_t       n_x, n_y;
    const std::size_t       wide, high; ///< of the circulant matrix
    std::shared_ptr<Circle> circle;
    std::vector<double>     factors; ///< its eigenvalues
  };
} // namespace RollingContact::Signals

#endif
