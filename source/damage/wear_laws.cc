#include <rolling_contact/base/constants.h>
#include <rolling_contact/damage/wear_laws.h>
#include <rolling_contact/references/checks.h>

#include <algorithm>
#include <array>

namespace RollingContact::Damage
{
  namespace
  {
    /** Coefficients of a regime of wear, in the order of ArchardScatter. */
    using Range = std::array<double, 3>;

    constexpr Range mild{1e-4, 5e-4, 10e-4}, severe{30e-4, 35e-4, 40e-4},
      catastrophic{300e-4, 350e-4, 400e-4};

    /** ug per m and mm^2 from 77.2 N/mm^2 on. */
    double catastrophic_loss(const double x, const CatastrophicBranch branch)
    {
      switch (branch)
        {
          case CatastrophicBranch::code:
            return std::max(0., 61.9 * x - 4778.7);
          case CatastrophicBranch::florence:
            return 61.9 * x;
          default:
            return 55. + 61.9 * (x - 77.2);
        }
    }
  } // namespace

  double archard_coefficient(const double            sliding_speed,
                             const double            pressure,
                             const DamageParameters &parameters)
  {
    if (parameters.archard_coefficient > 0.)
      return parameters.archard_coefficient;
    const Range &range = pressure > 0.8 * parameters.hardness ? catastrophic
                         : sliding_speed >= 0.2 && sliding_speed <= 0.7 ? severe
                                                                        : mild;
    return range[static_cast<unsigned int>(parameters.archard_scatter)];
  }

  double archard_rate(const RubbingNode      &node,
                      const DamageParameters &parameters)
  {
    const double pressure = std::max(0., node.pressure);
    return archard_coefficient(node.sliding_speed, pressure, parameters) *
           pressure * node.slip / parameters.hardness;
  }

  double usfd_mass_loss(const double             power,
                        const CatastrophicBranch catastrophic_branch)
  {
    const double x = power / 1e6;
    const double u = x < 10.4   ? 5.3 * std::max(0., x)
                     : x < 77.2 ? 55.
                                : catastrophic_loss(x, catastrophic_branch);
    return 1e-3 * u; // 1 ug/mm^2 = 1e-9 kg / 1e-6 m^2
  }

  double usfd_rate(const RubbingNode &node, const DamageParameters &parameters)
  {
    return usfd_mass_loss(node.power, parameters.catastrophic_branch) /
           parameters.density;
  }

  double t_gamma_rate(const RubbingNode      &node,
                      const DamageParameters &parameters)
  {
    return parameters.worn_mass_per_energy * node.power / parameters.density;
  }

  bool WearLaw::needs_speed(const DamageParameters &parameters) const
  {
    return rate == &archard_rate && parameters.archard_coefficient == 0.;
  }

  const std::vector<WearLaw> &wear_laws()
  {
    static const std::vector<WearLaw> all{
      {"archard",
       "depth k p |s| / H, k given or by the sliding speed and p / H",
       &archard_rate},
      {"usfd", "mass by the power per area, with three branches", &usfd_rate},
      {"t-gamma", "mass linear in the energy", &t_gamma_rate}};
    return all;
  }

  double brr_worn_area(const double energy, const double wheel_diameter)
  {
    References::check_not_negative("Energy per metre rolled", energy, "J/m");
    References::check_positive("Wheel diameter", wheel_diameter, "m");
    const double diameter = wheel_diameter / mm;
    const double area     = energy < 100.   ? 0.25 * energy
                            : energy < 200. ? 25.
                                            : 1.19 * energy - 154.;
    return area / diameter * mm2_per_km;
  }
} // namespace RollingContact::Damage
