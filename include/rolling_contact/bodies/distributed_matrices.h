#ifndef rolling_contact_bodies_distributed_matrices_h
#define rolling_contact_bodies_distributed_matrices_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <rolling_contact/mesh/body_model.h>
#include <rolling_contact/mesh/material.h>

#include <vector>

namespace RollingContact
{
  /**
   * What the matrices of a distributed body are assembled from: linear elements
   * on a mesh by p4est, with hanging and clamped nodes constrained. Unlike in
   * Discretisation all degrees of freedom keep their row; a constrained one has
   * a diagonal entry only. The thickness is used in 2D. Units: m.
   */
  template <int dim>
  struct DistributedDiscretisation
  {
    const dealii::DoFHandler<dim>           &dofs;
    const dealii::IndexSet                  &relevant_dofs;
    const dealii::AffineConstraints<double> &constraints;
    Materials                                materials;
    double                                   thickness;
    ElementKind                              elements;
  };

  using DistributedVector = dealii::LinearAlgebra::distributed::Vector<double>;

  /**
   * Assemble the stiffness matrix K, see add_stiffness(). Units: N/m.
   * Collective.
   */
  template <int dim>
  void assemble_stiffness(const DistributedDiscretisation<dim>   &body,
                          dealii::TrilinosWrappers::SparseMatrix &K);

  /**
   * Assemble the consistent mass matrix M. Units: kg. Collective.
   */
  template <int dim>
  void assemble_mass(const DistributedDiscretisation<dim>   &body,
                     dealii::TrilinosWrappers::SparseMatrix &M);

  /**
   * Diagonal of the lumped mass matrix M; zero at constrained nodes. Units: kg.
   * Collective.
   */
  template <int dim>
  DistributedVector lumped_mass(const DistributedDiscretisation<dim> &body);

  /**
   * Rigid motions of the body, zero at constrained nodes: dim translations,
   * then one rotation in 2D or three in 3D about @p centre. Distances from it
   * are divided by @p length, so that all motions are of similar size. Units:
   * m for centre and length, 1 for the motions. Collective.
   */
  template <int dim>
  std::vector<DistributedVector>
  rigid_motions(const DistributedDiscretisation<dim> &body,
                const dealii::Point<dim>             &centre,
                const double                          length);
} // namespace RollingContact

#endif
