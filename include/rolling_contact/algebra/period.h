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
   * The shortest period by which the motion differs from itself by no more than
   * @p tolerance; else the one, of those looked at, by which it differs least.
   * The length 0 if none comes near. Looked for up to a twelfth of the samples.
   * A period of which another that leaves less than twice as much is a part
   * gives way to that one: a motion that is about to repeat itself has no
   * period of twice its length.
   *
   * Candidates are the minima of the mean square difference of all signals to
   * themselves tau later, by fast Fourier transforms; each is then refined with
   * longer and longer lags by cubic interpolation between samples. After A. de
   * Cheveigne and H. Kawahara, J. Acoust. Soc. Am. 111 (2002) 1917-1930, whose
   * difference function this is for several signals.
   */
  Period find_period(const SampledMotion       &motion,
                     const std::vector<double> &scales,
                     const double               tolerance);
} // namespace RollingContact::Cycles

#endif
