#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/vector_tools_boundary.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/log.h>
#include <rolling_contact/base/memory.h>
#include <rolling_contact/base/stopwatch.h>
#include <rolling_contact/elasticity/elastic_body.h>

#include <algorithm>
#include <map>

namespace RollingContact
{
  using namespace dealii;

  template <int dim>
  ElasticBody<dim>::ElasticBody(const BodyGeometry &geometry,
                                const Material     &material,
                                const double        thickness,
                                const Grading<dim> &grading)
    : material(material)
    , body_mesh(make_body_mesh<dim>(geometry, grading))
    , element(FE_Q<dim>(1), dim)
    , dofs(*body_mesh.triangulation)
  {
    const Stopwatch watch;
    distribute();
    factor =
      std::make_unique<Factorisation>(assemble(thickness), node_of_unknown);
    assembly_s = watch.seconds() - factor->size().analysis_s;
  }



  template <int dim>
  void
  ElasticBody<dim>::distribute()
  {
    dofs.distribute_dofs(element);
    DoFTools::make_hanging_node_constraints(dofs, constraints);
    DoFTools::make_zero_boundary_constraints(dofs, hub_boundary, constraints);
    constraints.close();

    unknown_of_dof.assign(dofs.n_dofs(), -1);
    int unknown = 0;
    for (types::global_dof_index i = 0; i < dofs.n_dofs(); ++i)
      if (constraints.is_constrained(i))
        ++n_constrained;
      else
        {
          unknown_of_dof[i]    = unknown++;
          const bool same_node = i % dim != 0 && !node_of_unknown.empty() &&
                                 unknown_of_dof[i - 1] >= 0;
          node_of_unknown.push_back(
            node_of_unknown.empty() ? 0 : node_of_unknown.back() + !same_node);
        }
  }



  /**
   * B-bar by mean dilatation, K_ij = integral of 2 G dev(eps_i) : dev(eps_j) +
   * V k mean(div phi_i) mean(div phi_j) with the bulk modulus k and the
   * deviator of the three-dimensional strain, eps_yy = 0 in plane strain
   * (Hughes 1980).
   */
  template <int dim>
  void
  ElasticBody<dim>::cell_stiffness(const FEValues<dim, dim> &values,
                                   FullMatrix<double>       &stiffness) const
  {
    const FEValuesExtractors::Vector displacement(0);
    const unsigned int               n = values.dofs_per_cell;
    const double G = material.shear_modulus(), k = material.bulk_modulus();

    std::vector<double>                  mean_dilatation(n, 0.);
    std::vector<SymmetricTensor<2, dim>> strain(n);
    std::vector<double>                  dilatation(n);
    double                               volume = 0.;
    stiffness                                   = 0.;
    for (const unsigned int q : values.quadrature_point_indices())
      {
        const double JxW = values.JxW(q);
        volume += JxW;
        for (unsigned int i = 0; i < n; ++i)
          {
            strain[i]     = values[displacement].symmetric_gradient(i, q);
            dilatation[i] = trace(strain[i]);
            mean_dilatation[i] += dilatation[i] * JxW;
          }
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j <= i; ++j)
            stiffness(i, j) +=
              2 * G *
              (strain[i] * strain[j] - dilatation[i] * dilatation[j] / 3) * JxW;
      }
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j <= i; ++j)
        {
          stiffness(i, j) +=
            k * mean_dilatation[i] * mean_dilatation[j] / volume;
          stiffness(j, i) = stiffness(i, j);
        }
  }



  namespace
  {
    /**
     * The lower triangle of the unconstrained part of @p matrix.
     */
    SymmetricSparseMatrix
    restrict_to_unknowns(const SparseMatrix<double> &matrix,
                         const std::vector<int>     &unknown_of_dof,
                         const std::size_t           n_unknowns)
    {
      SymmetricSparseMatrix result;
      result.column_starts.reserve(n_unknowns + 1);
      result.column_starts.push_back(0);
      std::vector<std::pair<std::int64_t, double>> column;
      for (std::size_t dof = 0; dof < unknown_of_dof.size(); ++dof)
        {
          const int j = unknown_of_dof[dof];
          if (j < 0)
            continue;
          column.clear();
          for (auto entry = matrix.begin(dof); entry != matrix.end(dof);
               ++entry)
            if (unknown_of_dof[entry->column()] >= j)
              column.emplace_back(unknown_of_dof[entry->column()],
                                  entry->value());
          std::sort(column.begin(), column.end());
          for (const auto &entry : column)
            {
              result.row_indices.push_back(entry.first);
              result.values.push_back(entry.second);
            }
          result.column_starts.push_back(result.row_indices.size());
        }
      return result;
    }
  } // namespace



  template <int dim>
  SymmetricSparseMatrix
  ElasticBody<dim>::assemble(const double thickness)
  {
    SparsityPattern pattern;
    {
      DynamicSparsityPattern dynamic(dofs.n_dofs());
      DoFTools::make_sparsity_pattern(dofs, dynamic, constraints, false);
      pattern.copy_from(dynamic);
    }
    SparseMatrix<double> matrix(pattern);

    FEValues<dim>                        values(element,
                         QGauss<dim>(2),
                         update_gradients | update_JxW_values);
    FullMatrix<double>                   stiffness(element.dofs_per_cell);
    std::vector<types::global_dof_index> cell_dofs(element.dofs_per_cell);
    for (const auto &cell : dofs.active_cell_iterators())
      {
        values.reinit(cell);
        cell_stiffness(values, stiffness);
        if (dim == 2)
          stiffness *= thickness;
        cell->get_dof_indices(cell_dofs);
        constraints.distribute_local_to_global(stiffness, cell_dofs, matrix);
      }
    return restrict_to_unknowns(matrix, unknown_of_dof, n_unknowns());
  }



  namespace
  {
    using Combination = std::vector<std::pair<types::global_dof_index, double>>;

    template <int dim>
    Point<dim - 1>
    without_depth(const Point<dim> &chart_point)
    {
      Point<dim - 1> result;
      for (int d = 0; d < dim - 1; ++d)
        result[d] = chart_point[d];
      return result;
    }



    /**
     * True if the middle of a box lies in the ellipse of the given semi-axes,
     * by a margin that keeps rounding from deciding.
     */
    template <int dim>
    bool
    in_ellipse(const Point<dim>            &lower,
               const Point<dim>            &upper,
               const std::array<double, 2> &semi_axes)
    {
      double sum = 0.;
      for (int d = 0; d < dim - 1; ++d)
        {
          const double middle = std::abs(lower[d] + upper[d]) / 2,
                       margin = 0.01 * (upper[d] - lower[d]);
          sum += std::pow(std::max(0., middle - margin) / semi_axes[d], 2);
        }
      return sum <= 1.;
    }



    /**
     * The keys of @p positions by ascending x, then y.
     */
    template <int dim>
    std::vector<types::global_dof_index>
    sorted(const std::map<types::global_dof_index, Point<dim>> &positions,
           const std::array<double, 2>                         &scale)
    {
      std::vector<types::global_dof_index> order;
      for (const auto &entry : positions)
        order.push_back(entry.first);
      std::sort(order.begin(), order.end(), [&](const auto a, const auto b) {
        const auto &p = positions.at(a), &q = positions.at(b);
        for (int d = 0; d < dim; ++d)
          if (std::abs(p[d] - q[d]) > 1e-9 * scale[d])
            return p[d] < q[d];
        return false;
      });
      return order;
    }
  } // namespace



  template <int dim>
  void
  ElasticBody<dim>::for_each_surface_face(
    const std::function<void(const CellIterator &, const unsigned int)> &action)
    const
  {
    for (const auto &cell : dofs.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary() &&
            cell->face(f)->boundary_id() == contact_boundary)
          action(cell, f);
  }



  template <int dim>
  void
  ElasticBody<dim>::surface(const double              extent_x,
                            const double              extent_y,
                            std::vector<SurfaceNode> &nodes,
                            std::vector<SurfaceFace> &faces) const
  {
    const std::array<double, 2> extent{{extent_x, extent_y}};
    std::map<types::global_dof_index, Point<dim - 1>> vertices, used;
    for_each_surface_face([&](const CellIterator &cell, const unsigned int f) {
      for (const unsigned int v : cell->face(f)->vertex_indices())
        {
          Point<dim> at = body_mesh.chart->pull_back(cell->face(f)->vertex(v));
          at[0]         = body_mesh.chart->centred_x(at[0]);
          vertices[cell->face(f)->vertex_dof_index(v, 0)] = without_depth(at);
        }
    });

    std::vector<std::vector<Combination>> corners;
    faces.clear();
    for_each_surface_face([&](const CellIterator &cell, const unsigned int f) {
      const auto box = body_mesh.chart_box(cell);
      if (!in_ellipse(box.first, box.second, extent))
        return;
      faces.push_back(
        {without_depth(box.first), without_depth(box.second), {}});
      corners.emplace_back();
      for (const unsigned int v : cell->face(f)->vertex_indices())
        {
          const auto  dof  = cell->face(f)->vertex_dof_index(v, 0);
          const auto *line = constraints.get_constraint_entries(dof);
          corners.back().push_back(line == nullptr ? Combination{{dof, 1.}}
                                                   : *line);
          for (const auto &entry : corners.back().back())
            used[entry.first] = vertices.at(entry.first);
        }
    });

    std::map<types::global_dof_index, unsigned int> number;
    nodes.clear();
    for (const auto dof : sorted(used, extent))
      {
        number[dof] = nodes.size();
        SurfaceNode node;
        node.position = used[dof];
        for (int d = 0; d < dim; ++d)
          node.dofs[d] = dof + d;
        nodes.push_back(node);
      }
    for (std::size_t f = 0; f < faces.size(); ++f)
      for (const Combination &corner : corners[f])
        {
          faces[f].corners.emplace_back();
          for (const auto &entry : corner)
            faces[f].corners.back().emplace_back(number.at(entry.first),
                                                 entry.second);
        }
  }



  template <int dim>
  DenseMatrix
  ElasticBody<dim>::compliance(const std::vector<SurfaceNode>  &nodes,
                               const std::vector<unsigned int> &components)
  {
    const double bytes = factor->size().memory_consumption();
    if (available_memory() > 0 && bytes > 0.7 * available_memory())
      throw InputError(
        "The factor of a body with " + std::to_string(n_unknowns()) +
        " unknowns needs " + human_bytes(bytes) + ", more than 70 % of the " +
        human_bytes(available_memory()) +
        " free: take fewer Mesh/Elements across patch or a larger "
        "Mesh/Growth.");
    factor->factorise();
    std::vector<std::size_t> unknowns;
    for (const unsigned int component : components)
      for (const SurfaceNode &node : nodes)
        unknowns.push_back(unknown_of_dof[node.dofs[component]]);
    return factor->condense(unknowns);
  }



  template <int dim>
  Vector<double>
  ElasticBody<dim>::recover(const std::vector<SurfaceNode>  &nodes,
                            const std::vector<unsigned int> &components,
                            const std::vector<double>       &forces) const
  {
    std::vector<double> right_hand_side(n_unknowns(), 0.);
    for (std::size_t c = 0; c < components.size(); ++c)
      for (std::size_t n = 0; n < nodes.size(); ++n)
        right_hand_side[unknown_of_dof[nodes[n].dofs[components[c]]]] +=
          forces[c * nodes.size() + n];
    const std::vector<double> solution = factor->solve(right_hand_side);
    Vector<double>            displacement(dofs.n_dofs());
    for (std::size_t i = 0; i < unknown_of_dof.size(); ++i)
      if (unknown_of_dof[i] >= 0)
        displacement[i] = solution[unknown_of_dof[i]];
    constraints.distribute(displacement);
    return displacement;
  }



  template class ElasticBody<2>;
  template class ElasticBody<3>;
} // namespace RollingContact
