#ifndef rolling_contact_stability_threshold_h
#define rolling_contact_stability_threshold_h

#include <functional>
#include <optional>

namespace RollingContact
{
  /**
   * How far a change is followed, from 0 on. Units: those of the change.
   */
  struct ThresholdSearch
  {
    double first = 0.25; ///< step, doubled until the verdict changes
    double most  = 1.;
    double width = 0.01; ///< of the interval that is left in the end
  };

  /**
   * The interval of a change within which growth begins or ends, as far as the
   * growth is known: none (crossed = false) if the verdict is the same up to
   * `behind`, or if the growth is not known there.
   */
  struct Threshold
  {
    bool         crossed       = false;
    bool         known         = true; ///< the growth at `behind`
    double       before        = 0.;   ///< the verdict is that at 0
    double       behind        = 0.;
    double       growth_before = 0.;
    double       growth_behind = 0.;
    unsigned int n_states      = 0; ///< growths asked for

    /** The slope of growth over the change, across the interval. */
    double slope() const
    {
      return (growth_behind - growth_before) / (behind - before);
    }
  };

  /**
   * Find the first change at which a growth has another sign than @p at_zero,
   * first by steps that double, then between the last two by secants, and by
   * halves where secants leave more than that. @p growth may jump, and return
   * nothing where it is not known. A growth of exactly 0 counts as none.
   */
  Threshold
  first_threshold(const double                                        at_zero,
                  const std::function<std::optional<double>(double)> &growth,
                  const ThresholdSearch &search = {});
} // namespace RollingContact

#endif
