#include <rolling_contact/damage/rcf_indices.h>
#include <rolling_contact/references/checks.h>

#include <algorithm>
#include <limits>

namespace RollingContact::Damage
{
  namespace
  {
    void check_yield(const double shear_yield_stress)
    {
      References::check_positive("Shear yield stress",
                                 shear_yield_stress,
                                 "Pa");
    }
  } // namespace

  double utilised_friction(const double tangential_force,
                           const double normal_force)
  {
    References::check_not_negative("Tangential force", tangential_force, "N");
    References::check_positive("Normal force", normal_force, "N");
    return tangential_force / normal_force;
  }

  double load_factor(const double max_pressure, const double shear_yield_stress)
  {
    References::check_not_negative("Peak pressure", max_pressure, "Pa");
    check_yield(shear_yield_stress);
    return max_pressure / shear_yield_stress;
  }

  double surface_fatigue_index(const double utilised_friction,
                               const double max_pressure,
                               const double shear_yield_stress)
  {
    References::check_not_negative("Utilised friction", utilised_friction);
    References::check_positive("Peak pressure", max_pressure, "Pa");
    check_yield(shear_yield_stress);
    return utilised_friction - shear_yield_stress / max_pressure;
  }

  double surface_fatigue_index_of_area(const double utilised_friction,
                                       const double normal_force,
                                       const double area,
                                       const double shear_yield_stress)
  {
    References::check_positive("Area", area, "m^2");
    return surface_fatigue_index(utilised_friction,
                                 3 * normal_force / (2 * area),
                                 shear_yield_stress);
  }

  double nodal_surface_index(const double traction,
                             const double pressure,
                             const double shear_yield_stress)
  {
    check_yield(shear_yield_stress);
    return pressure > 0. ? (traction - shear_yield_stress) / pressure
                         : -std::numeric_limits<double>::infinity();
  }

  double subsurface_fatigue_index(const double utilised_friction,
                                  const double normal_force,
                                  const double area)
  {
    References::check_not_negative("Utilised friction", utilised_friction);
    References::check_not_negative("Normal force", normal_force, "N");
    References::check_positive("Area", area, "m^2");
    return normal_force / (4 * area) *
           (1 + utilised_friction * utilised_friction);
  }

  double t_gamma_damage(const double energy, const DamageThreshold threshold)
  {
    References::check_not_negative("Energy per metre rolled", energy, "J/m");
    const double from = threshold == DamageThreshold::newton_15 ? 15. : 20.,
                 most = 1e-5, at = 65., to = 175.;
    const double damage = energy < at ? most * (energy - from) / (at - from)
                                      : most * (to - energy) / (to - at);
    return std::max(0., damage);
  }

  double friction_use_percentile(std::vector<FrictionUse> nodes,
                                 const double             portion)
  {
    if (!(portion >= 0. && portion <= 1.))
      References::reject("Portion", portion, "", "within 0 and 1");
    std::sort(nodes.begin(),
              nodes.end(),
              [](const FrictionUse &one, const FrictionUse &other) {
                return one.share < other.share;
              });
    double load = 0.;
    for (const FrictionUse &node : nodes)
      load += std::max(0., node.normal_force);
    double carried = 0., share = 0.;
    for (const FrictionUse &node : nodes)
      if (node.normal_force > 0.)
        {
          carried += node.normal_force;
          share = node.share;
          if (carried >= portion * load * (1 - 1e-12))
            break;
        }
    return share;
  }
} // namespace RollingContact::Damage
