#ifndef rolling_contact_algebra_amplitude_trend_h
#define rolling_contact_algebra_amplitude_trend_h

#include <rolling_contact/algebra/sampled_motion.h>

namespace RollingContact::Cycles
{
  /**
   * How the amplitude of a motion changes over its samples: the rms value of
   * all signals about their means, in their scales, of eight overlapping
   * stretches with Hann's weights.
   */
  struct AmplitudeTrend
  {
    double mean   = 0.; ///< of the stretches
    double spread = 0.; ///< largest minus smallest, over the mean

    /**
     * Growth rate: slope of the straight line through the logarithms of the
     * amplitudes. Units: 1/s.
     */
    double rate = 0.;

    /** Uncertainty of the growth rate: twice its standard error. Units: 1/s. */
    double uncertainty = 0.;

    /** Slope of the second half over that of the first: 1 for what grows or
     * decays exponentially, below 1 for what comes to an end. */
    double ratio = 0.;

    /** Whether the line is not level by more than chance, four standard errors,
     * and rounding would have it. */
    bool changes = false;

    /** What is still to come over the level, if changes go on in this ratio:
     * those of the second half times r / (1 - r); infinite for r >= 1, the
     * spread if nothing changes or changes turn round. */
    double remaining = 0.;

    /**
     * Whether changes come to an end: there are none, those of the second half
     * are less than half of those of the first, or they turn round. What goes
     * on exponentially never settles, however slowly.
     */
    bool settles() const
    {
      return !changes || ratio <= 0.5;
    }
  };

  /**
   * The trend; stretches are a whole number of periods long if there is a
   * @p period (in steps, else 0), so that they do not see its phase.
   */
  AmplitudeTrend amplitude_trend(const SampledMotion       &motion,
                                 const std::vector<double> &scales,
                                 const double               period);
} // namespace RollingContact::Cycles

#endif
