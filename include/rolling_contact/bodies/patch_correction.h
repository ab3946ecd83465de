#ifndef rolling_contact_bodies_patch_correction_h
#define rolling_contact_bodies_patch_correction_h

#include <rolling_contact/algebra/dense_matrix.h>
#include <rolling_contact/bodies/direct_body.h>
#include <rolling_contact/bodies/fading_region.h>

namespace RollingContact
{
  /**
   * How a body differs from a half-space near its contact point: the matrix S
   * of displacements at the contact point, and their derivatives along the
   * surface, beyond those of the half-space, under each of force_moments(). The
   * displacement of the body is chi u_hs + u_c, u_hs that of the half-space and
   * u_c a field that is smooth where the load is, so that elements which do not
   * know the patch are enough:
   *   a(u_c, v) = F(v) = int (sigma_hs grad chi).v
   *                          - C:(u_hs x grad chi) : grad v dV
   *                      - int h sigma_hs,ka (chi v_k),a dS,
   *   S_kl = F_k K^-1 F_l + Q_kl,   Q_kl = F_k(chi u_hs,l)
   * with the first integral over the region where chi changes and the second,
   * of the curved surface z = h(x, y), a = x, y, beyond the loads, of which
   * @p fading leaves room for the farthest; in Q that of curvature_correction()
   * stands in its place. Factorises K. Units: m/N to m/(N m^degrees).
   */
  DenseMatrix patch_correction(DirectBody<3>      &body,
                               const BodyShape    &shape,
                               const FadingRegion &fading);
} // namespace RollingContact

#endif
