#ifndef rolling_contact_scene_time_parameters_h
#define rolling_contact_scene_time_parameters_h

#include <rolling_contact/input/prm_entries.h>
#include <rolling_contact/mesh/body_model.h>
#include <rolling_contact/scene/contact_parameters.h>
#include <rolling_contact/scene/time_function.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace RollingContact
{
  class Entries;

  /**
   * What drives a transient run: the histories of section Time, and the
   * constants of section Contact where those are empty. Either the load or the
   * approach is given.
   */
  struct DrivingFunctions
  {
    std::optional<TimeFunction> normal_load; ///< N
    std::optional<TimeFunction> approach;    ///< m
    TimeFunction                creepage_x;
    TimeFunction                creepage_y;
    TimeFunction                spin;  ///< 1/m
    TimeFunction                speed; ///< m/s
    /** Fingerprints of the table files, as "Time/Entry (table)". */
    PrmEntries tables;
    /** In place of creepages. Units: N, N, N m. */
    std::optional<TimeFunction> longitudinal_force, lateral_force, spin_moment;

    Creepages creepages(const double time) const
    {
      return {creepage_x.value(time), creepage_y.value(time), spin.value(time)};
    }

    /**
     * What is asked for at a time. Units: s.
     */
    AskedForces forces(const double time) const;

    /**
     * True if one of them jumps, see TimeFunction. Units: s.
     */
    bool jump_between(const double begin, const double end) const;

    /**
     * Acceleration of the wheel's hub towards the rail, by the approach before,
     * at and after a time; 0 at the start. Units: s, m/s^2.
     */
    double hub_acceleration(const double time, const double h) const;
  };

  /**
   * Steps of equal length; the last one reaches the end or passes it.
   */
  struct TimeSteps
  {
    double        length = 0.; ///< s
    std::uint64_t number = 0;
  };

  /**
   * What a transient run starts from.
   */
  enum class InitialState
  {
    rest,  ///< undeformed and without traction
    steady ///< the steady rolling state at t = 0
  };

  /**
   * Unilateral contact in time.
   */
  enum class ContactLaw
  {
    shifted, ///< the gap of Jean's shifted configuration
    gap      ///< the gap plus step times velocity
  };

  /**
   * What the bodies are in time.
   */
  enum class BodiesInTime
  {
    full,   ///< all their unknowns
    reduced ///< modes and a massless residual compliance
  };

  /**
   * Section `Time`: transient analysis.
   */
  struct TimeParameters
  {
    void declare(Entries &entries);

    /**
     * Check rules across entries, for Analysis = transient; table files are
     * relative to the folder of the .prm file. The histories are tried at up to
     * 1000 times. Throws InputError.
     */
    void check(const ContactParameters     &contact,
               const unsigned int           dimension,
               const std::filesystem::path &prm_folder) const;

    /**
     * Rules for a run until the motion repeats itself; @p why begins messages.
     * Throws InputError.
     */
    void check_cycles(const TimeSteps &all, const std::string &why) const;

    /**
     * Throws InputError.
     */
    DrivingFunctions histories(const ContactParameters     &contact,
                               const std::filesystem::path &prm_folder) const;

    /**
     * Throws InputError if a length is given and the speed is not constant.
     */
    TimeSteps steps(const TimeFunction &speed) const;

    /**
     * Whether the error of the time step is to be estimated: not of reduced
     * bodies, nor of a run whose end is found.
     */
    bool estimates_step() const
    {
      return step_estimate && bodies == BodiesInTime::full &&
             !stop_when_periodic;
    }

    /**
     * Part of critical damping that theta brings at `Damping frequency`, zeta =
     * (theta - 1/2) omega dt. Units: s, 1.
     */
    double numerical_damping(const double time_step) const;

    double       end_time            = 0.;
    double       rolled_distance     = 0.;
    double       time_step           = 0.;
    double       step_length         = 0.;
    double       theta               = 0.5;
    bool         inertia             = true;
    BodiesInTime bodies              = BodiesInTime::full;
    double       excite_mode         = 0.; ///< Hz
    double       excite_velocity     = 0.; ///< m/s
    bool         hold_approach       = false;
    InitialState initial_state       = InitialState::rest;
    MassKind     mass                = MassKind::lumped;
    double       rayleigh_alpha      = 0.;
    double       rayleigh_beta       = 0.;
    ContactLaw   contact_law         = ContactLaw::shifted;
    double       initial_velocity    = 0.;
    std::string  approach            = "";
    std::string  normal_load         = "";
    std::string  creepage_x          = "";
    std::string  creepage_y          = "";
    std::string  spin                = "";
    std::string  longitudinal_force  = "";
    std::string  lateral_force       = "";
    std::string  spin_moment         = "";
    std::string  speed               = "";
    unsigned int field_interval      = 0;
    unsigned int checkpoint_interval = 0;
    double       checkpoint_seconds  = 60.;
    unsigned int maximum_halvings    = 6;
    double       damping_frequency   = 0.;
    bool         step_estimate       = true;
    bool         stop_when_periodic  = false;
    double       periodic_tolerance  = 1e-2; ///< part of the range
    double       periodic_after      = 0.;   ///< s

  private:
    void declare_steps(Entries &entries);
    void declare_start(Entries &entries);
    void declare_histories(Entries &entries);
    void declare_output(Entries &entries);
    void check_entries(const ContactParameters &contact,
                       const unsigned int       dimension) const;
  };
} // namespace RollingContact

#endif
