#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_tools.h>

#include <rolling_contact/mesh/body_mesh.h>
#include <rolling_contact/modes/outer_surface.h>

#include <cmath>

namespace RollingContact
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
} // namespace RollingContact
