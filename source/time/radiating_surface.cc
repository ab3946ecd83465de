#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_tools.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/mesh/body_mesh.h>
#include <rolling_contact/time/radiating_surface.h>
#include <rolling_contact/time/radiation_efficiency.h>

#include <algorithm>
#include <map>

namespace RollingContact::Sound
{
  using namespace dealii;

  namespace
  {
    /** Calls @p action with the values at the points of each outer face and
     * the degrees of freedom of its cell. */
    template <class Action>
    void for_each_outer_face(const DirectBody<3> &body, const Action &action)
    {
      const DoFHandler<3>                 &dofs = body.dof_handler();
      FEFaceValues<3>                      values(dofs.get_fe(),
                             QGauss<2>(2),
                             update_values | update_quadrature_points |
                               update_normal_vectors | update_JxW_values);
      std::vector<types::global_dof_index> indices(
        dofs.get_fe().n_dofs_per_cell());
      for (const auto &cell : dofs.active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() &&
              cell->face(f)->boundary_id() != hub_boundary)
            {
              values.reinit(cell, f);
              cell->get_dof_indices(indices);
              action(values, indices);
            }
    }

    /** Adds A^T A of the rows gathered so far, and forgets them. */
    void add_square(std::vector<double> &rows, DenseMatrix &sum)
    {
      const std::size_t m = sum.rows(), n = m > 0 ? rows.size() / m : 0;
      const Eigen::Map<const DenseMatrix> A(rows.data(), m, n); // transposed
      sum += A * A.transpose();
      rows.clear();
    }
  } // namespace

  OuterSurface::OuterSurface(const DirectBody<3> &body,
                             const DenseMatrix   &motions,
                             const std::size_t    n)
    : body(body)
  {
    for (std::size_t j = 0; j < n; ++j)
      fields.push_back(body.field(column_of(motions, j)));
  }

  DenseMatrix OuterSurface::form(const Direction &direction) const
  {
    const std::size_t   rows_at_once = 2048;
    DenseMatrix         sum = DenseMatrix::Zero(fields.size(), fields.size());
    std::vector<double> rows;
    for_each_outer_face(
      body,
      [&](const FEFaceValues<3>                      &face,
          const std::vector<types::global_dof_index> &indices) {
        const auto &element = face.get_fe();
        for (const unsigned int q : face.quadrature_point_indices())
          {
            const Tensor<1, 3> e = direction(face.quadrature_point(q));
            const double       weight =
              (face.normal_vector(q) * e) * std::sqrt(face.JxW(q));
            std::vector<std::pair<types::global_dof_index, double>> parts;
            for (unsigned int l = 0; l < indices.size(); ++l)
              if (const double part =
                    face.shape_value(l, q) *
                    e[element.system_to_component_index(l).first] * weight;
                  part != 0.)
                parts.emplace_back(indices[l], part);
            for (const BodyField &field : fields)
              {
                double value = 0.;
                for (const auto &[dof, part] : parts)
                  value += part * field[dof];
                rows.push_back(value);
              }
          }
        if (rows.size() >= rows_at_once * fields.size())
          add_square(rows, sum);
      });
    if (!rows.empty())
      add_square(rows, sum);
    return sum;
  }

  double OuterSurface::area(const Direction &direction) const
  {
    double sum = 0.;
    for_each_outer_face(body, [&](const FEFaceValues<3> &face, const auto &) {
      for (const unsigned int q : face.quadrature_point_indices())
        {
          const double part =
            face.normal_vector(q) * direction(face.quadrature_point(q));
          sum += part * part * face.JxW(q);
        }
    });
    return sum;
  }

  std::array<Point<3>, 2> OuterSurface::box() const
  {
    const auto box =
      GridTools::compute_bounding_box(body.dof_handler().get_triangulation());
    return {
      {box.get_boundary_points().first, box.get_boundary_points().second}};
  }

  double OuterSurface::volume() const
  {
    return GridTools::volume(body.dof_handler().get_triangulation());
  }

  namespace
  {
    Tensor<1, 3> unit_vector(const unsigned int component)
    {
      Tensor<1, 3> e;
      e[component] = 1.;
      return e;
    }

    std::vector<RadiatingPart> parts_about_axle(const VibratingBody<3> &body,
                                                const OuterSurface     &surface,
                                                const Axle             &axle,
                                                const std::size_t       n_modes,
                                                const Air              &air)
    {
      Point<3>     middle;
      Tensor<1, 3> along;
      for (unsigned int d = 0; d < 3; ++d)
        {
          middle[d] = axle.point[d];
          along[d]  = axle.direction[d];
        }
      const auto axial   = [=](const Point<3> &) { return along; };
      const auto outward = [=](const Point<3> &at) {
        const Tensor<1, 3> from = at - middle;
        const Tensor<1, 3> out  = from - (from * along) * along;
        return out / out.norm();
      };
      std::map<unsigned int, std::vector<std::size_t>> by_diameters;
      for (std::size_t j = 0; j < n_modes; ++j)
        {
          if (!body.characters[j].nodal_diameters)
            throw InputError(
              "Sound/Estimate = true: the nodes of the " + name_of(body.side) +
              " make no rings round its axle, so that nodal diameters cannot be "
              "counted; take a mesh with equal angles or set it to false.");
          by_diameters[*body.characters[j].nodal_diameters].push_back(j);
        }
      const DenseMatrix R_axial  = surface.form(axial),
                        R_radial = surface.form(outward);
      const double radius = body.parameters.radius, c = air.speed,
                   width = surface.area(outward) / (2 * numbers::PI * radius);
      std::vector<RadiatingPart> parts;
      for (const auto &of_diameters : by_diameters)
        {
          const unsigned int n     = of_diameters.first;
          const auto        &modes = of_diameters.second;
          parts.push_back({modes, R_axial(modes, modes), [=](const double f) {
                             return axial_efficiency_of_wheel(n, radius, c, f);
                           }});
          parts.push_back(
            {modes, R_radial(modes, modes), [=](const double f) {
               return radial_efficiency_of_wheel(n, radius, width, c, f);
             }});
        }
      return parts;
    }

    std::vector<RadiatingPart> parts_of_beam(const OuterSurface &surface,
                                             const std::size_t   n_modes,
                                             const Air          &air)
    {
      std::vector<std::size_t> all(n_modes);
      for (std::size_t j = 0; j < n_modes; ++j)
        all[j] = j;
      const auto   box     = surface.box();
      const double length  = box[1][0] - box[0][0],
                   section = surface.volume() / length, c = air.speed;
      std::vector<RadiatingPart> parts;
      for (const unsigned int component : {1, 2})
        {
          const unsigned int across = 3 - component;
          const auto         direction =
            [e = unit_vector(component)](const Point<3> &) { return e; };
          const double a = equivalent_radius(section,
                                             box[1][across] - box[0][across],
                                             surface.area(direction) / length);
          parts.push_back({all, surface.form(direction), [=](const double f) {
                             return efficiency_of_cylinder(a, c, f);
                           }});
        }
      return parts;
    }
  } // namespace

  RadiatingBody radiating_body(const VibratingBody<3> &body,
                               const double            maximum_frequency,
                               const Air              &air)
  {
    RadiatingBody radiating;
    for (const double frequency : body.modes.frequencies)
      if (frequency <= maximum_frequency)
        radiating.frequencies.push_back(frequency);
    const std::size_t  n = radiating.frequencies.size();
    const OuterSurface surface(*body.body, body.modes.shapes, n);
    const auto         axle = body.parameters.body_shape()->axle();
    radiating.parts = axle ? parts_about_axle(body, surface, *axle, n, air)
                           : parts_of_beam(surface, n, air);
    return radiating;
  }
} // namespace RollingContact::Sound
