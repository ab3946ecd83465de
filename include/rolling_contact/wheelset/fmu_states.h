#ifndef rolling_contact_wheelset_fmu_states_h
#define rolling_contact_wheelset_fmu_states_h

#include <rolling_contact/fmu/wheelset_model.h>
#include <rolling_contact/pair/track_forces.h>
#include <rolling_contact/tables/table_plan.h>
#include <rolling_contact/wheelset/fmu_parameters.h>

#include <functional>

namespace RollingContact
{
  /** Dimensions of the wheelset of a scene, and what it says of its motion. */
  Fmu::Wheelset fmu_wheelset(const Situation &scene);

  /** The profiles of a scene. Throws InputError if they cannot be read. */
  std::shared_ptr<const Profiles::WheelOnRail>
  fmu_profiles(const Situation &scene);

  /** A state of a right-hand wheel as far as an FMU tells of it: forces, sum
   * and largest value of the pressure, work of friction, and how far the force
   * vector may be off. Units: N, N, Pa, J/m, N. */
  struct SolvedWheel
  {
    TrackForces forces;
    double      normal_force = 0., max_pressure = 0., creep_work = 0.;
    double      force_bound = 0.;
  };

  /** What an FMU tells of a state of a wheelset at a place. */
  Fmu::Quantities quantities_of(const SolvedWheel                &state,
                                const Profiles::WheelOnRail      &profiles,
                                const Profiles::WheelsetPosition &place);

  /**
   * The states of the table of an FMU: which entries of a scene each of them
   * has, and the model that follows when all are solved.
   */
  class FmuStates
  {
  public:
    /** Throws InputError if the wheel is not on its rail at one of the shifts.
     */
    explicit FmuStates(const Situation &scene);

    /** The states, in the order of the table. */
    TableStates table_states() const;

    /** The entries of a state at these coordinates. */
    std::vector<double> entries_of(const Fmu::Coordinates &point) const;

    /** Names of these entries. */
    static const std::vector<std::string> &entries();

    /** The coordinates of a state of the table. */
    Fmu::Coordinates coordinates_of(std::size_t state) const;

    /** A number of results.csv by its column; none if it is empty. */
    using Row = std::function<std::optional<double>(const std::string &column)>;

    /** What the table has of the state at a point. Throws InputError naming the
     * column that is empty. */
    Fmu::Quantities quantities_of(const Row              &row,
                                  const Fmu::Coordinates &point) const;

    /** The model from all states, in their order. */
    Fmu::WheelsetModel model(const std::vector<Fmu::Quantities> &states) const;

    /** The roll at which both wheels touch, for shifts against both rails. */
    double resting_roll(const double shift,
                        const double other_shift,
                        const double yaw) const;

    const std::array<std::vector<double>, Fmu::n_axes> axes;

    /** Without a table. */
    const Fmu::WheelsetModel wheelset;

    /** Inputs at which a wheel has these coordinates, on rails in their places;
     * @p is_left: the left-hand one. */
    Fmu::Inputs inputs_at(const Fmu::Coordinates &point,
                          const bool              is_left) const;

  private:
    /** What creepages along are measured from, see WheelTable::offset(). */
    double offset(const double shift) const;

    /** By how much a rigid wheel would slip forwards on the radius where it
     * touches, means over shifts nearby: an elastic one touches on a patch. At
     * equal distances over the axis of shifts. */
    std::vector<double> mean_offsets() const;

    Fmu::WheelMotion motion_of(const Fmu::Coordinates &point) const;

    const double                                 speed;
    std::shared_ptr<const Profiles::WheelOnRail> profiles;
    std::vector<double>                          offsets;
  };
} // namespace RollingContact

#endif
