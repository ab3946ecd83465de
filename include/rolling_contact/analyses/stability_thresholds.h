#ifndef rolling_contact_analyses_stability_thresholds_h
#define rolling_contact_analyses_stability_thresholds_h

#include <rolling_contact/run/run_context.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/state/steady_state.h>
#include <rolling_contact/vibration/vibrations.h>

#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * A quantity that a rolling state is driven or damped by, followed from its
   * value until the last vibration ceases to grow, or the first one begins to.
   * Units: 1.
   */
  struct DrivingThreshold
  {
    std::string quantity; ///< "friction"
    double      now = 0.;

    bool squeals = false; ///< as it is now

    bool found = false; ///< else the verdict is the same up to `to`
    bool known = true;  ///< false: no state was found at `to`

    double to = 0.; ///< the last value followed

    double value = 0.; ///< where growth ends or begins

    /**
     * Half of the interval that is left; by how much the whole bodies, and
     * modes that were left out, change the growth, over its slope; and where
     * growth ends as a node begins to stick, the part of the value that one
     * element is of the patch.
     */
    double uncertainty = 0.;

    double stable = 0.; ///< the value, and its uncertainty to the stable side

    /** |change| over the value, or over all of the creepage; 0 where neither
     * says anything, as of damping. */
    double share = 0.;

    unsigned int n_sticking = 0; ///< nodes, on the stable side
    bool         by_sticking =
      false; ///< more nodes stick on the stable side than on the other

    double      frequency = 0.; ///< of the last vibration that grows, Hz
    std::string mode;           ///< its name
  };

  /**
   * Thresholds of a state on the bodies it has, by their modes up to 1.25 times
   * the highest frequency that is looked at: of a state that
   * squeals less friction, less of each creepage, more longitudinal creepage
   * and more damping; of one that does not more friction and creepage. @p
   * findings are the vibrations of the state itself, by which the growth of the
   * whole bodies is told.
   */
  template <int dim>
  std::vector<DrivingThreshold>
  find_thresholds(const Situation            &scene,
                  const SteadyState<dim>     &steady,
                  const RollingModes<dim>    &rolling,
                  const Vibrations           &vibrations,
                  const std::vector<Finding> &findings,
                  RunContext                 &context);
} // namespace RollingContact

#endif
