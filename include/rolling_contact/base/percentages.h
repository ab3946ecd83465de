#ifndef rolling_contact_base_percentages_h
#define rolling_contact_base_percentages_h

#include <vector>

namespace RollingContact
{
  /**
   * Shares of values in their sum, in whole percent that add up to 100: rounded
   * down, the rest given to those that lost most. All zero if the sum is.
   */
  std::vector<int> percentages(const std::vector<double> &values);
} // namespace RollingContact

#endif
