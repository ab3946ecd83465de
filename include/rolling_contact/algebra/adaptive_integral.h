#ifndef rolling_contact_algebra_adaptive_integral_h
#define rolling_contact_algebra_adaptive_integral_h

#include <Eigen/Core>

#include <functional>

namespace RollingContact
{
  /**
   * An integral of several functions at once.
   */
  struct AdaptiveIntegral
  {
    Eigen::ArrayXd value;
    Eigen::ArrayXd error; ///< estimated, by far too large where it is small
    bool           converged = true;
  };

  /**
   * The integrals of @p f from a to b by Gauss and Kronrod's rule of 15 points
   * on @p n_cells cells, of which the one with the largest error is halved
   * until the errors of the first @p n_watched are below a tolerance relative
   * to these integrals, or n_most cells are reached.
   */
  AdaptiveIntegral
  adaptive_integral(const std::function<Eigen::ArrayXd(const double)> &f,
                    const double                                       a,
                    const double                                       b,
                    const std::size_t n_watched,
                    const double      tolerance,
                    const std::size_t n_cells = 2,
                    const std::size_t n_most  = 400);
} // namespace RollingContact

#endif
