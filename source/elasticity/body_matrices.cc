#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_matrix.h>

#include <rolling_contact/elasticity/assembly.h>
#include <rolling_contact/elasticity/body_matrices.h>

#include <algorithm>

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
     * The pattern of a matrix that couples all components or each with itself.
     */
    template <int dim>
    SparsityPattern
    sparsity_pattern(const Discretisation<dim> &body, const bool all_components)
    {
      DynamicSparsityPattern dynamic(body.dofs.n_dofs());
      DoFTools::make_sparsity_pattern(body.dofs,
                                      couplings<dim>(all_components),
                                      dynamic,
                                      body.constraints,
                                      false);
      SparsityPattern pattern;
      pattern.copy_from(dynamic);
      return pattern;
    }



    template <int dim>
    SymmetricSparseMatrix
    lumped_mass(const Discretisation<dim> &body)
    {
      Vector<double> masses(body.dofs.n_dofs());
      add_lumped_mass(body, masses);
      std::vector<double> entries(body.n_unknowns);
      for (std::size_t i = 0; i < masses.size(); ++i)
        if (body.unknown_of_dof[i] >= 0)
          entries[body.unknown_of_dof[i]] = masses[i];
      return diagonal_matrix(entries);
    }
  } // namespace



  template <int dim>
  SymmetricSparseMatrix
  assemble_stiffness(const Discretisation<dim> &body)
  {
    const SparsityPattern pattern = sparsity_pattern(body, true);
    SparseMatrix<double>  K(pattern);
    add_stiffness(body, K);
    return restrict_to_unknowns(K, body.unknown_of_dof, body.n_unknowns);
  }



  template <int dim>
  SymmetricSparseMatrix
  assemble_mass(const Discretisation<dim> &body, const MassKind kind)
  {
    if (kind == MassKind::lumped)
      return lumped_mass(body);
    const SparsityPattern pattern = sparsity_pattern(body, false);
    SparseMatrix<double>  M(pattern);
    add_mass(body, M);
    return restrict_to_unknowns(M, body.unknown_of_dof, body.n_unknowns);
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
