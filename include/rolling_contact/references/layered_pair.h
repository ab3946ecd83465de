#ifndef rolling_contact_references_layered_pair_h
#define rolling_contact_references_layered_pair_h

#include <Eigen/Core>

#include <rolling_contact/references/layered_plane.h>

#include <array>
#include <functional>

namespace RollingContact::References
{
  /**
   * Two bodies in contact, each with a layer or, with thickness 0, without.
   */
  using LayeredPair = std::array<LayeredPlane, 2>;

  /**
   * Compliance of the half-plane of the material at the surface of a body: that
   * of its layer, or of its core where there is none.
   */
  SurfaceCompliance material_compliance(const LayeredPlane &body);

  /**
   * Compliance of a pair of half-planes of the materials at the surfaces, to
   * pressure and to a traction which acts on body 1 in +x and on body 2 against
   * it.
   */
  SurfaceCompliance of_materials(const LayeredPair &bodies);

  /**
   * Compliance of a pair at the wave number k (1/m) less of_materials(): it
   * falls off like exp(-2 k h).
   */
  SurfaceCompliance beyond_materials(const LayeredPair &bodies, const double k);

  /**
   * Bessel functions J_1(z) to J_n(z) for z > 0, by Miller's recurrence
   * downwards.
   */
  Eigen::VectorXd bessel_functions(const unsigned int n, const double z);

  /**
   * Call @p add(k, weight) at the wave numbers k (1/m) of an integral over what
   * layers add: Gauss points on panels that grow from 0 and resolve waves over
   * a half-length (m), up to where beyond_materials() is nothing. Never without
   * layers.
   */
  void
  over_wave_numbers(const LayeredPair &bodies,
                    const double       half_length,
                    const std::function<void(const double, const double)> &add);

  /**
   * Contact modulus E* (Pa) of bodies with layers under the pressure of Hertz
   * over a circle of this radius (m): that of half-spaces whose surface lies as
   * much deeper in the middle of the circle than at its edge. It is E* where
   * there are no layers, and an estimate elsewhere.
   */
  double layered_contact_modulus(const double       radius,
                                 const LayeredPair &bodies);
} // namespace RollingContact::References

#endif
