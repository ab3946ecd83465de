#ifndef rolling_contact_wheelset_wheel_pair_h
#define rolling_contact_wheelset_wheel_pair_h

#include <rolling_contact/pair/track_forces.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/tables/kept_states.h>
#include <rolling_contact/wheelset/wheelset_parameters.h>

#include <array>
#include <memory>

namespace RollingContact
{
  /**
   * Where a wheelset is and how it turns: shift to the right, yaw against the
   * radial direction, and the angular velocity of the axle as -(1 + excess)
   * V/r0, r0 the radius of the right-hand wheel; how fast it moves to the
   * right, over V; and how far the rails, right and left, have given way to the
   * right. Units: m, rad, 1.
   */
  struct WheelsetPlace
  {
    double shift = 0., yaw = 0., excess = 0., aside = 0.;

    std::array<double, 2> rails{{0., 0.}};

    /** Shift against the rail of a wheel, 0 the right-hand one. Units: m. */
    double on_rail(const unsigned int wheel) const
    {
      return shift - rails[wheel];
    }

    /** Angular velocity of the axle at a speed, for r0. Units: m/s, m, rad/s.
     */
    double pitch_rate(const double speed, const double radius) const
    {
      return -(1 + excess) * speed / radius;
    }

    WheelsetPlace mirrored() const
    {
      return {-shift, -yaw, excess, -aside, {{-rails[1], -rails[0]}}};
    }
  };

  /**
   * What one wheel of a wheelset does: forces in the axes of the track, T gamma
   * as work of friction on the rigid slip, and how near it is to sliding.
   * Units: N, J/m, Pa, m, rad.
   */
  struct WheelState
  {
    double       load = 0.; ///< that was asked for
    TrackForces  forces;
    double       creep_work       = 0.;
    double       friction_force   = 0.; ///< mu N
    double       tangential_force = 0.;
    double       max_pressure     = 0.;
    unsigned int n_stick          = 0;  ///< nodes
    double       angle            = 0.; ///< of the patch with the largest load
    double       steepest         = 0.; ///< angle of the steepest patch
    unsigned int n_patches        = 0;

    /** As seen in a mirror along the track. */
    WheelState mirrored() const;
  };

  /** Right-hand wheel, left-hand wheel. */
  using BothWheels = std::array<WheelState, 2>;

  /**
   * The wheels of a wheelset on their rails. The left-hand one is solved as the
   * mirror image of a right-hand one, so that a wheelset in a mirror has the
   * same numbers, to the last bit. Bodies are kept, see KeptStates.
   */
  class WheelPair
  {
  public:
    /**
     * The wheels of a @p scene whose profiles and bodies are those of the
     * right-hand side. @p roughly: for states on the way to an equilibrium,
     * with few elements on half-spaces. Throws InputError if a profile cannot
     * be read.
     */
    WheelPair(const Situation          &scene,
              const WheelsetParameters &wheelset,
              const bool                roughly);

    /** Profiles of wheels and rails, right and left, in place of those that
     * were read; bodies that are kept do not know them. */
    void set_profiles(
      const std::array<std::shared_ptr<const Profiles::WheelOnRail>, 2> &both);

    /** See KeptStates::enough_nodes. */
    void limit_nodes(const double enough)
    {
      states.enough_nodes = enough;
    }

    /** Exchange the sides, as in a mirror. */
    void swap_sides();

    /**
     * The roll at which both wheels touch. Throws InputError if there is none.
     */
    double roll(const WheelsetPlace &place) const;

    /**
     * The states of both wheels under their loads (N). Throws ConvergenceError
     * if one of them is not found, InputError if a wheel is not on its rail.
     */
    BothWheels solve(const WheelsetPlace         &place,
                     const double                 curvature,
                     const std::array<double, 2> &loads);

    /** Whether the bodies of both wheels have nodes wherever their profiles
     * touch, see KeptStates::reaches_all(). */
    bool reaches_all(const WheelsetPlace         &place,
                     const double                 curvature,
                     const std::array<double, 2> &loads);

    /** Edges of stick zones stay those of the last state of each wheel. */
    void hold_edges(const bool held)
    {
      states.holds_edges = held;
    }

    /**
     * The scene of a wheel, 0 the right-hand one, in its own axes.
     */
    PairSpec scene_of(const unsigned int   wheel,
                      const WheelsetPlace &place,
                      const double         curvature,
                      const double         load) const;

    /** The scene of a wheel as of a right-hand one, the mirror image of a left
     * one. */
    PairSpec scene_as_right_hand(const unsigned int   wheel,
                                 const WheelsetPlace &place,
                                 const double         curvature,
                                 const double         load) const
    {
      return scene_as_right_hand(wheel, place, roll(place), curvature, load);
    }

    /**
     * The state of that scene, there until the next one is asked for. Throws as
     * solve() does.
     */
    SteadyState<3> &state_in_track(const unsigned int wheel,
                                   const PairSpec    &scene);

    /** Half the distance of the tape circles. Units: m. */
    double half_base() const;

    /** r0. Units: m. */
    double radius() const
    {
      return nominal_radius;
    }

    unsigned int n_states = 0;

    unsigned int n_bodies() const
    {
      return states.n_made;
    }

  private:
    struct One
    {
      PairSpec                                     scene;
      std::shared_ptr<const Profiles::WheelOnRail> profiles;
      std::string                                  bodies;
    };

    /** A wheel as a right-hand one: the place as it sees it. */
    PairSpec scene_as(const One                        &one,
                      const bool                        is_left,
                      const Profiles::WheelsetPosition &position,
                      const WheelsetPlace              &place,
                      const double                      curvature,
                      const double                      load) const;

    PairSpec scene_as_right_hand(const unsigned int   wheel,
                                 const WheelsetPlace &place,
                                 const double         roll,
                                 const double         curvature,
                                 const double         load) const;

    SteadyState<3> &checked(const unsigned int wheel,
                            const unsigned int kind,
                            const PairSpec    &scene);

    WheelState solve_one(const unsigned int   wheel,
                         const WheelsetPlace &place,
                         const double         roll,
                         const double         curvature,
                         const double         load);

    bool is_its_own_mirror_image() const
    {
      return sides[0].profiles == sides[1].profiles;
    }

    const double       nominal_radius;
    std::array<One, 2> sides; ///< right, left
    KeptStates<3>      states;
  };

  /**
   * What is told of a state of a wheel.
   */
  WheelState wheel_state(const PairSpec &scene, const SteadyState<3> &steady);
} // namespace RollingContact

#endif
