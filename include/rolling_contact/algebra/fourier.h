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
   * Values at equal spacing along a direction of a grid, which come again
   * behind the last one or go on as mirror images about the first and the last.
   * Units: of length.
   */
  struct GridDirection
  {
    std::size_t n       = 1;
    double      spacing = 1.;
    bool        again   = false;
  };

  /**
   * Multiply each wave of values on a grid, row by row along the first
   * direction, by a @p factor of its wave numbers along and across, by FFTW: no
   * wave is shifted. The n waves of a direction are those with k / (n spacing),
   * k up to n / 2, of values that come again, and cosines with
   * k / (2 (n - 1) spacing), k < n, of mirror images. Units: waves per length.
   */
  void
  scale_waves(std::vector<double>                                     &values,
              const GridDirection                                     &along,
              const GridDirection                                     &across,
              const std::function<double(const double, const double)> &factor);

  /**
   * Sums over the places of a grid, n_x times n_y of them, of influences that
   * depend on how far two places are apart: from several components of a field
   * to as many others, a block Toeplitz matrix with Toeplitz blocks for each
   * pair of components. Products are those of circulant matrices at least twice
   * as large in each direction, by Fourier transforms: n log n for n places.
   * May be used by several threads at once.
   */
  class GridConvolution
  {
  public:
    /**
     * How component @p of at a place is moved by component @p by of a place so
     * many @p along and @p across before it, which may be negative.
     */
    using Influence = std::function<double(const int          along,
                                           const int          across,
                                           const unsigned int of,
                                           const unsigned int by)>;

    GridConvolution(const std::size_t  n_x,
                    const std::size_t  n_y,
                    const unsigned int n_components,
                    const Influence   &influence);

    /**
     * Components @p of_first to @p of_end of the product with @p values, which
     * are those of components @p by_first and after, one after the other, each
     * row by row with x running fastest.
     */
    std::vector<double> multiply(const std::vector<double> &values,
                                 const unsigned int         by_first = 0,
                                 const unsigned int         of_first = 0,
                                 const unsigned int         of_end   = 1) const;

    /**
     * Values whose product in one @p component is about as given, as if the
     * circulant matrix were the whole: a preconditioner where the influence is
     * even and falls with the distance.
     */
    std::vector<double> divide(const std::vector<double> &product,
                               const unsigned int         component) const;

    std::size_t memory_consumption() const;

  private:
    struct Circle;

    using Sums = std::vector<std::complex<double>>;

    const std::size_t             n_x, n_y;
    const unsigned int            n_components;
    std::shared_ptr<const Circle> circle;
    std::vector<Sums>             factors; ///< of a pair of components
  };
} // namespace RollingContact::Signals

#endif
