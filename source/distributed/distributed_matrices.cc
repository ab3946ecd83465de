#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <rolling_contact/distributed/distributed_matrices.h>
#include <rolling_contact/elasticity/cell_matrices.h>

#include <functional>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    /**
     * Sum up cell matrices with the constraints eliminated.
     */
    template <int dim>
    void
    assemble(const DistributedDiscretisation<dim>            &body,
             const DoFTools::Coupling                         others,
             const Quadrature<dim>                           &quadrature,
             const UpdateFlags                                update_flags,
             const std::function<void(const FEValues<dim> &,
                                      FullMatrix<double> &)> &cell_matrix,
             TrilinosWrappers::SparseMatrix                  &matrix)
    {
      const MPI_Comm communicator = body.dofs.get_communicator();
      const auto     rank = Utilities::MPI::this_mpi_process(communicator);
      Table<2, DoFTools::Coupling> couplings(dim, dim);
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          couplings(i, j) = i == j ? DoFTools::always : others;
      {
        TrilinosWrappers::SparsityPattern pattern(
          body.dofs.locally_owned_dofs(),
          body.dofs.locally_owned_dofs(),
          body.relevant_dofs,
          communicator);
        DoFTools::make_sparsity_pattern(
          body.dofs, couplings, pattern, body.constraints, false, rank);
        pattern.compress();
        matrix.reinit(pattern);
      }
      const auto                          &element = body.dofs.get_fe();
      FEValues<dim>                        values(element,
                           quadrature,
                           update_flags | update_JxW_values);
      FullMatrix<double>                   cell_values(element.dofs_per_cell);
      std::vector<types::global_dof_index> cell_dofs(element.dofs_per_cell);
      for (const auto &cell : body.dofs.active_cell_iterators())
        {
          if (!cell->is_locally_owned())
            continue;
          values.reinit(cell);
          cell_matrix(values, cell_values);
          if (dim == 2)
            cell_values *= body.thickness;
          cell->get_dof_indices(cell_dofs);
          body.constraints.distribute_local_to_global(cell_values,
                                                      cell_dofs,
                                                      matrix);
        }
      matrix.compress(VectorOperation::add);
    }
  } // namespace



  template <int dim>
  void
  assemble_stiffness(const DistributedDiscretisation<dim> &body,
                     TrilinosWrappers::SparseMatrix       &K)
  {
    assemble<dim>(
      body,
      DoFTools::always,
      QGauss<dim>(2),
      update_gradients,
      [&](const FEValues<dim> &values, FullMatrix<double> &stiffness) {
        cell_stiffness(values, body.material, stiffness);
      },
      K);
  }



  template <int dim>
  void
  assemble_mass(const DistributedDiscretisation<dim> &body,
                TrilinosWrappers::SparseMatrix       &M)
  {
    assemble<dim>(
      body,
      DoFTools::none,
      QGauss<dim>(3),
      update_values,
      [&](const FEValues<dim> &values, FullMatrix<double> &mass) {
        cell_mass(values, body.material.density, mass);
      },
      M);
  }



  template <int dim>
  DistributedVector
  lumped_mass(const DistributedDiscretisation<dim> &body)
  {
    DistributedVector                    masses(body.dofs.locally_owned_dofs(),
                             body.relevant_dofs,
                             body.dofs.get_communicator());
    const auto                          &element = body.dofs.get_fe();
    FEValues<dim>                        values(element,
                         QGauss<dim>(2),
                         update_values | update_JxW_values);
    Vector<double>                       cell_masses(element.dofs_per_cell);
    std::vector<types::global_dof_index> cell_dofs(element.dofs_per_cell);
    const double                         density =
      body.material.density * (dim == 2 ? body.thickness : 1.);
    for (const auto &cell : body.dofs.active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        values.reinit(cell);
        cell->get_dof_indices(cell_dofs);
        cell_lumped_mass(values, density, cell_masses);
        body.constraints.distribute_local_to_global(cell_masses,
                                                    cell_dofs,
                                                    masses);
      }
    masses.compress(VectorOperation::add);
    DistributedVector owned(body.dofs.locally_owned_dofs(),
                            body.dofs.get_communicator());
    owned.copy_locally_owned_data_from(masses);
    return owned;
  }



  namespace
  {
    /**
     * The value of rigid motion number @p mode at a point.
     */
    Tensor<1, 2>
    rigid_motion(const unsigned int mode, const Point<2> &x)
    {
      Tensor<1, 2> value;
      if (mode < 2)
        value[mode] = 1.;
      else
        {
          value[0] = -x[1];
          value[1] = x[0];
        }
      return value;
    }



    Tensor<1, 3>
    rigid_motion(const unsigned int mode, const Point<3> &x)
    {
      Tensor<1, 3> value;
      if (mode < 3)
        value[mode] = 1.;
      else
        {
          Tensor<1, 3> axis;
          axis[mode - 3] = 1.;
          value          = cross_product_3d(axis, x);
        }
      return value;
    }
  } // namespace



  template <int dim>
  std::vector<DistributedVector>
  rigid_motions(const DistributedDiscretisation<dim> &body,
                const Point<dim>                     &centre,
                const double                          length)
  {
    const unsigned int             n_modes = dim * (dim + 1) / 2;
    std::vector<DistributedVector> modes;
    for (unsigned int mode = 0; mode < n_modes; ++mode)
      modes.emplace_back(body.dofs.locally_owned_dofs(),
                         body.dofs.get_communicator());
    for (const auto &cell : body.dofs.active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        for (const unsigned int v : cell->vertex_indices())
          {
            const Point<dim> at((cell->vertex(v) - centre) / length);
            for (unsigned int d = 0; d < dim; ++d)
              {
                const auto dof = cell->vertex_dof_index(v, d);
                if (!modes[0].in_local_range(dof) ||
                    body.constraints.is_constrained(dof))
                  continue;
                for (unsigned int mode = 0; mode < n_modes; ++mode)
                  modes[mode](dof) = rigid_motion(mode, at)[d];
              }
          }
      }
    return modes;
  }



  template void
  assemble_stiffness(const DistributedDiscretisation<2> &,
                     TrilinosWrappers::SparseMatrix &);
  template void
  assemble_stiffness(const DistributedDiscretisation<3> &,
                     TrilinosWrappers::SparseMatrix &);
  template void
  assemble_mass(const DistributedDiscretisation<2> &,
                TrilinosWrappers::SparseMatrix &);
  template void
  assemble_mass(const DistributedDiscretisation<3> &,
                TrilinosWrappers::SparseMatrix &);
  template DistributedVector
  lumped_mass(const DistributedDiscretisation<2> &);
  template DistributedVector
  lumped_mass(const DistributedDiscretisation<3> &);
  template std::vector<DistributedVector>
  rigid_motions(const DistributedDiscretisation<2> &,
                const Point<2> &,
                const double);
  template std::vector<DistributedVector>
  rigid_motions(const DistributedDiscretisation<3> &,
                const Point<3> &,
                const double);
} // namespace RollingContact
