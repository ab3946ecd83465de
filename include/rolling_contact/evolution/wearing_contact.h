#ifndef rolling_contact_evolution_wearing_contact_h
#define rolling_contact_evolution_wearing_contact_h

#include <rolling_contact/damage/wear_laws.h>
#include <rolling_contact/evolution/running_surfaces.h>
#include <rolling_contact/pair/friction_heat.h>
#include <rolling_contact/tables/kept_states.h>

#include <array>
#include <optional>
#include <vector>

namespace RollingContact
{
  /**
   * A line of nodes along x that wears: where it is on the profiles of wheel
   * and rail (arc lengths; none where the body does not reach), and the depth c
   * that a passage takes from the rail over the load of the line. The wear of a
   * state is proportional to its pressure as long as slip and law are those of
   * its beginning. Units: m, m per passage over N/m.
   */
  struct WearingLine
  {
    std::array<std::optional<double>, 2> place;
    double                               width, load, depth_over_load;
    double                               radius; ///< at which the wheel rolls
    std::vector<unsigned int>            nodes;
  };

  /**
   * The wear of the bodies of a side for a part of the way: how many metres the
   * wheel rolls and how many wheelsets pass the rail. Units: m, 1.
   */
  struct WearingWay
  {
    double distance = 0., passages = 0.;

    /** Depth of a body over that which one passage takes from the rail. */
    double factor(const unsigned int body, const double rolling_radius) const;
  };

  /**
   * What is told of a wheel that wears, and of its rail: which one it is, 0 the
   * right-hand one, T gamma, the peak pressure, the flash temperature, zero
   * where that is not known, and the middle of what it wears across its
   * profile, NaN without wear. Units: N, Pa, K, m.
   */
  struct WearingWheel
  {
    unsigned int     wheelset, wheel;
    double           creep_work, max_pressure;
    PatchTemperature flash;
    double           centre_of_wear = 0.;

    template <class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &wheelset &wheel &creep_work &max_pressure;
      archive &flash.largest &flash.mean &centre_of_wear;
    }
  };

  /**
   * The contact of a wheel of a row of the duty, and what its lines wear.
   */
  class WearingContact
  {
  public:
    /**
     * @p wheelset, @p wheel: which one it is, 0 the right-hand one; @p
     * portion: of the way of its row that is on this contact, as of several
     * that wear the same profile.
     */
    WearingContact(const PairSpec        &scene,
                   const SteadyState<3>  &steady,
                   const Damage::WearLaw &law,
                   const unsigned int     wheelset,
                   const unsigned int     wheel,
                   const double           portion);

    /** The lines with the loads and depths of the state as it is. */
    const std::vector<WearingLine> &lines() const
    {
      return all;
    }

    /**
     * Depths of the rail for a passage under each line, at the end of a way
     * along which the contact wears itself and is worn by others: the state
     * with the compliance
     *
     *   W + C,  C = c_i w (D/(2 pi r) + n) / b_i + d_i / F_i
     *
     * for nodes of the same line i, 0 else: c_i F_i / b_i is the depth of the
     * rail for a passage, b_i the width and F_i the force of the line, w the
     * portion of the distance D and of the n passages, and d_i (m) the depth
     * that others make. Lines without force have that as a gap. The traction
     * stays, which pressures depend on little, if at all. Throws
     * ConvergenceError if there is no such state. Units: m.
     */
    std::vector<double> depths_at_end(const WearingWay          &way,
                                      const std::vector<double> &others) const;

    /** Depths of the rail for a passage, of the state as it is. Units: m. */
    std::vector<double> depths() const;

    /** Amounts of a body by depths of the rail for a passage. Units: m^2. */
    std::vector<double> amounts(const Profiles::ProfileCurve &curve,
                                const unsigned int            body,
                                const WearingWay             &way,
                                const std::vector<double>    &depths,
                                const double                  smoothing) const;

    WearingWheel summary;

  private:
    void find_lines(const PairSpec        &scene,
                    const SteadyState<3>  &steady,
                    const Damage::WearLaw &law);

    /** Lines that have no load wear as the next one that has. */
    void fill_lines_without_load();

    const double             portion; ///< of the way
    ContactProblem           normal;  ///< under the traction of the state
    ContactState             state;   ///< of that
    SolverControls           controls;
    std::vector<WearingLine> all;
  };
} // namespace RollingContact

#endif
