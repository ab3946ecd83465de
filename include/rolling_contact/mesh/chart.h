#ifndef rolling_contact_mesh_chart_h
#define rolling_contact_mesh_chart_h

#include <deal.II/grid/manifold.h>

#include <rolling_contact/mesh/geometry.h>

namespace RollingContact
{
  /**
   * The chart of a body: (x, [y,] w) with x the coordinate along the contact
   * surface in the rolling direction, y across, w <= 0 the height below the
   * surface, down to -thickness_below() at the hub.
   *
   * Inside the contact sector [sector_begin, sector_end] of a disc the chart's
   * x is the Cartesian x of the surface, so that two bodies of any radii carry
   * surface nodes at the same x; outside it is arc length. The meshes are boxes
   * in the chart and the manifold puts new vertices there. Units: m.
   */
  template <int dim>
  class BodyChart : public dealii::ChartManifold<dim, dim, dim>
  {
  public:
    BodyChart(const BodyGeometry &geometry,
              const double        sector_begin,
              const double        sector_end);

    dealii::Point<dim>
    push_forward(const dealii::Point<dim> &chart_point) const override;

    /**
     * Inverse of push_forward(); x of a disc in [origin of the seam, +period).
     */
    dealii::Point<dim>
    pull_back(const dealii::Point<dim> &point) const override;

    std::unique_ptr<dealii::Manifold<dim, dim>>
    clone() const override;

    /**
     * Length of the circumference of a disc in the chart; 0 for a block.
     */
    double
    period() const
    {
      return circumference;
    }

    /**
     * The chart's x, unlike the manifold's counted from the contact point:
     * negative upstream, wrapped opposite the contact.
     */
    double
    centred_x(const double manifold_x) const;

  private:
    double
    angle(const double x) const;

    double
    from_angle(const double angle) const;

    BodyGeometry geometry;
    double       sector_begin, sector_end;
    double       angle_begin = 0., angle_end = 0., circumference = 0.;
  };
} // namespace RollingContact

#endif
