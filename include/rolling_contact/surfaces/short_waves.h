#ifndef rolling_contact_surfaces_short_waves_h
#define rolling_contact_surfaces_short_waves_h

#include <functional>

namespace RollingContact
{
  /**
   * What a height has along a line, from samples four to an element. Units: m;
   * slope 1.
   */
  struct ShortWaves
  {
    double rms           = 0.; ///< about the mean, of the highest stretch
    double below_two     = 0.; ///< rms of waves shorter than two elements
    double below_four    = 0.; ///< ... than four
    double highest       = 0.; ///< |height|
    double steepest      = 0.; ///< |slope| from sample to sample
    double steepest_from = 0.; ///< where
  };

  /**
   * Sample a height from @p begin to @p end, and at least 16 elements around
   * the middle; of long lines 128 stretches of 256 elements. Under Hann's
   * window, the worst of the stretches. Units: m.
   */
  ShortWaves short_waves(const std::function<double(const double)> &height,
                         const double                               begin,
                         const double                               end,
                         const double                               element);
} // namespace RollingContact

#endif
