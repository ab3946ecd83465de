#ifndef rolling_contact_algebra_polynomial_fit_h
#define rolling_contact_algebra_polynomial_fit_h

#include <cstddef>
#include <vector>

namespace RollingContact
{
  /**
   * @p values at the places @p x without the polynomial of this @p degree that
   * fits those from @p first to before @p end best (least squares). The values
   * themselves if there are too few places for it.
   */
  std::vector<double> without_polynomial(const std::vector<double> &x,
                                         std::vector<double>        values,
                                         const std::size_t          first,
                                         const std::size_t          end,
                                         const unsigned int         degree);

  /**
   * The weights of values at the places @p x in the derivative at 0 of the
   * polynomial through them. Units: one over those of x.
   */
  std::vector<double> derivative_weights(const std::vector<double> &x);
} // namespace RollingContact

#endif
