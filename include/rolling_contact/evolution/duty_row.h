#ifndef rolling_contact_evolution_duty_row_h
#define rolling_contact_evolution_duty_row_h

#include <rolling_contact/evolution/duty.h>
#include <rolling_contact/evolution/wearing_contact.h>
#include <rolling_contact/wheelset/running_gear.h>

#include <vector>

namespace RollingContact
{
  /**
   * Where the wheelsets of a row are, as seen by the scene, how far they are
   * off their balances over the axle load, and what their wheels do.
   * Units: 1/m, m, rad, 1.
   */
  struct DutySummary
  {
    struct Wheelset
    {
      double curvature, shift, yaw, residual;

      template <class Archive>
      void serialize(Archive &archive, const unsigned int)
      {
        archive &curvature &shift &yaw &residual;
      }
    };

    std::vector<Wheelset>     wheelsets;
    std::vector<WearingWheel> wheels;

    template <class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &wheelsets &wheels;
    }
  };

  /**
   * The balance of a row of the duty and the contacts of its wheels, which only
   * the rank has that found them.
   */
  struct DutyState
  {
    DutySummary                 summary;
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
     * The balance on these surfaces. Throws ConvergenceError, naming the row,
     * if there is none.
     */
    DutyState stand_on(const RunningSurfaces &surfaces,
                       const Damage::WearLaw &law);

    unsigned int n_states() const
    {
      return n_solved + gear.n_states();
    }

    const DutyCase &row;

  private:
    void balance();

    /** Whether the bodies of all wheels have nodes wherever they touch. */
    bool reaches_all();

    DutyState state_on(const RunningSurfaces &surfaces,
                       const Damage::WearLaw &law);

    /** The contact of a wheel of the gear, 0 the right-hand one. */
    const SteadyState<3> &solved(const PairSpec    &scene,
                                 const unsigned int wheel,
                                 const unsigned int kind);

    const bool               is_mirrored; ///< solved as a curve to the right
    const WheelsetParameters wheelset;    ///< as it is solved
    RunningGear              gear;
    KeptStates<3>            states;
    bool                     has_begun = false;
    unsigned int             n_solved  = 0;
  };
} // namespace RollingContact

#endif
