#ifndef rolling_contact_wheelset_found_equilibrium_h
#define rolling_contact_wheelset_found_equilibrium_h

#include <rolling_contact/wheelset/running_gear.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>

namespace RollingContact
{
  /**
   * A wheelset in balance with what is told of it, in the axes of the track.
   * Units: m, rad, 1.
   */
  struct FoundEquilibrium
  {
    WheelsetState state;
    double        roll = 0.;

    std::string     name; ///< leading or trailing one of a bogie; empty
    Eigen::Vector2d frame = Eigen::Vector2d::Zero(), frame_left = frame;

    /** See Equilibrium::motion_derivatives(). */
    std::optional<Hunting::Derivatives> derivatives;

    /** Both wheels, right and left, on meshes and in scenes of their own. */
    std::array<std::optional<PairSpec>, 2> scenes;
    std::array<SteadyState<3>, 2>          steady;

    /** How far shift, yaw and excess may be off by the errors of forces; empty
     * if these are not known. */
    std::optional<Eigen::Vector3d> bounds;

    std::optional<WheelsetState> another; ///< equilibrium of the same case

    std::optional<Hunting> hunting; ///< if it was asked for and found

    unsigned int n_steps = 0, n_states = 0, n_bodies = 0;

    /**
     * How much its balances over the axle load may be off by the errors of the
     * forces, for half the distance of the wheels and their radius (m); nothing
     * if these are not known.
     */
    std::optional<Eigen::Vector3d>
    bounds_of_balances(const double axle_load,
                       const double half_base,
                       const double radius) const;

    /** Against the direction of travel. Units: N. */
    double drag() const
    {
      return -state.wheels[0].forces.force_x - state.wheels[1].forces.force_x;
    }

    /** T gamma of both wheels. Units: J/m. */
    double creep_work() const
    {
      return state.wheels[0].creep_work + state.wheels[1].creep_work;
    }

    /** The largest, of the wheelset's balances and those of its frame. */
    double residual() const
    {
      return std::max(state.largest_residual(),
                      frame_left.lpNorm<Eigen::Infinity>());
    }

    /** The sum of T gamma less the work of the forces that hold the wheelset on
     * its way, over the friction that both wheels can carry. */
    double energy_error(const double radius) const;
  };
} // namespace RollingContact

#endif
