#ifndef rolling_contact_elasticity_body_matrices_h
#define rolling_contact_elasticity_body_matrices_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>

#include <rolling_contact/dynamics/theta_scheme.h>
#include <rolling_contact/elasticity/material.h>
#include <rolling_contact/linear_algebra/symmetric_sparse_matrix.h>

#include <vector>

namespace RollingContact
{
  /**
   * What the matrices of a body are assembled from: linear elements, their
   * hanging nodes and clamped nodes constrained, the rest numbered as unknowns
   * (-1 if constrained). @p thickness is used in 2D. Units: m.
   */
  template <int dim>
  struct Discretisation
  {
    const dealii::DoFHandler<dim>           &dofs;
    const dealii::AffineConstraints<double> &constraints;
    const std::vector<int>                  &unknown_of_dof;
    std::size_t                              n_unknowns;
    Material                                 material;
    double                                   thickness;
  };

  /**
   * Stiffness K of the unknowns: linear elements with B-bar, in 2D plane
   * strain. Units: N/m.
   */
  template <int dim>
  SymmetricSparseMatrix
  assemble_stiffness(const Discretisation<dim> &body);

  /**
   * Mass M of the unknowns. Consistent: the integral of rho phi_i phi_j.
   * Lumped: its row sums, the integral of rho phi_i, a diagonal matrix; a
   * hanging node's mass goes to the nodes it hangs between by their weights,
   * which keeps the total mass and the centre of mass. Units: kg.
   */
  template <int dim>
  SymmetricSparseMatrix
  assemble_mass(const Discretisation<dim> &body, const MassKind kind);
} // namespace RollingContact

#endif
