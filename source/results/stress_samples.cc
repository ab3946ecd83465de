#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/cell_id.h>
#include <deal.II/grid/grid_tools.h>

#include <rolling_contact/bodies/hookes_law.h>
#include <rolling_contact/results/stress_samples.h>

#include <cmath>
#include <map>
#include <optional>
#include <set>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    /**
     * The axes of the contact in those of the body, row by row.
     */
    Tensor<2, 3> turn_about_x(const double angle)
    {
      Tensor<2, 3> turn;
      turn[0][0] = 1.;
      turn[1][1] = turn[2][2] = std::cos(angle);
      turn[2][1]              = std::sin(angle);
      turn[1][2]              = -turn[2][1];
      return turn;
    }

    /**
     * A vector of dim components as one of three, in 2D with y = 0.
     */
    template <int dim>
    Tensor<1, 3> in_space(const Tensor<1, dim> &vector)
    {
      Tensor<1, 3> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d == dim - 1 ? 2 : d] = vector[d];
      return result;
    }

    /**
     * Mean over the cell; eps_yy = 0 in plane strain.
     */
    template <int dim>
    SymmetricTensor<2, 3> mean_strain(const FEValues<dim> &values,
                                      const BodyField     &displacement)
    {
      std::vector<Tensor<2, dim>> gradients(values.n_quadrature_points);
      values[FEValuesExtractors::Vector(0)].get_function_gradients(displacement,
                                                                   gradients);
      Tensor<2, dim> mean;
      double         volume = 0.;
      for (const unsigned int q : values.quadrature_point_indices())
        {
          mean += values.JxW(q) * gradients[q];
          volume += values.JxW(q);
        }
      mean /= volume;

      const auto axis = [](const unsigned int d) {
        return d == dim - 1 ? 2 : d;
      };
      SymmetricTensor<2, 3> strain;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j <= i; ++j)
          strain[axis(i)][axis(j)] = (mean[i][j] + mean[j][i]) / 2;
      return strain;
    }

    /**
     * Mean strain xx, yy, xy of a face in its own plane, x along the projection
     * of x; axes of the contact.
     */
    template <int dim>
    std::array<double, 3>
    strain_of_face(const typename DoFHandler<dim>::face_iterator &face,
                   const BodyField                               &displacement,
                   const Tensor<2, 3>                            &turn)
    {
      // derivatives of place and displacement in the middle of the face
      std::array<Tensor<1, 3>, dim - 1> along, change;
      for (const unsigned int v : face->vertex_indices())
        {
          Tensor<1, dim> moved;
          for (unsigned int d = 0; d < dim; ++d)
            moved[d] = displacement[face->vertex_dof_index(v, d)];
          for (unsigned int k = 0; k < dim - 1; ++k)
            {
              const double sign = (v >> k) & 1 ? 1. : -1.;
              along[k] += sign * (turn * in_space<dim>(face->vertex(v)));
              change[k] += sign * (turn * in_space(moved));
            }
        }
      Tensor<1, 3> normal;
      if constexpr (dim == 3)
        normal = cross_product_3d(along[0], along[1]);
      else
        normal = cross_product_3d(along[0], Tensor<1, 3>({0., 1., 0.}));
      normal /= std::copysign(normal.norm(), normal[2]);
      std::array<Tensor<1, 3>, 2> axes;
      axes[0] = Tensor<1, 3>({1., 0., 0.}) - normal[0] * normal;
      axes[0] /= axes[0].norm();
      axes[1] = cross_product_3d(normal, axes[0]);
      Tensor<2, dim - 1> places, displacements;
      for (unsigned int i = 0; i < dim - 1; ++i)
        for (unsigned int k = 0; k < dim - 1; ++k)
          {
            places[i][k]        = axes[i] * along[k];
            displacements[i][k] = axes[i] * change[k];
          }
      const Tensor<2, dim - 1> gradient = displacements * invert(places);
      if constexpr (dim == 3)
        return {{gradient[0][0],
                 gradient[1][1],
                 (gradient[0][1] + gradient[1][0]) / 2}};
      else
        return {{gradient[0][0], 0., 0.}};
    }
  } // namespace

  template <int dim>
  StressSamples<dim>::StressSamples(const ElasticBody<dim> &body,
                                    const BodyField        &displacement,
                                    const double            angle)
    : dofs(body.dof_handler())
    , of_vertex(dofs.get_triangulation().n_vertices())
    , samples(dofs.get_triangulation().n_active_cells())
    , vertices(samples.size())
    , beyond(samples.size())
  {
    const Tensor<2, 3> turn = turn_about_x(angle);
    FEValues<dim>      values(dofs.get_fe(),
                         QGauss<dim>(2),
                         update_gradients | update_JxW_values);
    for (const auto &cell : dofs.active_cell_iterators())
      if (!cell->is_artificial())
        {
          const unsigned int c      = cell->active_cell_index();
          StressSample<dim> &sample = samples[c];
          values.reinit(cell);
          sample.middle = cell->center();
          sample.stress = symmetrize(
            turn *
            Tensor<2, 3>(stress_of(mean_strain(values, displacement),
                                   body.elasticity().of(cell->material_id()))) *
            transpose(turn));
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary() && face->boundary_id() == contact_boundary)
              {
                sample.has_face       = true;
                sample.middle_of_face = face->center();
                sample.strain = strain_of_face<dim>(face, displacement, turn);
              }
          for (const unsigned int v : cell->vertex_indices())
            {
              vertices[c].push_back(cell->vertex_index(v));
              of_vertex[cell->vertex_index(v)].push_back(c);
            }
        }
    if (body.mesh().kind == MeshKind::distributed)
      exchange();
  }

  template <int dim>
  std::pair<std::vector<unsigned int>, std::vector<unsigned int>>
  StressSamples<dim>::around(const unsigned int vertex)
  {
    const std::vector<unsigned int> &next = of_vertex[vertex];
    std::vector<unsigned int>        others;
    visited.resize(samples.size(), 0);
    ++visit;
    for (const unsigned int c : next)
      visited[c] = visit;
    const auto add = [&](const std::vector<unsigned int> &found) {
      for (const unsigned int c : found)
        if (visited[c] != visit)
          {
            visited[c] = visit;
            others.push_back(c);
          }
    };
    for (const unsigned int c : next)
      {
        add(beyond[c]);
        for (const unsigned int v : vertices[c])
          add(of_vertex[v]);
      }
    return {next, others};
  }

  template <int dim>
  void StressSamples<dim>::exchange()
  {
    using Id     = CellId::binary_type;
    using Around = std::vector<std::pair<Id, StressSample<dim>>>;
    using Cell   = typename DoFHandler<dim>::active_cell_iterator;
    std::map<Id, unsigned int> numbers;
    std::vector<Id>            ids(samples.size());
    for (const auto &cell : dofs.active_cell_iterators())
      if (!cell->is_artificial())
        {
          const unsigned int c = cell->active_cell_index();
          ids[c]               = cell->id().template to_binary<dim>();
          numbers[ids[c]]      = c;
        }
    GridTools::exchange_cell_data_to_ghosts<Around, DoFHandler<dim>>(
      dofs,
      [&](const Cell &cell) -> std::optional<Around> {
        std::set<unsigned int> all;
        for (const unsigned int v : vertices[cell->active_cell_index()])
          all.insert(of_vertex[v].begin(), of_vertex[v].end());
        Around around;
        for (const unsigned int c : all)
          around.emplace_back(ids[c], samples[c]);
        return around;
      },
      [&](const Cell &cell, const Around &around) {
        for (const auto &[id, sample] : around)
          {
            const auto number = numbers.emplace(id, samples.size());
            if (number.second)
              samples.push_back(sample);
            beyond[cell->active_cell_index()].push_back(number.first->second);
          }
      });
  }

  template class StressSamples<2>;
  template class StressSamples<3>;
} // namespace RollingContact
