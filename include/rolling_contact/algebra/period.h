#ifndef rolling_contact_algebra_period_h
#define rolling_contact_algebra_period_h

#include <rolling_contact/algebra/sampled_motion.h>

namespace RollingContact::Cycles
{
  /**
   * A time after which a motion repeats itself, more or less.
   */
  struct Period
  {
    double length = 0.; ///< steps, between samples as well

    /** The largest rms difference of a signal to itself one, two, four, ...
     * periods before, over its scale; so many as fit into half of the samples,
     * so that neither a slow beat nor a slow drift is missed. */
    double difference = 0.;
  };

  /**
   * The shortest period after which the motion differs from itself by no more
   * than @p tolerance. If there is none, the one with the least difference of
   * those that were tried; the length is 0 if none comes near. Periods are
   * tried up to a twelfth of the samples. If a period is a multiple of another
   * one whose difference is less than twice as large, the shorter one is taken:
   * a motion that nearly repeats itself does not get twice its period.
   *
   * Candidates are the minima of the mean square difference of all signals to
   * themselves tau later, by fast Fourier transforms. Each is then refined with
   * longer and longer lags by cubic interpolation between samples. The
   * difference function is that of A. de Cheveigne and H. Kawahara, J. Acoust.
   * Soc. Am. 111 (2002) 1917-1930, for several signals.
   */
  Period find_period(const SampledMotion       &motion,
                     const std::vector<double> &scales,
                     const double               tolerance);
} // namespace RollingContact::Cycles

#endif
