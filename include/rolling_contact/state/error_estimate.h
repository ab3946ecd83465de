#ifndef rolling_contact_state_error_estimate_h
#define rolling_contact_state_error_estimate_h

#include <optional>

namespace RollingContact
{
  /**
   * How much the values of a state differ from others of the same scene. Units:
   * N, N m, Pa, J/m.
   */
  struct ValueChanges
  {
    double force        = 0.; ///< |dT|
    double moment       = 0.; ///< of spin
    double normal_force = 0.;
    double max_pressure = 0.;
    double dissipation  = 0.;
  };

  /**
   * How much a level of refinement changed what the one before had found.
   */
  struct LevelChange
  {
    double forces       = 0.; ///< the largest of those over N and mu N
    double max_pressure = 0.; ///< over itself
  };

  /**
   * What a state tells of its own errors. The elements across the patch show
   * theirs by the same bodies' contact on every second node, at several
   * positions of these: values of second order have a third of that change as
   * error, and those of first order as much. What is missing in the bulk of
   * the bodies, where elements grow, is the change of their displacements by
   * BulkErrors times the answer of the linearised contact, in which friction,
   * partial slip and saturation are. See estimate_errors() of
   * state/estimate_errors.h.
   */
  struct ErrorEstimate
  {
    unsigned int n_positions = 0; ///< of every second node, that were solved
    ValueChanges across;          ///< largest over the positions

    /** Where no node sticks, the load of each times the square of how much the
     * slip changes to its neighbours, over the smaller of both and at most 1:
     * what may rest between nodes, or be told wrongly by them. None where a
     * node sticks. Units: N. */
    std::optional<double> load_on_turning_slip;

    /** None where it is not known. */
    std::optional<ValueChanges> bulk;

    /** None on the first level. */
    std::optional<LevelChange> from_level_before;
  };
} // namespace RollingContact

#endif
