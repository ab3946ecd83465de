#ifndef rolling_contact_fmu_wheel_table_h
#define rolling_contact_fmu_wheel_table_h

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace RollingContact::Fmu
{
  /**
   * The axes of a table of one wheel, a right-hand one: shift of the wheelset
   * against the rail to the right, yaw, turn of the wheelset over the track per
   * metre (curvature and yaw rate over the speed), vertical load, creepages of
   * WheelsetModel along, less an offset of the shift, and across, both over the
   * friction coefficient, and friction coefficient. Units: m, rad, 1/m, N, 1,
   * 1, 1.
   */
  enum Axis : std::size_t
  {
    shift_axis,
    yaw_axis,
    turn_axis,
    load_axis,
    along_axis,
    across_axis,
    friction_axis,
    n_axes
  };

  /**
   * What a table has of each state: force and moment about the centre of the
   * wheelset in the axes of the track (forwards, to the right, down), normal
   * force, place across of the pressure's middle, angle of its resultant,
   * largest pressure, work of friction per metre, and how far the force may be
   * off. Units: N, N m, m, rad, Pa, J/m, N.
   */
  enum Quantity : std::size_t
  {
    force_x,
    force_y,
    force_z,
    moment_x,
    moment_y,
    moment_z,
    normal_force,
    place_y,
    contact_angle,
    max_pressure,
    friction_work,
    force_bound,
    n_quantities
  };

  /** Coordinates of a point of a table, by Axis. */
  using Coordinates = std::array<double, n_axes>;

  /** Values of a state, by Quantity. */
  using Quantities = std::array<double, n_quantities>;

  /** What a table says at a point: whether that is within all axes, else the
   * values are those of the nearest point that is. */
  struct TableValues
  {
    Quantities values{};
    bool       inside = true;
  };

  /** By what values of a quantity are divided between states under different
   * loads: the load, its third root, 1. */
  double scale_of(const std::size_t quantity, const double load);

  /** Linear between values at equal distances from @p first to @p last, and
   * constant beyond; at least one value. */
  double at_equal_distances(const std::vector<double> &values,
                            const double               first,
                            const double               last,
                            const double               x);

  /**
   * States of one wheel on a grid. Between them values over the load (pressure
   * over its third root) follow cubic Hermite polynomials along each axis, with
   * slopes by the parabola through three neighbours. The bound of the force
   * adds to that of the states, for each axis and a point the part t of an
   * interval h, margin t (1 - t) h (|jump| + |jump|), where a jump is by how
   * much the slope of the force between states changes at each end of the
   * interval. With a margin of 1 that is all of the error of a straight line
   * over a kink within it, four times that over a parabola.
   */
  class WheelTable
  {
  public:
    WheelTable() = default;

    /**
     * @p axes: ascending values, one or at least three of each. @p states: in
     * the order of a grid, the last axis fastest. @p roll: of the wheelset on
     * which both wheels rest, by yaw, shift against the own rail, and shift
     * against the other one, the last one fastest. @p offsets: what creepages
     * along are measured from, by shift. Throws std::invalid_argument if
     * numbers do not fit or are not finite.
     */
    WheelTable(const std::array<std::vector<double>, n_axes> &axes,
               const std::vector<Quantities>                 &states,
               const std::vector<double>                     &roll,
               const std::vector<double>                     &offsets);

    /** The values at a point. */
    TableValues at(const Coordinates &point) const;

    /**
     * Roll at which both wheels of equal profiles touch, for shifts against the
     * rail of this and of the other wheel; linear between the values of the
     * axis and constant beyond. Units: m, rad.
     */
    double resting_roll(const double shift,
                        const double other_shift,
                        const double yaw) const;

    /**
     * Where the creepages along begin to be counted, linear between those that
     * are given and constant beyond: about that of a wheel which rolls there
     * without a longitudinal force, so that the axis need not reach far.
     * Unit: 1.
     */
    double offset(const double shift) const;

    const std::vector<double> &axis(const Axis d) const
    {
      return axes[d];
    }

    double margin = 1.;

    /** All that is needed to make it again. */
    std::vector<double> numbers() const;

    /** The table of such numbers, from the place @p at on, which goes behind
     * them. Throws std::invalid_argument if they are none. */
    static WheelTable of_numbers(const std::vector<double> &numbers,
                                 std::size_t               &at);

  private:
    /** States of an axis that take part at a point, with their weights, and the
     * interval: its first state and the part of it that lies before the point.
     */
    struct Stencil
    {
      std::size_t           first = 0, n = 1, cell = 0;
      std::array<double, 4> weights{{1., 0., 0., 0.}};
      double                t = 0., width = 0.;
    };

    static Stencil
    stencil(const std::vector<double> &axis, double x, bool &inside);

    void find_jumps();

    /** Jumps of the slope of the force along an axis. */
    void find_jumps_along(const std::size_t d);

    /** The sum over the states of all stencils. */
    void add_states(const std::array<Stencil, n_axes> &stencils,
                    const std::size_t                  d,
                    const std::size_t                  state,
                    const double                       weight,
                    Quantities                        &sum) const;

    /** The bound over the load. */
    double bound(const std::array<Stencil, n_axes> &stencils) const;

    std::array<std::vector<double>, n_axes> axes;
    std::array<std::size_t, n_axes>         strides{};
    std::vector<Quantities>                 states; ///< over the load
    std::vector<std::array<float, n_axes>>  jumps;  ///< over the load
    std::vector<double>                     roll, offsets;
  };
} // namespace RollingContact::Fmu

#endif
