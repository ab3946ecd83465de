#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <rolling_contact/bodies/assembly.h>
#include <rolling_contact/bodies/distributed_matrices.h>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    /**
     * An empty matrix that couples all components or each with itself.
     */
    template <int dim>
    void reinit(const DistributedDiscretisation<dim> &body,
                const bool                            all_components,
                TrilinosWrappers::SparseMatrix       &matrix)
    {
      const MPI_Comm communicator = body.dofs.get_communicator();
      TrilinosWrappers::SparsityPattern pattern(body.dofs.locally_owned_dofs(),
                                                body.dofs.locally_owned_dofs(),
                                                body.relevant_dofs,
                                                communicator);
      DoFTools::make_sparsity_pattern(body.dofs,
                                      couplings<dim>(all_components),
                                      pattern,
                                      body.constraints,
                                      false,
                                      Utilities::MPI::this_mpi_process(
                                        communicator));
      pattern.compress();
      matrix.reinit(pattern);
    }
  } // namespace

  template <int dim>
  void assemble_stiffness(const DistributedDiscretisation<dim> &body,
                          TrilinosWrappers::SparseMatrix       &K)
  {
    reinit(body, true, K);
    add_stiffness(body, K);
    K.compress(VectorOperation::add);
  }

  template <int dim>
  void assemble_mass(const DistributedDiscretisation<dim> &body,
                     TrilinosWrappers::SparseMatrix       &M)
  {
    reinit(body, false, M);
    add_mass(body, M);
    M.compress(VectorOperation::add);
  }

  template <int dim>
  DistributedVector lumped_mass(const DistributedDiscretisation<dim> &body)
  {
    DistributedVector masses(body.dofs.locally_owned_dofs(),
                             body.relevant_dofs,
                             body.dofs.get_communicator());
    add_lumped_mass(body, masses);
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
    Tensor<1, 2> rigid_motion(const unsigned int mode, const Point<2> &x)
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

    Tensor<1, 3> rigid_motion(const unsigned int mode, const Point<3> &x)
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

  template void assemble_stiffness(const DistributedDiscretisation<2> &,
                                   TrilinosWrappers::SparseMatrix &);
  template void assemble_stiffness(const DistributedDiscretisation<3> &,
                                   TrilinosWrappers::SparseMatrix &);
  template void assemble_mass(const DistributedDiscretisation<2> &,
                              TrilinosWrappers::SparseMatrix &);
  template void assemble_mass(const DistributedDiscretisation<3> &,
                              TrilinosWrappers::SparseMatrix &);
  template DistributedVector lumped_mass(const DistributedDiscretisation<2> &);
  template DistributedVector lumped_mass(const DistributedDiscretisation<3> &);
  template std::vector<DistributedVector>
  rigid_motions(const DistributedDiscretisation<2> &,
                const Point<2> &,
                const double);
  template std::vector<DistributedVector>
  rigid_motions(const DistributedDiscretisation<3> &,
                const Point<3> &,
                const double);
} // namespace RollingContact
