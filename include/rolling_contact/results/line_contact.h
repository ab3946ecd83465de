#ifndef rolling_contact_results_line_contact_h
#define rolling_contact_results_line_contact_h

#include <rolling_contact/references/hertz_line.h>
#include <rolling_contact/run/results_table.h>
#include <rolling_contact/run/run_report.h>
#include <rolling_contact/scene/pair_spec.h>
#include <rolling_contact/state/steady_state.h>

#include <optional>

namespace RollingContact
{
  /**
   * The pressure of a line contact of finite length in its middle and at its
   * ends. At an end without a crown the pressure grows without limit as
   * elements become smaller: as r^-0.226 with the distance r from the end, for
   * a narrow body with square ends on a wide one. The load over a stated length
   * and the pressure at a stated distance have limits.
   */
  struct LineContact
  {
    double length; ///< from side to side of the narrower body, m

    /** Hertz's contact under the load over the length, which is that of
     * endless cylinders. */
    References::HertzLine hertz;

    double middle_load;     ///< N/m, at y = 0
    double middle_pressure; ///< Pa, at y = 0 the largest

    /** Load of the last end_length at an end over that of as much of the
     * middle, less 1; of both ends that with the larger one. */
    double end_excess;
    double end_length; ///< Hertz's half-width, at most a quarter of the length

    /** The largest pressure (Pa) at end_distance (m) from an end, a quarter of
     * Hertz's half-width, between lines of nodes by a line. */
    double end_pressure;
    double end_distance;
  };

  /**
   * The line contact of a state in 3D; none where surfaces are not straight
   * across, do not touch or the solve failed.
   */
  std::optional<LineContact> line_contact(const PairSpec       &scene,
                                          const SteadyState<3> &steady);

  /** Columns of a line contact, if the state has one. */
  void set_line_contact_columns(const PairSpec       &scene,
                                const SteadyState<3> &steady,
                                ResultsTable         &table);

  /** Say what its middle and its ends carry. */
  void note_line_contact(const PairSpec       &scene,
                         const SteadyState<3> &steady,
                         RunReport            &report);
} // namespace RollingContact

#endif
