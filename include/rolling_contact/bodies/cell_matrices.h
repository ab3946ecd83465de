#ifndef rolling_contact_bodies_cell_matrices_h
#define rolling_contact_bodies_cell_matrices_h

#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <rolling_contact/mesh/material.h>

namespace RollingContact
{
  /**
   * Stiffness of a cell, B-bar by mean dilatation: K_ij = integral of 2 G
   * dev(eps_i) : dev(eps_j)
   * + V k mean(div phi_i) mean(div phi_j) with the bulk modulus k and the
   * deviator of the three-dimensional strain, eps_yy = 0 in plane strain
   * (Hughes 1980). Units: N/m, in 2D per metre of thickness.
   */
  template <int dim>
  void cell_stiffness(const dealii::FEValues<dim, dim> &values,
                      const Material                   &material,
                      dealii::FullMatrix<double>       &stiffness);

  /**
   * Stiffness of a cell with incompatible modes, which passes the patch test:
   * strains are those of the shape functions and of dim modes 1 - xi_i^2 in
   * each component, with gradients (j0/j) J0^-T grad_xi by the Jacobian of the
   * middle of the cell; the dim^2 internal unknowns are condensed, K_uu - K_ua
   * K_aa^-1 K_au (Taylor, Beresford, Wilson 1976; the enhanced strains of Simo
   * and Rifai 1990 with 9 modes). Units: N/m, in 2D per metre of thickness.
   */
  template <int dim>
  void cell_stiffness_enhanced(const dealii::FEValues<dim, dim> &values,
                               const Material                   &material,
                               dealii::FullMatrix<double>       &stiffness);

  /**
   * Consistent mass of a cell, the integral of rho phi_i phi_j. Units: kg, in
   * 2D per metre of thickness.
   */
  template <int dim>
  void cell_mass(const dealii::FEValues<dim, dim> &values,
                 const double                      density,
                 dealii::FullMatrix<double>       &mass);

  /**
   * Lumped mass of a cell, the integral of rho phi_i: the row sums of
   * cell_mass(). Units: kg, in 2D per metre of thickness.
   */
  template <int dim>
  void cell_lumped_mass(const dealii::FEValues<dim, dim> &values,
                        const double                      density,
                        dealii::Vector<double>           &mass);
} // namespace RollingContact

#endif
