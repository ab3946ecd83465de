#ifndef rolling_contact_mesh_surface_chart_h
#define rolling_contact_mesh_surface_chart_h

#include <array>
#include <vector>

namespace RollingContact
{
  /**
   * Depth of a circular profile below its crown at distance @p x from it,
   * x^2 / (R + sqrt(R^2 - x^2)); R = 0 is flat, R < 0 concave. Beyond |R|/2 the
   * profile goes on along its tangent. Units: m.
   */
  double
  crown_depth(const double radius, const double x);

  /**
   * What the coarse cells along x are made for: edges at origin + k * size and
   * a zone of contact nodes |x| <= zone_x. Units: m.
   */
  struct CoarseCells
  {
    double origin;
    double size;
    double zone_x;
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

    virtual Point
    to_body(const Point &chart_point) const = 0;

    /**
     * Inverse of to_body(), with x in [0, period()) on a closed surface.
     */
    virtual Point
    to_chart(const Point &body_point) const = 0;

    /**
     * Ends of the coarse cells in the chart's x, ascending.
     */
    virtual std::vector<double>
    edges_x() const = 0;

    /**
     * Length in x after which a closed surface meets itself; 0 for an open one.
     */
    virtual double
    period() const
    {
      return 0.;
    }

    /**
     * The chart's x of the contact point.
     */
    virtual double
    contact_x() const
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
   * Break points in [begin, end]: multiples of @p size from @p origin; the
   * first and last interval take the remainder, at least half a @p size long.
   */
  std::vector<double>
  break_points(const double begin,
               const double end,
               const double origin,
               const double size);
} // namespace RollingContact

#endif
