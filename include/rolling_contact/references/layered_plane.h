#ifndef rolling_contact_references_layered_plane_h
#define rolling_contact_references_layered_plane_h

namespace RollingContact::References
{
  /**
   * A half-plane with an elastic layer bonded on it, in plane strain. A core
   * with E = infinity is rigid, a layer of thickness 0 is none; nu = 1/2 is
   * allowed. Units: m, Pa.
   */
  struct LayeredPlane
  {
    double thickness;
    double young_modulus, poisson_ratio; ///< of the layer
    double core_young_modulus, core_poisson_ratio;
  };

  /**
   * Compliance of a surface to waves of wave number k > 0 (1/m): pressure p cos
   * kx and traction q sin kx along x on the surface move it by
   *   u_z = (normal p + coupling q)/k cos kx into the body,
   *   u_x = (coupling p + tangential q)/k sin kx.
   * A half-plane has normal = tangential = 2 (1-nu^2)/E and coupling =
   * -(1+nu)(1-2nu)/E for all k. Units: 1/Pa.
   */
  struct SurfaceCompliance
  {
    double normal, tangential, coupling;
  };

  /**
   * Compliance of a half-plane of one material; a rigid one has none.
   */
  SurfaceCompliance half_plane_compliance(const double young_modulus,
                                          const double poisson_ratio);

  /**
   * Exact compliance of a layered half-plane at the wave number k (1/m), from
   * the equations of plane strain in depth, y' = A y for displacements and
   * stresses with (A^2 - 1)^2 = 0, so that exp(A k h) is a polynomial of A. The
   * limits are those of the core for k h -> 0 and of the layer's material for k
   * h -> infinity. A thin layer on a rigid core has normal = k h
   * (1+nu)(1-2nu)/(E (1-nu)), that of nu = 1/2 (k h)^3/E (Johnson 1985, 5.8).
   */
  SurfaceCompliance compliance(const LayeredPlane &plane,
                               const double        wave_number);
} // namespace RollingContact::References

#endif
