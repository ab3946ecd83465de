#include <rolling_contact/mesh/chart.h>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    Tensor<1, dim> periodicity(const double period)
    {
      Tensor<1, dim> result;
      result[0] = period;
      return result;
    }

    template <int dim>
    SurfaceChart::Point with_y(const Point<dim> &point)
    {
      return {{point[0], dim == 3 ? point[1] : 0., point[dim - 1]}};
    }

    template <int dim>
    Point<dim> without_y(const SurfaceChart::Point &point)
    {
      Point<dim> result;
      for (int d = 0; d < dim; ++d)
        result[d] = point[d == dim - 1 ? 2 : d];
      return result;
    }
  } // namespace

  template <int dim>
  BodyChart<dim>::BodyChart(std::shared_ptr<const BodyShape>    shape,
                            std::shared_ptr<const SurfaceChart> chart)
    : ChartManifold<dim, dim, dim>(periodicity<dim>(chart->period()))
    , shape(std::move(shape))
    , chart(std::move(chart))
    , length(this->chart->period())
    , contact_x(this->chart->contact_x())
  {}

  template <int dim>
  double BodyChart<dim>::centred_x(const double manifold_x) const
  {
    const double x = manifold_x - contact_x;
    return length > 0. && x > length / 2 ? x - length : x;
  }

  template <int dim>
  Point<dim> BodyChart<dim>::push_forward(const Point<dim> &chart_point) const
  {
    return without_y<dim>(chart->to_body(with_y(chart_point)));
  }

  template <int dim>
  Point<dim> BodyChart<dim>::pull_back(const Point<dim> &point) const
  {
    return without_y<dim>(chart->to_chart(with_y(point)));
  }

  template <int dim>
  std::unique_ptr<Manifold<dim, dim>> BodyChart<dim>::clone() const
  {
    return std::make_unique<BodyChart<dim>>(shape, chart);
  }

  template class BodyChart<2>;
  template class BodyChart<3>;
} // namespace RollingContact
