#ifndef rolling_contact_modes_modal_damping_h
#define rolling_contact_modes_modal_damping_h

#include <rolling_contact/modes/structural_modes.h>

#include <vector>

namespace RollingContact
{
  /**
   * Damping ratio of each mode alone,
   *   zeta_j + phi_j^T H phi_j / (2 lambda_j) + phi_j^T C phi_j / (2 omega_j),
   * what is @p given and what loss stiffness H and viscous damping C (empty if
   * there is none) add; 0 for a rigid mode. Units: 1, N/m, N s/m.
   */
  std::vector<double> total_damping(const StructuralModes       &modes,
                                    const std::vector<double>   &given,
                                    const SymmetricSparseMatrix &H,
                                    const SymmetricSparseMatrix &C);

  /**
   * Damping matrix of the modes,
   *   C_ij = phi_i^T C phi_j + phi_i^T H phi_j / sqrt(omega_i omega_j),
   * that of viscous damping C and, of loss stiffness H, the viscous one in
   * which each mode loses at its own frequency what H takes from it; without
   * losses of rigid modes. From both in terms of the modes, Phi^T C Phi and
   * Phi^T H Phi. Units: 1/s, 1/s^2.
   */
  DenseMatrix modal_damping_matrix(const StructuralModes &modes,
                                   const DenseMatrix     &H_m,
                                   const DenseMatrix     &viscous);

  /** Phi^T A Phi, zero if A is empty. */
  DenseMatrix in_modes(const StructuralModes       &modes,
                       const SymmetricSparseMatrix &A);
} // namespace RollingContact

#endif
