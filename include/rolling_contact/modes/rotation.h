#ifndef rolling_contact_modes_rotation_h
#define rolling_contact_modes_rotation_h

#include <rolling_contact/elasticity/direct_body.h>
#include <rolling_contact/mesh/body_shape.h>
#include <rolling_contact/modes/structural_modes.h>

namespace RollingContact
{
  /**
   * The matrix by which the modes of a body of revolution turn into each other
   * when it spins and is looked at from where it does not,
   *
   *   S_ij = integral rho phi_i . d phi_j / d theta,
   *
   * the derivative of the vector along the circles about the axle, in the sense
   * of rotation from +z to +x at the contact (a wheel's material flows in +x
   * there). It is skew-symmetric; what the mesh leaves of a symmetric part is
   * taken away. Seen from the contact the body that spins at Omega has
   *
   *   (d/dt + Omega d/dtheta)^2 M u + C (d/dt + Omega d/dtheta) u + K u = f,
   *
   * on the modes C_m + 2 Omega S and Lambda + Omega^2 S^2 + Omega C_m S; the
   * stiffening by centrifugal forces is left out. Units: 1.
   */
  DenseMatrix
  modal_rotation(const DirectBody<3>   &body,
                 const Axle            &axle,
                 const StructuralModes &modes);
} // namespace RollingContact

#endif
