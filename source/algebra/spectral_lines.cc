#include <rolling_contact/algebra/spectral_lines.h>

#include <algorithm>
#include <cmath>

namespace RollingContact::Signals
{
  namespace
  {
    using Values = std::vector<double>;

    /// over a peak: ground below it is silent
    const double silent = 1e-20;

    /// lines of the spectrum that the mean of the values fills, and the half
    /// width of a tone
    const std::size_t lobe = 2;

    /** Steps from the peak k to the tone it is of. */
    double offset(const Values &P, const std::size_t k)
    {
      const bool   up    = P[k + 1] > P[k - 1];
      const double ratio = std::sqrt(P[up ? k + 1 : k - 1] / P[k]);
      const double steps = (2 * ratio - 1) / (ratio + 1);
      return std::clamp(up ? steps : -steps, -0.5, 0.5);
    }

    /** Sum of the densities of the peak k down to the ground. */
    double sum_of_peak(const Values &P, const std::size_t k)
    {
      double sum = P[k];
      for (std::size_t i = 1; i <= lobe && P[k - i] <= P[k - i + 1]; ++i)
        sum += P[k - i];
      for (std::size_t i = 1;
           i <= lobe && k + i < P.size() && P[k + i] <= P[k + i - 1];
           ++i)
        sum += P[k + i];
      return sum;
    }

    /** Height of the peak k above the ground between it and higher ones, as a
     * ratio of densities. */
    double prominence(const Values &P, const std::size_t k)
    {
      double left = P[k], right = P[k];
      for (std::size_t i = k; i-- > 1 && P[i] <= P[k];)
        left = std::min(left, P[i]);
      for (std::size_t i = k + 1; i < P.size() && P[i] <= P[k]; ++i)
        right = std::min(right, P[i]);
      return P[k] / std::max({left, right, silent * P[k]});
    }
  } // namespace

  std::vector<SpectralLine> spectral_lines(const PowerSpectrum &spectrum,
                                           const LineCriteria  &criteria)
  {
    const Values             &P = spectrum.density;
    std::vector<SpectralLine> lines;
    if (P.size() < 2 * lobe + 2)
      return lines;
    const double least = std::pow(10., -criteria.range / 10) *
                         *std::max_element(P.begin() + 1, P.end()),
                 highest = criteria.highest > 0.
                             ? criteria.highest
                             : spectrum.step * static_cast<double>(P.size());
    for (std::size_t k = lobe + 1; k + 1 < P.size(); ++k)
      if (P[k] > P[k - 1] && P[k] >= P[k + 1] && P[k] > least)
        {
          const double above = prominence(P, k);
          lines.push_back(
            {spectrum.step * (static_cast<double>(k) + offset(P, k)),
             spectrum.step * sum_of_peak(P, k),
             10 * std::log10(above)});
        }
    const auto drop = [&](const auto &condition) {
      lines.erase(std::remove_if(lines.begin(), lines.end(), condition),
                  lines.end());
    };
    drop([&](const SpectralLine &line) {
      return line.prominence < criteria.prominence || line.frequency > highest;
    });
    std::stable_sort(lines.begin(),
                     lines.end(),
                     [](const SpectralLine &a, const SpectralLine &b) {
                       return a.mean_square > b.mean_square;
                     });
    lines.resize(std::min(lines.size(), criteria.most));
    std::sort(lines.begin(),
              lines.end(),
              [](const SpectralLine &a, const SpectralLine &b) {
                return a.frequency < b.frequency;
              });
    return lines;
  }
} // namespace RollingContact::Signals
