#ifndef rolling_contact_damage_wear_laws_h
#define rolling_contact_damage_wear_laws_h

#include <rolling_contact/damage/damage_parameters.h>

#include <string>
#include <vector>

namespace RollingContact::Damage
{
  constexpr double mm2_per_km = 1e-9; ///< m^2 per m rolled

  /**
   * What a node of a rolling contact tells a wear law. Units: Pa, N/m^2, m/s.
   */
  struct RubbingNode
  {
    double pressure      = 0.; ///< p
    double power         = 0.; ///< e = -q . s, heat per area and metre rolled
    double slip          = 0.; ///< |s|, sliding over rolling speed
    double sliding_speed = 0.; ///< |s| V
  };

  /**
   * Wear coefficient k of Archard's law, the one that is given or else by the
   * chart over sliding speed v (m/s) and pressure p (Pa), dimensionless: mild
   * below 0.2 m/s, 1 to 10 times 1e-4; severe from 0.2 to 0.7 m/s, 30 to 40;
   * mild again above; catastrophic where p > 0.8 H, 300 to 400. The middle is
   * 5, 35, 5, 350 times 1e-4. Source: Jendel 2002 (Wear 253), recalled,
   * unverified.
   */
  double archard_coefficient(const double            sliding_speed,
                             const double            pressure,
                             const DamageParameters &parameters = {});

  /**
   * Worn depth per metre rolled by Archard's law (1953), k p |s| / H, with k of
   * archard_coefficient(); zero where p is not positive. Units: m/m.
   */
  double archard_rate(const RubbingNode      &node,
                      const DamageParameters &parameters = {});

  /**
   * Worn mass per area and metre rolled (kg/m^2 per m) by the USFD law of the
   * power e (N/m^2): 1e-3 u(x), x = e in N/mm^2, u in ug per m and mm^2.
   *   u = 5.3 x for x < 10.4,  55 for 10.4 <= x < 77.2,  and from there on
   *   continuous: 55 + 61.9 (x - 77.2), the reading that does not jump,
   *   code:       61.9 x - 4778.7, not below 0, which falls to 0 at 77.2,
   *   florence:   61.9 x, which jumps to 4779 at 77.2.
   * Zero where e is not positive; at 10.4 u falls from 55.12 to 55 as printed.
   * Source: Braghin, Lewis, Dwyer-Joyce and Bruni 2006 (Wear 261) for R8T on
   * UIC60 900A: its first branches seen in programs that cite it, `code` in one
   * of them; `florence` recalled, unverified.
   */
  double usfd_mass_loss(const double             power,
                        const CatastrophicBranch catastrophic_branch =
                          CatastrophicBranch::continuous);

  /**
   * Worn depth per metre rolled by usfd_mass_loss() over the density. Units:
   * m/m.
   */
  double usfd_rate(const RubbingNode      &node,
                   const DamageParameters &parameters = {});

  /**
   * Worn depth per metre rolled that is linear in the power, K e / rho: the
   * worn mass is K times the energy, for negative e as well, so that sums are
   * exact. Source: K = 5.3e-9 kg/J of the first branch of usfd_mass_loss().
   * Units: m/m.
   */
  double t_gamma_rate(const RubbingNode      &node,
                      const DamageParameters &parameters = {});

  /**
   * A wear law that acts at a node.
   */
  struct WearLaw
  {
    std::string name;
    std::string help;

    /** Worn depth of the rail per metre rolled over it, m/m. */
    double (*rate)(const RubbingNode &, const DamageParameters &);

    /** Whether it asks for the speed of rolling. */
    bool needs_speed(const DamageParameters &parameters) const;
  };

  /**
   * The laws `archard`, `usfd` and `t-gamma`.
   */
  const std::vector<WearLaw> &wear_laws();

  /**
   * Worn area of the section of a wheel per metre rolled (m^2 per m; over
   * mm2_per_km: mm^2/km) by British Rail Research's law of a whole patch, of
   * the energy E = T gamma (J per m, N) and the diameter D (here m, in the law
   * mm): in mm^2/km 0.25 E/D for E < 100 N, 25/D for 100 <= E < 200 N, and
   * (1.19 E - 154)/D from 200 N on, where it jumps from 25/D to 84/D as
   * printed. Throws InputError unless E >= 0 and D > 0. Source: British Rail
   * Research 1991, recalled, unverified.
   */
  double brr_worn_area(const double energy, const double wheel_diameter);
} // namespace RollingContact::Damage

#endif
