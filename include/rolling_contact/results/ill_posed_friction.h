#ifndef rolling_contact_results_ill_posed_friction_h
#define rolling_contact_results_ill_posed_friction_h

#include <rolling_contact/contact/contact_problem.h>
#include <rolling_contact/run/log.h>
#include <rolling_contact/scene/pair_spec.h>

#include <array>
#include <string>

namespace RollingContact
{
  /**
   * Whether friction that falls with the sliding speed at each node at once
   * falls faster than the bodies radiate waves, over the steps of a run with
   * inertia: then there is no limit for short elements and steps. See
   * references/falling_half_spaces.h.
   */
  class IllPosedFriction
  {
  public:
    /**
     * For elements of this length (m) in the patch.
     */
    IllPosedFriction(const PairSpec &scene, const double element_size);

    /**
     * Look at the nodes that slide; nothing with constant friction or with a
     * memory.
     */
    void add(const ContactProblem &problem, const ContactState &state);

    /**
     * The largest fall over what the bodies radiate, see
     * falling_friction_gain().
     */
    double gain() const
    {
      return largest;
    }

    /**
     * How fast waves of two elements grow there. Units: 1/s.
     */
    double growth() const;

    /**
     * What is wrong and what helps; empty where nothing is.
     */
    std::string complaint() const;

  private:
    const PairSpec       &scene;
    double                element_size;
    double                largest = 0., fall = 0.;
    std::array<double, 2> position{{0., 0.}};
  };
} // namespace RollingContact

#endif
