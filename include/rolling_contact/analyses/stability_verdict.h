#ifndef rolling_contact_analyses_stability_verdict_h
#define rolling_contact_analyses_stability_verdict_h

#include <rolling_contact/analyses/stability_thresholds.h>

#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * "3 modes grow, ...; the fastest at 1038 Hz by 1 1/s, ...", with what a
   * second count says.
   */
  std::string verdict(const Situation            &scene,
                      const std::vector<Finding> &findings,
                      const std::string          &counted);

  /**
   * "stopped first by ..., also by ..." of a state that squeals, the smallest
   * change first, and "begins to grow at ..." of one that does not; empty
   * without thresholds.
   */
  std::string text_of(const std::vector<DrivingThreshold> &thresholds);

  /**
   * Tells the summary and writes thresholds.csv, a row for each quantity that
   * was followed, and verdict.md: which modes grow, by names, and the
   * thresholds, in words. @p names are those of the findings, see
   * name_of_vibration().
   */
  void tell_verdict(const Situation                     &scene,
                    const std::vector<Finding>          &findings,
                    const std::vector<std::string>      &names,
                    const std::string                   &counted,
                    const std::vector<DrivingThreshold> &thresholds,
                    RunContext                          &context);
} // namespace RollingContact

#endif
