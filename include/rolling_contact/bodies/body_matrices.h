#ifndef rolling_contact_bodies_body_matrices_h
#define rolling_contact_bodies_body_matrices_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>

#include <rolling_contact/algebra/skew_sparse_matrix.h>
#include <rolling_contact/algebra/symmetric_sparse_matrix.h>
#include <rolling_contact/bodies/supports.h>
#include <rolling_contact/bodies/theta_scheme.h>
#include <rolling_contact/mesh/body_model.h>
#include <rolling_contact/mesh/body_shape.h>
#include <rolling_contact/mesh/material.h>

#include <array>
#include <vector>

namespace RollingContact
{
  /**
   * What the matrices of a body are assembled from: linear elements, their
   * hanging nodes and clamped or tied nodes constrained, the rest and then the
   * extra unknowns of the supports numbered as unknowns (-1 if constrained).
   * @p thickness is used in 2D. Units: m.
   */
  template <int dim>
  struct Discretisation
  {
    const dealii::DoFHandler<dim>           &dofs;
    const dealii::AffineConstraints<double> &constraints;
    const std::vector<int>                  &unknown_of_dof;
    std::size_t                              n_unknowns;
    Materials                                materials;
    double                                   thickness;
    ElementKind                              elements;
    const Supports<dim>                     &supports;
  };

  /**
   * Factors of the parts that a stiffness is the sum of.
   */
  struct StiffnessParts
  {
    double material   = 1.;
    double foundation = 1.;
    double ballast    = 1.;
  };

  /**
   * Stiffness K of the unknowns, the sum of its @p parts: linear elements, in
   * 2D plane strain, and supports. Units: N/m.
   */
  template <int dim>
  SymmetricSparseMatrix assemble_stiffness(const Discretisation<dim> &body,
                                           const StiffnessParts &parts = {});

  /**
   * Mass M of the unknowns. Consistent: the integral of rho phi_i phi_j.
   * Lumped: its row sums, the integral of rho phi_i, a diagonal matrix; a
   * hanging node's mass goes to the nodes it hangs between by their weights,
   * which keeps the total mass and the centre of mass. The masses of a hub that
   * is fixed to a rigid mass join it: a dense block of the last unknowns.
   * Units: kg.
   */
  template <int dim>
  SymmetricSparseMatrix assemble_mass(const Discretisation<dim> &body,
                                      const MassKind             kind);

  /**
   * A mass at a point of a body's own frame, in 2D with y = 0. Units: m, kg.
   */
  struct PointMass
  {
    std::array<double, 3> point;
    double                mass;
  };

  /**
   * The lumped masses of the nodes that are clamped, which no unknown has.
   */
  template <int dim>
  std::vector<PointMass> clamped_masses(const Discretisation<dim> &body);

  /**
   * The matrix of flow round an axle, in 3D,
   *
   *   S_ij = integral rho phi_i . d phi_j / d theta,
   *
   * the derivative of the vector along the circles about the axle, from +z
   * towards +x at the contact point. It is skew for a body of revolution, and
   * what the mesh leaves of a symmetric part is taken away. Units: kg.
   */
  SkewSparseMatrix assemble_rotation(const Discretisation<3> &body,
                                     const Axle              &axle);
} // namespace RollingContact

#endif
