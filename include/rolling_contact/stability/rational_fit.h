#ifndef rolling_contact_stability_rational_fit_h
#define rolling_contact_stability_rational_fit_h

#include <rolling_contact/algebra/dense_matrix.h>

namespace RollingContact
{
  /**
   * A rational approximation of many functions of one complex variable at once,
   * barycentric with common support points (AAA: Nakatsukasa, Sete and
   * Trefethen 2018). Smooth functions with a few poles near the points need ten
   * to twenty of them, where polynomials fail without notice.
   */
  class RationalFit
  {
  public:
    RationalFit() = default;

    /**
     * @p values: a row for each of the @p points, a column for each function.
     * Support points are added until the fit agrees with the values to
     * @p tolerance of their largest, or there are @p most_points.
     */
    RationalFit(const ComplexValues &points,
                const ComplexMatrix &values,
                const double         tolerance   = 1e-10,
                const unsigned int   most_points = 40);

    /**
     * All functions at @p s.
     */
    ComplexVector operator()(const std::complex<double> s) const;

    unsigned int n_support_points() const
    {
      return support.size();
    }

    /**
     * Largest difference from the values of the construction, over the largest
     * of them.
     */
    double error() const
    {
      return largest_error;
    }

  private:
    ComplexValues support;
    ComplexVector weights;
    ComplexMatrix at_support; ///< a column for each support point
    double        largest_error = 0.;
  };
} // namespace RollingContact

#endif
