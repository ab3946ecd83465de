#ifndef rolling_contact_damage_rcf_indices_h
#define rolling_contact_damage_rcf_indices_h

#include <vector>

namespace RollingContact::Damage
{
  /**
   * Utilised friction mu_u = T/N of a patch with the tangential force T and the
   * normal force N (N), dimensionless. Throws InputError unless T >= 0 and N >
   * 0.
   */
  double utilised_friction(const double tangential_force,
                           const double normal_force);

  /**
   * The load factor p0/k of the shakedown map, with the peak pressure p0 and
   * the shear yield stress k (Pa). Throws InputError unless p0 >= 0 and k > 0.
   */
  double load_factor(const double max_pressure,
                     const double shear_yield_stress);

  /**
   * Surface fatigue index FI_surf = mu_u - k/p0 of a patch, dimensionless: the
   * distance of its point from the surface branch p0/k = 1/mu_u of the
   * shakedown map, along mu_u; cracks at the surface are expected where it is
   * positive. Throws InputError unless mu_u >= 0, p0 > 0 and k > 0 (Pa).
   * Source: Ekberg, Kabo and Andersson 2002 (Fatigue Fract. Engng Mater.
   * Struct. 25), recalled, unverified.
   */
  double surface_fatigue_index(const double utilised_friction,
                               const double max_pressure,
                               const double shear_yield_stress);

  /**
   * FI_surf with the peak pressure of an ellipse of this area and load, mu_u -
   * 2 pi a b k/(3 N), pi a b the area of the patch (m^2) that was found: free
   * of peaks that a worn profile makes. Throws InputError unless mu_u >= 0, N >
   * 0 (N), area > 0 and k > 0 (Pa). Source: as surface_fatigue_index().
   */
  double surface_fatigue_index_of_area(const double utilised_friction,
                                       const double normal_force,
                                       const double area,
                                       const double shear_yield_stress);

  /**
   * The index of the surface at a node, |q|/p - k/p, positive where the
   * traction q exceeds the shear yield stress k; minus infinity where p is not
   * positive. Units: all Pa, the index is dimensionless.
   */
  double nodal_surface_index(const double traction,
                             const double pressure,
                             const double shear_yield_stress);

  /**
   * Subsurface fatigue index FI_sub = N/(4 pi a b) (1 + mu_u^2), pi a b the
   * area (m^2) of the patch: an estimate of the largest equivalent stress after
   * Dang Van below the surface, without residual stress; cracks below the
   * surface are expected where it exceeds the fatigue limit in shear of the
   * material. Units: Pa. Throws InputError unless mu_u and N (N) are not
   * negative and the area is positive. Source: Ekberg, Kabo and Andersson 2002,
   * recalled, unverified.
   */
  double subsurface_fatigue_index(const double utilised_friction,
                                  const double normal_force,
                                  const double area);

  /**
   * From which T gamma on a passage damages the surface: 15 N as in the first
   * publication (recalled), 20 N as programs have it.
   */
  enum class DamageThreshold
  {
    newton_15,
    newton_20
  };

  /**
   * Damage by rolling contact fatigue per passage, of the energy E = T gamma
   * (J per metre rolled, N): zero to the threshold, linear to 1e-5 at 65 N,
   * linear to 0 at 175 N, and 0 beyond, where wear takes cracks away faster
   * than they grow. Cracks are seen at a sum of 1. Throws InputError unless E
   * >= 0. Source: Burstow 2004 (whole life rail model) for grade R220; the form
   * with 20 N, 2.22e-7 E - 4.44e-6 and 1.59e-5 - 9.09e-8 E, seen in programs;
   * 15 N recalled, unverified.
   */
  double
  t_gamma_damage(const double          energy,
                 const DamageThreshold threshold = DamageThreshold::newton_15);

  /**
   * The share |q|/(mu p) of friction that a node uses, and its normal force (N)
   * as weight.
   */
  struct FrictionUse
  {
    double share        = 0.;
    double normal_force = 0.;
  };

  /**
   * The least share of friction that nodes with @p portion of the normal force
   * (0.95: the 95 % percentile) do not exceed, dimensionless; zero without
   * load. Nodes without normal force do not count. Throws InputError unless the
   * portion is within 0 and 1.
   */
  double friction_use_percentile(std::vector<FrictionUse> nodes,
                                 const double             portion = 0.95);
} // namespace RollingContact::Damage

#endif
