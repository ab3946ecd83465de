#include <deal.II/base/geometry_info.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_tools.h>

#include <rolling_contact/bodies/body_point.h>

#include <limits>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    struct PlaceInCell
    {
      typename DoFHandler<dim>::active_cell_iterator cell;
      Point<dim>                                     unit;
    };

    /**
     * The place nearest to a point in the cells around its nearest vertex.
     */
    template <int dim>
    PlaceInCell<dim> nearest_place(const DoFHandler<dim> &dofs,
                                   const Point<dim>      &point)
    {
      const MappingQ1<dim> mapping;
      const unsigned int   vertex = GridTools::find_closest_vertex(dofs, point);
      PlaceInCell<dim>     best;
      double               least = std::numeric_limits<double>::infinity();
      for (const auto &cell :
           GridTools::find_cells_adjacent_to_vertex(dofs, vertex))
        {
          // the vertex itself where the map has no inverse
          Point<dim> unit;
          for (const unsigned int v : cell->vertex_indices())
            if (cell->vertex_index(v) == vertex)
              unit = GeometryInfo<dim>::unit_cell_vertex(v);
          try
            {
              unit = GeometryInfo<dim>::project_to_unit_cell(
                mapping.transform_real_to_unit_cell(cell, point));
            }
          catch (const typename Mapping<dim>::ExcTransformationFailed &)
            {}
          const double distance =
            mapping.transform_unit_to_real_cell(cell, unit).distance(point);
          if (distance < least)
            {
              least = distance;
              best  = {cell, unit};
            }
        }
      return best;
    }

    template <int dim>
    PlaceInCell<dim> place_of(const DoFHandler<dim> &dofs,
                              const Point<dim>      &point)
    {
      try
        {
          const auto [cell, unit] =
            GridTools::find_active_cell_around_point(MappingQ1<dim>(),
                                                     dofs,
                                                     point);
          if (cell != dofs.end())
            return {cell, GeometryInfo<dim>::project_to_unit_cell(unit)};
        }
      catch (const ExceptionBase &) // outside of all cells
        {}
      return nearest_place(dofs, point);
    }
  } // namespace

  template <int dim>
  BodyPoint<dim>::BodyPoint(const ElasticBody<dim> &body,
                            const Point<dim>       &point)
  {
    const auto place = place_of(body.dof_handler(), point);
    for (const unsigned int v : place.cell->vertex_indices())
      vertices.emplace_back(
        place.cell->vertex_dof_index(v, 0),
        GeometryInfo<dim>::d_linear_shape_function(place.unit, v));
    at = MappingQ1<dim>().transform_unit_to_real_cell(place.cell, place.unit);
    moved    = at.distance(point);
    diameter = place.cell->diameter();
  }

  template <int dim>
  std::array<double, dim> BodyPoint<dim>::value(const BodyField &field) const
  {
    std::array<double, dim> sum{};
    for (const auto &[dof, weight] : vertices)
      for (unsigned int d = 0; d < dim; ++d)
        sum[d] += weight * field[dof + d];
    return sum;
  }

  template class BodyPoint<2>;
  template class BodyPoint<3>;
} // namespace RollingContact
