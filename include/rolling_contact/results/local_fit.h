#ifndef rolling_contact_results_local_fit_h
#define rolling_contact_results_local_fit_h

#include <array>
#include <vector>

namespace RollingContact
{
  /**
   * A place where a value is known, from the origin, and what its square counts
   * for in a fit.
   */
  struct KnownPlace
  {
    std::array<double, 3> at;
    double                weight;
  };

  /**
   * What the values at known places count for in the value in the origin of the
   * polynomials that are fitted to them by least squares.
   */
  struct FitWeights
  {
    std::vector<double> quadratic, linear;
  };

  /**
   * Fit complete polynomials of the first @p n_coordinates. Where the places do
   * not determine a curvature or slope, as in a single layer, it is zero.
   */
  FitWeights fit_in_origin(const std::vector<KnownPlace> &places,
                           const unsigned int             n_coordinates);
} // namespace RollingContact

#endif
