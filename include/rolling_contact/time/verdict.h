#ifndef rolling_contact_time_verdict_h
#define rolling_contact_time_verdict_h

#include <rolling_contact/algebra/amplitude_trend.h>
#include <rolling_contact/algebra/period.h>

#include <string>

namespace RollingContact::Cycles
{
  enum class Motion
  {
    too_short,  ///< to tell
    periodic,   ///< repeats itself
    stationary, ///< its level stays, but it does not repeat itself
    decayed,    ///< to a part of what it was, and goes on to decay
    changing
  };

  /**
   * What a motion has come to.
   */
  struct Verdict
  {
    Motion         motion = Motion::too_short;
    Period         period; ///< the nearest there is; of no length: none
    AmplitudeTrend amplitude;

    /**
     * Trend of the difference from the motion a whole number of periods, about
     * a quarter of the judged samples, earlier: a second vibration may grow in
     * it.
     */
    AmplitudeTrend differences;

    /** Largest range of a signal at the end, over its range in all samples. */
    double left_over = 1.;

    std::size_t n_judged = 0; ///< samples at the end that it is about
    double      step     = 0.;

    /** Whether nothing new is to be expected. */
    bool is_final() const
    {
      return motion == Motion::periodic || motion == Motion::decayed;
    }

    /** Units: Hz. */
    double frequency() const
    {
      return 1 / (period.length * step);
    }
  };

  /**
   * Judge the last quarter of the samples from @p first on, in which
   *
   *  - periodic: a period of at most a twelfth of it is found, from which the
   *    motion differs by no more than the tolerance over up to half of it; the
   *    amplitude's spread is below the tolerance, and it settles (see
   *    AmplitudeTrend), so that no exponential passes, however slow; and the
   *    differences do not grow exponentially;
   *  - decayed: ranges are below the tolerance times those of all samples and
   *    go on to fall, or below the floors of the signals without growing;
   *  - stationary: the amplitude settles and spreads by less than 5 %.
   */
  Verdict judge(const SampledMotion &motion,
                const std::size_t    first,
                const double         tolerance);

  /**
   * The verdict in words of one column: "periodic", "stationary", "decayed",
   * "changing", "too short".
   */
  std::string name_of(const Motion motion);

  /**
   * The verdict in a sentence, with its numbers.
   */
  std::string sentence(const Verdict &verdict);

  /**
   * Whether a verdict is due after so many samples: at 400 and then every 32nd
   * part more, wherever one begins to ask.
   */
  bool is_due(const std::size_t n_samples);
} // namespace RollingContact::Cycles

#endif
