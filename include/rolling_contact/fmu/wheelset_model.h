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
   * Where a right-hand wheel is and how it moves: shifts against its own rail
   * and that of the other wheel, yaw, how far its own rail is below the other
   * one, vertical load, friction coefficient, motion. Units: m, m, rad, m, N,
   * 1.
   */
  struct WheelQuestion
  {
    static constexpr std::size_t n_numbers = 9;

    std::array<double, n_numbers> numbers() const;

    static WheelQuestion
    of_numbers(const std::array<double, n_numbers> &numbers);

    double      on_own = 0., on_other = 0., yaw = 0., rail_down = 0.;
    double      load = 0., friction = 0.;
    WheelMotion motion{};
  };

  /**
   * What is asked of a wheel, 0 the right-hand one, by inputs, at @p
   * least_speed (m/s) where it is slower: a left-hand wheel is the mirror image
   * of a right-hand one.
   */
  WheelQuestion question_of(const Inputs      &inputs,
                            const unsigned int wheel,
                            const double       least_speed);

  /**
   * The outputs of a wheel from its @p values as a right-hand one. The bound is
   * the largest number unless the wheel is @p inside of what is known.
   */
  WheelOutputs outputs_of(const Quantities  &values,
                          const bool         inside,
                          const Inputs      &inputs,
                          const unsigned int wheel);

  /**
   * Dimensions of a wheelset with equal profiles on both sides, and its inputs
   * at first. Units: m.
   */
  struct Wheelset
  {
    double radius = 1., tape_circle = 0.;
    Inputs start{};

    /** Throws std::invalid_argument if a dimension is none or an input not
     * finite. */
    void check() const;
  };

  /**
   * A wheelset with a table of forces. The creepages of WheelTable
   * are those of the tape circle (at e from the middle, radius r) without its
   * roll, for a motion u,
   *
   *   along = 1 - e u_turn + r cos(yaw) u_axle,
   *   across = u_aside + r sin(yaw) u_axle,
   *
   * from which the motion follows again: between states nothing but the values
   * is interpolated.
   */
  class WheelsetModel : public Wheelset
  {
  public:
    /** An unusable model. */
    WheelsetModel() = default;

    WheelsetModel(const Wheelset &wheelset, const WheelTable &table = {})
      : Wheelset(wheelset)
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

    WheelTable table;

  private:
    WheelOutputs wheel(const Inputs      &inputs,
                       const unsigned int wheel,
                       const double       least_speed,
                       double            &roll) const;
  };
} // namespace RollingContact::Fmu

#endif
