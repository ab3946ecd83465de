#ifndef rolling_contact_surfaces_wheelset_motion_h
#define rolling_contact_surfaces_wheelset_motion_h

#include <array>
#include <cstddef>
#include <optional>

namespace RollingContact::Profiles
{
  /**
   * How a wheelset moves along a track: with the speed V at the middle of the
   * track, along a curve with its centre to the right where the curvature is
   * positive, sideways to the right, and turning about its axle. Units: m/s,
   * rad/s, 1/m.
   */
  struct WheelsetMotion
  {
    double                speed = 1.;       ///< V, negative backwards
    std::optional<double> pitch_rate;       ///< none: no longitudinal creepage
    double                curvature   = 0.; ///< of the track, 1/m
    double                to_the_side = 0.; ///< velocity, m/s

    friend bool operator==(const WheelsetMotion &one,
                           const WheelsetMotion &other)
    {
      return one.speed == other.speed && one.pitch_rate == other.pitch_rate &&
             one.curvature == other.curvature &&
             one.to_the_side == other.to_the_side;
    }
  };

  /**
   * The four generalised velocities of a wheelset over |V|: along the track,
   * sideways, turn of the track below it about the vertical, and turn about the
   * axle. Conjugate to them are force_x, force_y, moment_z and axle_torque of
   * TrackForces. Units: 1, 1, 1/m, 1/m.
   */
  using GeneralisedVelocities = std::array<double, 4>;

  inline double dot(const GeneralisedVelocities &one,
                    const GeneralisedVelocities &other)
  {
    double sum = 0.;
    for (std::size_t j = 0; j < one.size(); ++j)
      sum += one[j] * other[j];
    return sum;
  }

  /**
   * A place on the surface of contact in the track (forwards, to the right,
   * down), the slope of the surface there, downwards to the right, and the rows
   * whose dot() with generalised velocities is the rigid slip of the wheel over
   * the rail, along x of the ContactFrame and along the tangent across. Units:
   * m, rad, 1 and m.
   */
  struct PlaceInTrack
  {
    std::array<double, 3> at;
    double                slope;
    GeneralisedVelocities along, across;
  };
} // namespace RollingContact::Profiles

#endif
