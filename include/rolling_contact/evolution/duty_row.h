#ifndef rolling_contact_evolution_duty_row_h
#define rolling_contact_evolution_duty_row_h

#include <rolling_contact/evolution/duty.h>
#include <rolling_contact/evolution/wearing_contact.h>
#include <rolling_contact/wheelset/running_gear.h>

#include <vector>

namespace RollingContact
{
  /**
   * The balance of a row of the duty and the contacts of its wheels.
   */
  struct DutyState
  {
    RunningState                running; ///< as seen by the scene
    std::vector<WearingContact> contacts;
  };

  /**
   * A row of the duty on profiles that wear: its wheelset or bogie is balanced
   * on half-spaces from where it was, and its wheels are solved there with as
   * many elements as the scene has.
   */
  class DutyRow
  {
  public:
    /** Keeps a reference to the case, see read_duty(). */
    explicit DutyRow(const DutyCase &row);

    DutyRow(const DutyRow &)            = delete;
    DutyRow &operator=(const DutyRow &) = delete;

    /**
     * The balance on these surfaces. @p states keeps the bodies of all rows,
     * in which the kinds of this one begin with @p first_kind. Throws
     * ConvergenceError, naming the row, if there is none, InputError if a wheel
     * is not on its rail any more.
     */
    DutyState stand_on(const RunningSurfaces &surfaces,
                       const Damage::WearLaw &law,
                       KeptStates<3>         &states,
                       const unsigned int     first_kind);

    /** How many kinds of states a row has. */
    unsigned int n_contacts() const
    {
      return 2 * gear.n_wheelsets();
    }

    unsigned int n_states() const
    {
      return gear.n_states();
    }

    const DutyCase &row;

  private:
    void balance();

    const bool               is_mirrored; ///< solved as a curve to the right
    const WheelsetParameters wheelset;    ///< as it is solved
    RunningGear              gear;
    bool                     has_begun = false;
  };
} // namespace RollingContact

#endif
