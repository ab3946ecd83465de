#include <rolling_contact/base/percentages.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace RollingContact
{
  std::vector<int> percentages(const std::vector<double> &values)
  {
    const double     sum = std::accumulate(values.begin(), values.end(), 0.);
    std::vector<int> shares(values.size(), 0);
    if (!(sum > 0.))
      return shares;
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), 0);
    std::vector<double> lost;
    int                 missing = 100;
    for (std::size_t i = 0; i < values.size(); ++i)
      {
        const double exact = 100 * values[i] / sum;
        shares[i]          = static_cast<int>(std::floor(exact));
        lost.push_back(exact - shares[i]);
        missing -= shares[i];
      }
    std::stable_sort(order.begin(),
                     order.end(),
                     [&](const std::size_t i, const std::size_t j) {
                       return lost[i] > lost[j];
                     });
    for (int k = 0; k < missing; ++k)
      ++shares[order[k % order.size()]];
    return shares;
  }
} // namespace RollingContact
