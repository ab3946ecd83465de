#ifndef rolling_contact_bodies_curvature_correction_h
#define rolling_contact_bodies_curvature_correction_h

#include <rolling_contact/algebra/dense_matrix.h>
#include <rolling_contact/bodies/fading_region.h>
#include <rolling_contact/mesh/body_shape.h>
#include <rolling_contact/mesh/material.h>

#include <array>

namespace RollingContact
{
  /**
   * What the curvature of a body's surface, z = h(x, y) in place of z = 0, adds
   * to its displacements under and around a patch of these @p half_widths:
   * moments of displacement by force_moments(), as those of SplitBody. To first
   * order in h two loads i and j on the plane, of tractions t, have
   *   int h [- sigma_ab(j) eps_ab(i) + t_a(i) t_a(j) / G - t_a(i) u_z,a(j)
   *          - t_a(j) u_z,a(i) + t_z(i) u_z,z(j)] dS,   a, b = x, y,
   * of the fields of the half-space at z = 0, as the tractions that these have
   * at z = h are taken away and displacements are those there. The loads are
   * elliptical ones times polynomials, by their moments, on a grid of their
   * own out to @p grid_reach half-widths. Beyond they are those of moments, and
   * where fields fade out the integrand is - h sigma_ka(j) (chi^2 u_k(i)),a.
   * Units: m to m/(N m^degrees).
   */
  DenseMatrix curvature_correction(const BodyShape             &shape,
                                   const Material              &material,
                                   const std::array<double, 2> &half_widths,
                                   const FadingRegion          &fading,
                                   const double grid_reach = 10);
} // namespace RollingContact

#endif
