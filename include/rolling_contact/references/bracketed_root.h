#ifndef rolling_contact_references_bracketed_root_h
#define rolling_contact_references_bracketed_root_h

#include <functional>

namespace RollingContact::References
{
  /**
   * Root of a continuous function between lower and upper, where it has
   * opposite signs (Alefeld, Potra and Shi 1995, algorithm 748). The bracket
   * shrinks to 4 eps max(1, |root|): meant for logarithms, where that is a
   * relative error of the quantity itself.
   */
  double bracketed_root(const std::function<double(double)> &function,
                        const double                         lower,
                        const double                         upper);
} // namespace RollingContact::References

#endif
