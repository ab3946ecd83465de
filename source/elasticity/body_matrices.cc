#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparse_matrix.h>

#include <rolling_contact/elasticity/body_matrices.h>
#include <rolling_contact/elasticity/cell_matrices.h>

#include <algorithm>
#include <functional>

namespace RollingContact
{
  using namespace dealii;

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
      const std::size_t largest =
        (matrix.n_nonzero_elements() + n_unknowns) / 2;
      result.row_indices.reserve(largest);
      result.values.reserve(largest);
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



    /**
     * The components that a matrix couples: all, or each with itself.
     */
    template <int dim>
    Table<2, DoFTools::Coupling>
    couplings(const bool all)
    {
      Table<2, DoFTools::Coupling> table(dim, dim);
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          table(i, j) = all || i == j ? DoFTools::always : DoFTools::none;
      return table;
    }



    /**
     * Sum up cell matrices with the constraints eliminated.
     */
    template <int dim>
    SymmetricSparseMatrix
    assemble(const Discretisation<dim>                       &body,
             const Table<2, DoFTools::Coupling>              &couplings,
             const Quadrature<dim>                           &quadrature,
             const UpdateFlags                                update_flags,
             const std::function<void(const FEValues<dim> &,
                                      FullMatrix<double> &)> &cell_matrix)
    {
      SparsityPattern pattern;
      {
        DynamicSparsityPattern dynamic(body.dofs.n_dofs());
        DoFTools::make_sparsity_pattern(
          body.dofs, couplings, dynamic, body.constraints, false);
        pattern.copy_from(dynamic);
      }
      SparseMatrix<double> matrix(pattern);

      const auto                          &element = body.dofs.get_fe();
      FEValues<dim>                        values(element,
                           quadrature,
                           update_flags | update_JxW_values);
      FullMatrix<double>                   cell_values(element.dofs_per_cell);
      std::vector<types::global_dof_index> cell_dofs(element.dofs_per_cell);
      for (const auto &cell : body.dofs.active_cell_iterators())
        {
          values.reinit(cell);
          cell_matrix(values, cell_values);
          if (dim == 2)
            cell_values *= body.thickness;
          cell->get_dof_indices(cell_dofs);
          body.constraints.distribute_local_to_global(cell_values,
                                                      cell_dofs,
                                                      matrix);
        }
      return restrict_to_unknowns(matrix, body.unknown_of_dof, body.n_unknowns);
    }



    /**
     * The integral of rho phi_i at all nodes, constrained ones included.
     */
    template <int dim>
    std::vector<double>
    nodal_masses(const Discretisation<dim> &body)
    {
      const auto                          &element = body.dofs.get_fe();
      std::vector<double>                  masses(body.dofs.n_dofs(), 0.);
      FEValues<dim>                        values(element,
                           QGauss<dim>(2),
                           update_values | update_JxW_values);
      std::vector<types::global_dof_index> cell_dofs(element.dofs_per_cell);
      Vector<double>                       cell_masses(element.dofs_per_cell);
      const double                         density =
        body.material.density * (dim == 2 ? body.thickness : 1.);
      for (const auto &cell : body.dofs.active_cell_iterators())
        {
          values.reinit(cell);
          cell->get_dof_indices(cell_dofs);
          cell_lumped_mass(values, density, cell_masses);
          for (unsigned int i = 0; i < cell_dofs.size(); ++i)
            masses[cell_dofs[i]] += cell_masses(i);
        }
      return masses;
    }



    template <int dim>
    SymmetricSparseMatrix
    lumped_mass(const Discretisation<dim> &body)
    {
      const std::vector<double> masses = nodal_masses(body);
      std::vector<double>       entries(body.n_unknowns, 0.);
      for (std::size_t i = 0; i < masses.size(); ++i)
        if (const auto *line = body.constraints.get_constraint_entries(i))
          for (const auto &entry : *line)
            entries[body.unknown_of_dof[entry.first]] +=
              entry.second * masses[i];
        else
          entries[body.unknown_of_dof[i]] += masses[i];
      return diagonal_matrix(entries);
    }
  } // namespace



  template <int dim>
  SymmetricSparseMatrix
  assemble_stiffness(const Discretisation<dim> &body)
  {
    return assemble<dim>(body,
                         couplings<dim>(true),
                         QGauss<dim>(2),
                         update_gradients,
                         [&](const FEValues<dim> &values,
                             FullMatrix<double>  &stiffness) {
                           cell_stiffness(values, body.material, stiffness);
                         });
  }



  template <int dim>
  SymmetricSparseMatrix
  assemble_mass(const Discretisation<dim> &body, const MassKind kind)
  {
    if (kind == MassKind::lumped)
      return lumped_mass(body);
    return assemble<dim>(body,
                         couplings<dim>(false),
                         QGauss<dim>(3),
                         update_values,
                         [&](const FEValues<dim> &values,
                             FullMatrix<double>  &mass) {
                           cell_mass(values, body.material.density, mass);
                         });
  }



  template SymmetricSparseMatrix
  assemble_stiffness(const Discretisation<2> &);
  template SymmetricSparseMatrix
  assemble_stiffness(const Discretisation<3> &);
  template SymmetricSparseMatrix
  assemble_mass(const Discretisation<2> &, const MassKind);
  template SymmetricSparseMatrix
  assemble_mass(const Discretisation<3> &, const MassKind);
} // namespace RollingContact
