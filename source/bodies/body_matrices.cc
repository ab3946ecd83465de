#include <deal.II/fe/mapping_q1.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_matrix.h>

#include <rolling_contact/bodies/assembly.h>
#include <rolling_contact/bodies/body_matrices.h>

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
     * As DoFTools::make_sparsity_pattern(), for a pattern that is larger than
     * the degrees of freedom are many.
     */
    template <int dim>
    void add_cell_couplings(const Discretisation<dim> &body,
                            const bool                 all_components,
                            DynamicSparsityPattern    &pattern)
    {
      const auto        &element = body.dofs.get_fe();
      const unsigned int n       = element.dofs_per_cell;
      Table<2, bool>     mask(n, n);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          mask(i, j) =
            all_components || element.system_to_component_index(i).first ==
                                element.system_to_component_index(j).first;
      std::vector<types::global_dof_index> cell_dofs(n);
      for (const auto &cell : body.dofs.active_cell_iterators())
        {
          cell->get_dof_indices(cell_dofs);
          body.constraints.add_entries_local_to_global(cell_dofs,
                                                       pattern,
                                                       false,
                                                       mask);
        }
    }

    /**
     * The pattern of a matrix that couples all components or each with itself.
     */
    template <int dim>
    SparsityPattern sparsity_pattern(const Discretisation<dim> &body,
                                     const bool                 all_components)
    {
      DynamicSparsityPattern dynamic(body.dofs.n_dofs() +
                                     body.supports.n_extra());
      if (body.supports.n_extra() == 0)
        DoFTools::make_sparsity_pattern(body.dofs,
                                        couplings<dim>(all_components),
                                        dynamic,
                                        body.constraints,
                                        false);
      else
        add_cell_couplings(body, all_components, dynamic);
      body.supports.add_couplings(body.constraints, dynamic);
      SparsityPattern pattern;
      pattern.copy_from(dynamic);
      return pattern;
    }

    /**
     * The masses of nodes that are tied to a rigid mass, T^T M T on its
     * unknowns.
     */
    template <int dim>
    FullMatrix<double> mass_of_tied_nodes(const Discretisation<dim> &body,
                                          const Vector<double>      &masses)
    {
      const std::size_t  first = body.dofs.n_dofs();
      FullMatrix<double> sum(body.supports.n_extra());
      for (std::size_t i = 0; i < first; ++i)
        if (const auto *line = body.constraints.get_constraint_entries(i))
          for (const auto &a : *line)
            for (const auto &b : *line)
              if (a.first >= first && b.first >= first)
                sum(a.first - first, b.first - first) +=
                  a.second * masses[i] * b.second;
      return sum;
    }

    /**
     * A diagonal matrix with the lower triangle of @p block on its last
     * unknowns added.
     */
    SymmetricSparseMatrix with_last_block(const std::vector<double> &diagonal,
                                          const FullMatrix<double>  &block)
    {
      SymmetricSparseMatrix result;
      const std::size_t     first = diagonal.size() - block.m();
      result.column_starts.push_back(0);
      for (std::size_t j = 0; j < diagonal.size(); ++j)
        {
          const std::size_t end = j < first ? j + 1 : diagonal.size();
          for (std::size_t i = j; i < end; ++i)
            {
              result.row_indices.push_back(i);
              result.values.push_back(
                (i == j ? diagonal[j] : 0.) +
                (j < first ? 0. : block(i - first, j - first)));
            }
          result.column_starts.push_back(result.values.size());
        }
      return result;
    }

    /**
     * The body with nothing but its hanging nodes constrained, if @p hanging is
     * that.
     */
    template <int dim>
    Discretisation<dim> untied(const Discretisation<dim>       &body,
                               const AffineConstraints<double> &hanging)
    {
      return {body.dofs,
              hanging,
              body.unknown_of_dof,
              body.n_unknowns,
              body.materials,
              body.thickness,
              body.elements,
              body.supports};
    }

    template <int dim>
    SymmetricSparseMatrix lumped_mass(const Discretisation<dim> &body)
    {
      const bool                is_tied = body.supports.is_tied();
      Vector<double>            masses(body.dofs.n_dofs());
      AffineConstraints<double> hanging;
      if (is_tied)
        DoFTools::make_hanging_node_constraints(body.dofs, hanging);
      hanging.close();
      add_lumped_mass(is_tied ? untied(body, hanging) : body, masses);
      std::vector<double> entries(body.n_unknowns);
      for (std::size_t i = 0; i < masses.size(); ++i)
        if (body.unknown_of_dof[i] >= 0)
          entries[body.unknown_of_dof[i]] = masses[i];
      FullMatrix<double> block;
      if (is_tied)
        block = mass_of_tied_nodes(body, masses);
      const std::size_t first = body.n_unknowns - body.supports.n_extra();
      for (const auto &[i, j, mass] : body.supports.masses())
        if (is_tied)
          block(i, j) += mass;
        else
          entries[first + i] = mass;
      return is_tied ? with_last_block(entries, block)
                     : diagonal_matrix(entries);
    }
  } // namespace

  template <int dim>
  SymmetricSparseMatrix assemble_stiffness(const Discretisation<dim> &body,
                                           const StiffnessParts      &parts)
  {
    const SparsityPattern pattern = sparsity_pattern(body, true);
    SparseMatrix<double>  K(pattern);
    if (parts.material != 0.)
      add_stiffness(body, K);
    if (parts.material != 0. && parts.material != 1.)
      K *= parts.material;
    body.supports.add_stiffness(body.constraints,
                                parts.foundation,
                                parts.ballast,
                                K);
    return restrict_to_unknowns(K, body.unknown_of_dof, body.n_unknowns);
  }

  template <int dim>
  SymmetricSparseMatrix assemble_mass(const Discretisation<dim> &body,
                                      const MassKind             kind)
  {
    if (kind == MassKind::lumped)
      return lumped_mass(body);
    const SparsityPattern pattern = sparsity_pattern(body, false);
    SparseMatrix<double>  M(pattern);
    add_mass(body, M);
    const std::size_t first = body.dofs.n_dofs();
    for (const auto &[i, j, mass] : body.supports.masses())
      M.add(first + i, first + j, mass);
    return restrict_to_unknowns(M, body.unknown_of_dof, body.n_unknowns);
  }

  template <int dim>
  std::vector<PointMass> clamped_masses(const Discretisation<dim> &body)
  {
    Vector<double>            masses(body.dofs.n_dofs());
    AffineConstraints<double> hanging;
    DoFTools::make_hanging_node_constraints(body.dofs, hanging);
    hanging.close();
    add_lumped_mass(untied(body, hanging), masses);
    std::vector<Point<dim>> positions(body.dofs.n_dofs());
    DoFTools::map_dofs_to_support_points(MappingQ1<dim>(),
                                         body.dofs,
                                         positions);
    std::vector<PointMass> result;
    for (types::global_dof_index i = 0; i < body.dofs.n_dofs(); i += dim)
      if (body.unknown_of_dof[i] < 0 && !hanging.is_constrained(i))
        {
          const Point<dim> &at = positions[i];
          result.push_back(
            {{{at[0], dim == 3 ? at[1] : 0., at[dim - 1]}}, masses[i]});
        }
    return result;
  }

  namespace
  {
    Tensor<1, 3> tensor(const std::array<double, 3> &v)
    {
      return Tensor<1, 3>({v[0], v[1], v[2]});
    }

    /**
     * The skew part of the integral of rho phi_i (e x r) . grad phi_j.
     */
    void cell_rotation(const FEValues<3>  &values,
                       const double        density,
                       const Axle         &axle,
                       FullMatrix<double> &rotation)
    {
      const auto &element = values.get_fe();
      rotation            = 0.;
      for (const unsigned int q : values.quadrature_point_indices())
        {
          const Tensor<1, 3> along =
            cross_product_3d(tensor(axle.direction),
                             values.quadrature_point(q) -
                               Point<3>(tensor(axle.point)));
          for (const unsigned int i : values.dof_indices())
            for (const unsigned int j : values.dof_indices())
              if (element.system_to_component_index(i).first ==
                  element.system_to_component_index(j).first)
                rotation(i, j) += density * values.JxW(q) / 2 *
                                  (values.shape_value(i, q) *
                                     (along * values.shape_grad(j, q)) -
                                   values.shape_value(j, q) *
                                     (along * values.shape_grad(i, q)));
        }
    }
  } // namespace

  SkewSparseMatrix assemble_rotation(const Discretisation<3> &body,
                                     const Axle              &axle)
  {
    const SparsityPattern pattern = sparsity_pattern(body, false);
    SparseMatrix<double>  S(pattern);
    add_cells<FullMatrix<double>>(
      body,
      QGauss<3>(2),
      update_values | update_gradients | update_quadrature_points,
      [&](const auto &values, auto &rotation) {
        cell_rotation(values,
                      material_of(body.materials, values).density,
                      axle,
                      rotation);
      },
      S);
    SkewSparseMatrix result{
      restrict_to_unknowns(S, body.unknown_of_dof, body.n_unknowns)};
    // taken by rows of the upper triangle
    for (double &value : result.lower.values)
      value *= -1.;
    return result;
  }

  template SymmetricSparseMatrix  assemble_stiffness(const Discretisation<2> &,
                                                     const StiffnessParts &);
  template SymmetricSparseMatrix  assemble_stiffness(const Discretisation<3> &,
                                                     const StiffnessParts &);
  template std::vector<PointMass> clamped_masses(const Discretisation<2> &);
  template std::vector<PointMass> clamped_masses(const Discretisation<3> &);
  template SymmetricSparseMatrix  assemble_mass(const Discretisation<2> &,
                                                const MassKind);
  template SymmetricSparseMatrix  assemble_mass(const Discretisation<3> &,
                                                const MassKind);
} // namespace RollingContact
