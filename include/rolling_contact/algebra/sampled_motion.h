#ifndef rolling_contact_algebra_sampled_motion_h
#define rolling_contact_algebra_sampled_motion_h

#include <cstddef>
#include <vector>

namespace RollingContact::Cycles
{
  /**
   * Values at equal steps of one quantity of a motion.
   */
  struct Signal
  {
    std::vector<double> values;

    /** Signals of the same kind have the same unit. */
    unsigned int kind = 0;

    /** A range below this is nothing; in the unit of the signal. */
    double floor = 0.;
  };

  /**
   * Quantities of a motion at the same equal steps.
   */
  struct SampledMotion
  {
    double              step = 0.; ///< s
    std::vector<Signal> signals;

    std::size_t n_samples() const
    {
      return signals.empty() ? 0 : signals.front().values.size();
    }

    /**
     * The samples from @p first to before @p end.
     */
    SampledMotion part(const std::size_t first, const std::size_t end) const;
  };

  /** Largest minus smallest value. */
  double range_of(const std::vector<double> &values);

  /**
   * What the signals are measured by: their range, but at least a thousandth of
   * the largest of their kind; 0 for a kind whose ranges are all below their
   * floors.
   */
  std::vector<double> scales_of(const SampledMotion &motion);

  /**
   * The value between samples by the cubic through the four next to it, at a
   * place counted in steps, which lies among the samples.
   */
  double value_at(const std::vector<double> &values, const double place);
} // namespace RollingContact::Cycles

#endif
