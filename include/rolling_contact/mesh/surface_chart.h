#ifndef rolling_contact_mesh_surface_chart_h
#define rolling_contact_mesh_surface_chart_h

#include <array>
#include <functional>
#include <vector>

namespace RollingContact
{
  /**
   * Depth of a circular profile below its crown at distance @p x from it,
   * x^2 / (R + sqrt(R^2 - x^2)); R = 0 is flat, R < 0 concave. Beyond |R|/2 the
   * profile goes on along its tangent. Units: m.
   */
  double crown_depth(const double radius, const double x);

  /**
   * Coarse cells in one direction: edges at origin + k * size up to half a
   * core, where bodies share their surface nodes. Beyond it cells are at least
   * as long as that, and as long as @p allowed at the end nearer to the
   * contact, at most @p largest; without @p allowed all are alike. Those that
   * are @p equal fill the body from end to end, all alike, round an axle with
   * equal angles, and at most as long as their size. Units: m.
   */
  struct CoarseCells
  {
    double origin    = 0.;
    double size      = 0.;
    double half_core = 0.;
    double largest   = 0.;
    bool   equal     = false;

    std::function<double(const double position)> allowed = {};

    /**
     * Length of the cell outside of the core that begins at a position.
     */
    double length_at(const double position) const;
  };

  /**
   * Chart (x, y, w) of a body: x the coordinate along the contact surface in
   * the rolling direction, y across, w <= 0 the height below the surface, down
   * to minus the thickness below the contact at the hub. Meshes are boxes in
   * the chart. Around the contact point x is the Cartesian x of the surface, so
   * that bodies of any shapes carry surface nodes at the same x. Points of the
   * body are in its own frame; in 2D y is zero. Units: m.
   */
  class SurfaceChart
  {
  public:
    using Point = std::array<double, 3>;

    virtual ~SurfaceChart() = default;

    virtual Point to_body(const Point &chart_point) const = 0;

    /**
     * Inverse of to_body(), with x in [0, period()) on a closed surface.
     */
    virtual Point to_chart(const Point &body_point) const = 0;

    /**
     * Ends of the coarse cells in the chart's x, ascending.
     */
    virtual std::vector<double> edges_x() const = 0;

    /**
     * Length in x after which a closed surface meets itself; 0 for an open one.
     */
    virtual double period() const
    {
      return 0.;
    }

    /**
     * The chart's x of the contact point.
     */
    virtual double contact_x() const
    {
      return 0.;
    }
  };

  /**
   * The ends of @p n equal parts of [begin, end].
   */
  std::vector<double>
  equal_parts(const double begin, const double end, const unsigned int n);

  /**
   * How many equal parts of a length are none longer than @p longest, one at
   * least.
   */
  unsigned int fewest_parts(const double length, const double longest);

  /**
   * The ends of cells from @p begin to @p end, upwards or downwards, as long as
   * @p cells asks outside of its core, all shortened alike to fill the
   * interval.
   */
  std::vector<double>
  growing_parts(const double begin, const double end, const CoarseCells &cells);

  /**
   * Break points in [begin, end]: the lattice of @p cells in their core, and
   * growing parts beyond. In an interval hardly longer than the core, the first
   * and last part take the remainder, at least half a lattice constant.
   */
  std::vector<double>
  break_points(const double begin, const double end, const CoarseCells &cells);
} // namespace RollingContact

#endif
