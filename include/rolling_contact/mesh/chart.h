#ifndef rolling_contact_mesh_chart_h
#define rolling_contact_mesh_chart_h

#include <deal.II/grid/manifold.h>

#include <rolling_contact/mesh/body_shape.h>

namespace RollingContact
{
  /**
   * The chart of a body as deal.II's manifold, (x, [y,] w), where it puts new
   * vertices. Units: m.
   */
  template <int dim>
  class BodyChart : public dealii::ChartManifold<dim, dim, dim>
  {
  public:
    BodyChart(std::shared_ptr<const BodyShape>    shape,
              std::shared_ptr<const SurfaceChart> chart);

    dealii::Point<dim>
    push_forward(const dealii::Point<dim> &chart_point) const override;

    /**
     * Inverse of push_forward(), with x in [0, period()) on a closed surface.
     */
    dealii::Point<dim>
    pull_back(const dealii::Point<dim> &point) const override;

    std::unique_ptr<dealii::Manifold<dim, dim>> clone() const override;

    /**
     * Length of a closed surface in the chart; 0 for an open one.
     */
    double period() const
    {
      return length;
    }

    /**
     * The chart's x, unlike the manifold's counted from the contact point:
     * negative upstream, wrapped opposite the contact.
     */
    double centred_x(const double manifold_x) const;

  private:
    std::shared_ptr<const BodyShape>    shape; ///< which the chart refers to
    std::shared_ptr<const SurfaceChart> chart;
    double                              length, contact_x;
  };
} // namespace RollingContact

#endif
