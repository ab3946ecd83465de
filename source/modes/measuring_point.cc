#include <deal.II/base/geometry_info.h>
#include <deal.II/fe/mapping_q1.h>

#include <rolling_contact/bodies/body_point.h>
#include <rolling_contact/modes/measuring_point.h>

#include <cmath>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    /** Where a mean is taken, and the weight. */
    template <int dim>
    using Sample = std::pair<Point<dim>, double>;

    /** The middles of small cubes within a radius of a point. */
    template <int dim>
    std::vector<Sample<dim>> samples_of_ball(const Point<dim> &middle,
                                             const double      radius)
    {
      const int                n = 6; // in a radius
      std::vector<Sample<dim>> samples;
      for (int k = 0; k < std::pow(2 * n, dim); ++k)
        {
          Tensor<1, dim> step;
          for (int d = 0, rest = k; d < dim; ++d, rest /= 2 * n)
            step[d] = (rest % (2 * n) - n + 0.5) / n;
          if (step.norm_square() < 1.)
            samples.push_back(
              {middle + radius * step, 1. - step.norm_square()});
        }
      return samples;
    }

    /** Where a point is in a cell, or false if it is outside. */
    template <int dim>
    bool is_inside(const typename DoFHandler<dim>::active_cell_iterator &cell,
                   const Point<dim>                                     &point,
                   Point<dim>                                           &unit)
    {
      const double rounding = 1e-10;
      try
        {
          unit = MappingQ1<dim>().transform_real_to_unit_cell(cell, point);
        }
      catch (const typename Mapping<dim>::ExcTransformationFailed &)
        {
          return false;
        }
      return GeometryInfo<dim>::is_inside_unit_cell(unit, rounding);
    }

    /**
     * Weights of vertices, at the first degree of freedom of each, of the mean
     * over the part of a body within a radius; their sum is 0 if that is none.
     */
    template <int dim>
    BodyField weights_of_ball(const DirectBody<dim> &body,
                              const Point<dim>      &point,
                              const double           radius)
    {
      BodyField weights = body.field(std::vector<double>(body.n_unknowns()));
      if (radius == 0.)
        return weights;
      auto             samples = samples_of_ball(point, radius);
      BoundingBox<dim> ball({point, point});
      ball.extend(radius);
      for (const auto &cell : body.dof_handler().active_cell_iterators())
        {
          const BoundingBox<dim> box = cell->bounding_box();
          if (box.get_neighbor_type(ball) == NeighborType::not_neighbors)
            continue;
          for (auto &[at, weight] : samples)
            {
              Point<dim> unit;
              if (weight == 0. || !box.point_inside(at) ||
                  !is_inside<dim>(cell, at, unit))
                continue;
              for (const unsigned int v : cell->vertex_indices())
                weights[cell->vertex_dof_index(v, 0)] +=
                  weight * GeometryInfo<dim>::d_linear_shape_function(unit, v);
              weight = 0.; // found, cells share their faces
            }
        }
      const double sum = weights.l1_norm();
      if (sum > 0.)
        weights /= sum;
      return weights;
    }
  } // namespace

  template <int dim>
  MeasuringPoint::MeasuringPoint(const DirectBody<dim>       &body,
                                 const std::array<double, 3> &point,
                                 const double                 radius)
  {
    const double facet_share = 0.1; // of a cell, between it and a curved body
    Point<dim>   at;
    for (unsigned int d = 0; d < dim; ++d)
      at[d] = point[d == dim - 1 ? 2 : d];
    BodyField nodes = weights_of_ball(body, at, radius);
    if (nodes.l1_norm() == 0.)
      {
        const BodyPoint<dim> place(body, at);
        for (const auto &[dof, weight] : place.weights())
          nodes[dof] += weight;
        if (place.distance() > facet_share * place.cell_diameter())
          away = place.distance();
      }
    for (unsigned int d = 0; d < dim; ++d)
      {
        const std::vector<double> forces = body.loads_of_nodes(nodes, d);
        for (std::size_t i = 0; i < forces.size(); ++i)
          if (forces[i] != 0.)
            weights[d == dim - 1 ? 2 : d].emplace_back(i, forces[i]);
      }
  }

  std::vector<double> MeasuringPoint::load(const unsigned int axis,
                                           const std::size_t  n_unknowns) const
  {
    std::vector<double> forces(n_unknowns, 0.);
    for (const auto &[unknown, weight] : weights[axis])
      forces[unknown] += weight;
    return forces;
  }

  double MeasuringPoint::motion(const unsigned int axis,
                                const double      *values) const
  {
    double mean = 0.;
    for (const auto &[unknown, weight] : weights[axis])
      mean += weight * values[unknown];
    return mean;
  }

  template MeasuringPoint::MeasuringPoint(const DirectBody<2> &,
                                          const std::array<double, 3> &,
                                          const double);
  template MeasuringPoint::MeasuringPoint(const DirectBody<3> &,
                                          const std::array<double, 3> &,
                                          const double);
} // namespace RollingContact
