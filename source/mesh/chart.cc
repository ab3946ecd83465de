#include <deal.II/base/numbers.h>

#include <rolling_contact/mesh/chart.h>

#include <cmath>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    double
    circumference_in_chart(const BodyGeometry &geometry,
                           const double        begin,
                           const double        end)
    {
      if (geometry.shape == Shape::block)
        return 0.;
      const double sector =
        std::asin(end / geometry.radius) - std::asin(begin / geometry.radius);
      return end - begin + geometry.radius * (2 * numbers::PI - sector);
    }

    template <int dim>
    Tensor<1, dim>
    periodicity(const double circumference)
    {
      Tensor<1, dim> result;
      result[0] = circumference;
      return result;
    }
  } // namespace



  template <int dim>
  BodyChart<dim>::BodyChart(const BodyGeometry &geometry,
                            const double        sector_begin,
                            const double        sector_end)
    : ChartManifold<dim, dim, dim>(periodicity<dim>(
        circumference_in_chart(geometry, sector_begin, sector_end)))
    , geometry(geometry)
    , sector_begin(sector_begin)
    , sector_end(sector_end)
    , circumference(circumference_in_chart(geometry, sector_begin, sector_end))
  {
    if (geometry.shape == Shape::disc)
      {
        angle_begin = std::asin(sector_begin / geometry.radius);
        angle_end   = std::asin(sector_end / geometry.radius);
      }
  }



  template <int dim>
  double
  BodyChart<dim>::centred_x(const double manifold_x) const
  {
    if (circumference == 0.)
      return manifold_x;
    const double x = manifold_x + sector_begin;
    return x > circumference / 2 ? x - circumference : x;
  }



  template <int dim>
  double
  BodyChart<dim>::angle(const double manifold_x) const
  {
    const double x = manifold_x + sector_begin;
    return x <= sector_end ? std::asin(x / geometry.radius)
                           : angle_end + (x - sector_end) / geometry.radius;
  }



  template <int dim>
  double
  BodyChart<dim>::from_angle(const double angle) const
  {
    const double full = 2 * numbers::PI, rounding = 1e-13;
    double       positive = angle;
    if (positive < angle_begin - rounding)
      positive += full;
    return positive <= angle_end
             ? geometry.radius * std::sin(positive) - sector_begin
             : sector_end + geometry.radius * (positive - angle_end) -
                 sector_begin;
  }



  template <int dim>
  Point<dim>
  BodyChart<dim>::push_forward(const Point<dim> &chart_point) const
  {
    const double x = chart_point[0], y = dim == 3 ? chart_point[1] : 0.,
                 w             = chart_point[dim - 1],
                 below_surface = w / geometry.thickness_below();
    Point<dim> point           = chart_point;
    if (geometry.shape == Shape::block)
      point[dim - 1] = geometry.surface_height(x, y) * (1 + below_surface) + w;
    else
      {
        const double rim =
          geometry.radius - crown_depth(geometry.lateral_radius, y);
        const double r = geometry.hub_radius +
                         (rim - geometry.hub_radius) * (1 + below_surface);
        const double theta = angle(x);
        point[0]           = r * std::sin(theta);
        point[dim - 1]     = r * std::cos(theta) - geometry.radius;
      }
    return point;
  }



  template <int dim>
  Point<dim>
  BodyChart<dim>::pull_back(const Point<dim> &point) const
  {
    const double thickness = geometry.thickness_below();
    const double x = point[0], y = dim == 3 ? point[1] : 0., z = point[dim - 1];
    Point<dim>   chart_point = point;
    if (geometry.shape == Shape::block)
      {
        const double height  = geometry.surface_height(x, y);
        chart_point[dim - 1] = (z - height) / (1 + height / thickness);
      }
    else
      {
        const double rim =
          geometry.radius - crown_depth(geometry.lateral_radius, y);
        const double r = std::hypot(x, z + geometry.radius);
        chart_point[0] = from_angle(std::atan2(x, z + geometry.radius));
        chart_point[dim - 1] =
          thickness * (r - rim) / (rim - geometry.hub_radius);
      }
    return chart_point;
  }



  template <int dim>
  std::unique_ptr<Manifold<dim, dim>>
  BodyChart<dim>::clone() const
  {
    return std::make_unique<BodyChart<dim>>(geometry, sector_begin, sector_end);
  }



  template class BodyChart<2>;
  template class BodyChart<3>;
} // namespace RollingContact
