#ifndef rolling_contact_bodies_assembly_h
#define rolling_contact_bodies_assembly_h

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>

#include <rolling_contact/bodies/cell_matrices.h>
#include <rolling_contact/mesh/body_model.h>

#include <vector>

namespace RollingContact
{
  /**
   * Components that a matrix couples: all of them, as K does, or each with
   * itself, as M does.
   */
  template <int dim>
  dealii::Table<2, dealii::DoFTools::Coupling> couplings(const bool all)
  {
    using namespace dealii::DoFTools;
    dealii::Table<2, Coupling> table(dim, dim);
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        table(i, j) = all || i == j ? always : none;
    return table;
  }

  /**
   * Sum up what @p integrate(values, cell_values) makes of each cell of this
   * rank, a FullMatrix or a Vector, with the constraints of @p body eliminated:
   * a Discretisation or DistributedDiscretisation.
   */
  template <class CellValues,
            int dim,
            template <int>
            class Body,
            class Integrate,
            class Sum>
  void add_cells(const Body<dim>               &body,
                 const dealii::Quadrature<dim> &quadrature,
                 const dealii::UpdateFlags      update_flags,
                 const Integrate               &integrate,
                 Sum                           &sum)
  {
    const auto           &element = body.dofs.get_fe();
    dealii::FEValues<dim> values(element,
                                 quadrature,
                                 update_flags | dealii::update_JxW_values);
    CellValues            cell_values(element.dofs_per_cell);
    std::vector<dealii::types::global_dof_index> cell_dofs(
      element.dofs_per_cell);
    for (const auto &cell : body.dofs.active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        values.reinit(cell);
        integrate(values, cell_values);
        if (dim == 2)
          cell_values *= body.thickness;
        cell->get_dof_indices(cell_dofs);
        body.constraints.distribute_local_to_global(cell_values,
                                                    cell_dofs,
                                                    sum);
      }
  }

  /**
   * The material of the cell that values are of.
   */
  template <int dim>
  const Material &material_of(const Materials             &materials,
                              const dealii::FEValues<dim> &values)
  {
    return materials.of(values.get_cell()->material_id());
  }

  /**
   * Add the stiffness of all cells to the matrix @p K, see cell_stiffness() and
   * cell_stiffness_enhanced().
   */
  template <int dim, template <int> class Body, class Matrix>
  void add_stiffness(const Body<dim> &body, Matrix &K)
  {
    add_cells<dealii::FullMatrix<double>>(
      body,
      dealii::QGauss<dim>(2),
      dealii::update_gradients,
      [&](const auto &values, auto &stiffness) {
        const Material &material = material_of(body.materials, values);
        if (body.elements == ElementKind::enhanced)
          cell_stiffness_enhanced(values, material, stiffness);
        else
          cell_stiffness(values, material, stiffness);
      },
      K);
  }

  /**
   * Add the consistent mass of all cells to the matrix @p M, see cell_mass().
   */
  template <int dim, template <int> class Body, class Matrix>
  void add_mass(const Body<dim> &body, Matrix &M)
  {
    add_cells<dealii::FullMatrix<double>>(
      body,
      dealii::QGauss<dim>(3),
      dealii::update_values,
      [&](const auto &values, auto &mass) {
        cell_mass(values, material_of(body.materials, values).density, mass);
      },
      M);
  }

  /**
   * Add the lumped mass of all cells to the vector @p diagonal, that of a
   * hanging node to the nodes it hangs between; see cell_lumped_mass().
   */
  template <int dim, template <int> class Body, class Diagonal>
  void add_lumped_mass(const Body<dim> &body, Diagonal &diagonal)
  {
    add_cells<dealii::Vector<double>>(
      body,
      dealii::QGauss<dim>(2),
      dealii::update_values,
      [&](const auto &values, auto &mass) {
        cell_lumped_mass(values,
                         material_of(body.materials, values).density,
                         mass);
      },
      diagonal);
  }
} // namespace RollingContact

#endif
