#ifndef rolling_contact_fmu_wheelset_model_h
#define rolling_contact_fmu_wheelset_model_h

#include <rolling_contact/fmu/wheel_table.h>

#include <cstdint>

namespace RollingContact::Fmu
{
  /**
   * The inputs that a vehicle gives: shift of the wheelset to the right; yaw
   * against the radial direction, right-handed about the vertical downwards;
   * the rates of both; angular velocity about the axle (negative forwards);
   * speed at the middle of the track; curvature (positive to the right);
   * friction coefficient; loads of both wheels; displacements of both rails to
   * the right and down.
   */
  enum Input : std::size_t
  {
    lateral_shift,
    yaw,
    lateral_velocity,
    yaw_rate,
    axle_speed,
    speed,
    curvature,
    friction,
    right_load,
    left_load,
    right_rail_y,
    left_rail_y,
    right_rail_z,
    left_rail_z,
    n_inputs
  };

  /** Values of the inputs. Units: SI. */
  using Inputs = std::array<double, n_inputs>;

  /**
   * The outputs of a wheel: force and moment on it about the centre of the
   * wheelset, in the axes of the track, and the other values of Quantity, with
   * the place across counted from the middle of the track; lateral force over
   * load.
   */
  struct WheelOutputs
  {
    Quantities values{};
    double     force_ratio = 0.;
    bool       inside      = true;
  };

  /** Both wheels, right and left, and the roll of the wheelset. */
  struct Outputs
  {
    std::array<WheelOutputs, 2> wheels;
    double                      roll = 0.;
  };

  /** Below this speed creepages are those at it. Units: m/s. */
  constexpr double default_least_speed = 0.1;

  /**
   * How a wheelset moves over its track, as a right-hand wheel sees it, over
   * the speed: sideways, turn about the vertical, turn about the axle. Units:
   * 1, 1/m, 1/m.
   */
  struct WheelMotion
  {
    double aside, turn, about_axle;
  };

  /**
   * A wheelset with equal profiles on both sides. The creepages of WheelTable
   * are those of the tape circle (at e from the middle, radius r) without its
   * roll, for a motion u,
   *
   *   along = 1 - e u_turn + r cos(yaw) u_axle,
   *   across = u_aside + r sin(yaw) u_axle,
   *
   * from which the motion follows again: between states nothing but the values
   * is interpolated.
   */
  class WheelsetModel
  {
  public:
    /** An unusable model. */
    WheelsetModel() = default;

    /** Made of a radius (m), half the distance of the tape circles (m), and
     * what the inputs are at first. */
    WheelsetModel(const double      radius,
                  const double      tape_circle,
                  const Inputs     &start,
                  const WheelTable &table)
      : radius(radius)
      , tape_circle(tape_circle)
      , start(start)
      , table(table)
    {}

    /** Forces under these inputs, at @p least_speed (m/s) where it is slower.
     */
    Outputs evaluate(const Inputs &inputs, const double least_speed) const;

    /** The creepages along and across of a motion. Units: 1. */
    std::array<double, 2> creepages(const WheelMotion &motion,
                                    const double       yaw) const;

    /** The motion of these creepages and this turn. */
    WheelMotion motion(const std::array<double, 2> &creepages,
                       const double                 turn,
                       const double                 yaw) const;

    /** The model as bytes of a file. */
    std::string bytes() const;

    /** The model of such bytes. Throws std::invalid_argument if they are none.
     */
    static WheelsetModel of_bytes(const std::string &bytes);

    double     radius = 1., tape_circle = 0.;
    Inputs     start{};
    WheelTable table;

  private:
    WheelOutputs wheel(const Inputs      &inputs,
                       const unsigned int wheel,
                       const double       least_speed,
                       double            &roll) const;
  };
} // namespace RollingContact::Fmu

#endif
