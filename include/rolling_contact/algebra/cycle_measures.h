#ifndef rolling_contact_algebra_cycle_measures_h
#define rolling_contact_algebra_cycle_measures_h

#include <cstddef>
#include <vector>

namespace RollingContact::Cycles
{
  /**
   * The last whole periods of samples, up to the last of them: what means over
   * a limit cycle are taken of.
   */
  class WholePeriods
  {
  public:
    /**
     * At most 16 periods of this length (in steps), of the last @p n_judged of
     * @p n_samples samples.
     */
    WholePeriods(const double      period,
                 const std::size_t n_samples,
                 const std::size_t n_judged);

    std::size_t number() const
    {
      return n_periods;
    }

    /** The first sample in them. */
    std::size_t first_sample() const;

    /** Mean over time, of what is linear between samples. */
    double mean(const std::vector<double> &values) const;

    /** Root of the mean square about the mean. */
    double rms(const std::vector<double> &values) const;

    /** Smallest and largest sample. */
    double least(const std::vector<double> &values) const;
    double most(const std::vector<double> &values) const;

    /** By how much what adds up over time grows in a period. */
    double change(const std::vector<double> &sums) const;

    /**
     * Amplitudes of the first harmonics of the period, by least squares on all
     * samples: x = c + sum_k a_k cos(2 pi k t / T - phi_k). As many as are
     * below half of the sampling rate, at most @p n.
     */
    std::vector<double> harmonics(const std::vector<double> &values,
                                  const std::size_t          n) const;

  private:
    const double      period;
    const std::size_t n_samples;
    std::size_t       n_periods;
    double            begin; ///< in steps
  };
} // namespace RollingContact::Cycles

#endif
