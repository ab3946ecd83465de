#ifndef rolling_contact_results_nodal_values_h
#define rolling_contact_results_nodal_values_h

#include <rolling_contact/contact/recovered_tractions.h>
#include <rolling_contact/scene/pair_spec.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace RollingContact
{
  class StateDamage;

  /**
   * A state of the contact, with what its fields have in common, found once
   * when it is asked for. Keeps references.
   */
  class NodalState
  {
  public:
    /**
     * Without a @p scene there are no fields that depend on its bodies. Slip
     * and gap of a restored state are not known until its next step.
     */
    NodalState(const ContactProblem &problem,
               const ContactState   &state,
               const bool            step_is_known = true,
               const PairSpec       *scene         = nullptr);

    const TangentialProblem &tangential() const;

    const RecoveredTractions &recovered() const;

    /** None unless Wear/Report asks for it. */
    const StateDamage *damage() const;

    const ContactProblem &problem;
    const ContactState   &state;
    const bool            step_is_known;
    const PairSpec       *scene;

  private:
    mutable std::optional<TangentialProblem>  tangential_problem;
    mutable std::optional<RecoveredTractions> recovered_tractions;

    mutable std::shared_ptr<const StateDamage> state_damage;
  };

  /**
   * A quantity at the contact nodes: what interface.vtu, results.csv and Python
   * have of it.
   */
  struct NodalQuantity
  {
    std::string name, unit;

    /** None if a state has no such field. */
    std::optional<NodalField> (*values)(const NodalState &state);

    /** Along the surface, with a component for each of its directions, zero
     * without friction; else one component. */
    bool is_vector = false;

    /**
     * Whether the value belongs to the step that led to this state; it is NaN
     * where that step is not known.
     */
    bool of_step = false;

    /** The field of a state, if it has one. */
    std::optional<NodalField> of(const NodalState &state) const;
  };

  /**
   * All of them: vectors first, the NodeState last.
   */
  const std::vector<NodalQuantity> &nodal_quantities();

  /**
   * The one of this name. Throws std::out_of_range if there is none.
   */
  const NodalQuantity &nodal_quantity(const std::string &name);
} // namespace RollingContact

#endif
