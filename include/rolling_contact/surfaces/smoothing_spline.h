#ifndef rolling_contact_surfaces_smoothing_spline_h
#define rolling_contact_surfaces_smoothing_spline_h

#include <vector>

namespace RollingContact::Profiles
{
  /**
   * The natural cubic spline f with
   *
   *   sum w_i (v_i - f(x_i))^2 + lambda integral f''^2 dx  least,
   *
   * w_i the length that stands for point i and lambda = (L / 2 pi)^4, so that
   * waves of the length L are halved; L = 0 interpolates. After Reinsch,
   * Smoothing by spline functions, Numerische Mathematik 10 (1967). Units:
   * those of x and v.
   */
  struct SmoothingSpline
  {
    /**
     * @p x ascends, three points or more.
     */
    SmoothingSpline(const std::vector<double> &x,
                    const std::vector<double> &values,
                    const double               length);

    std::vector<double> values; ///< f at the points
    std::vector<double> slopes; ///< f'
  };
} // namespace RollingContact::Profiles

#endif
