#ifndef rolling_contact_damage_damage_parameters_h
#define rolling_contact_damage_damage_parameters_h

namespace RollingContact::Damage
{
  /**
   * Where in its printed range the wear coefficient of Archard's law is taken:
   * results with `lowest` and `highest` bound the scatter of its measurements.
   */
  enum class ArchardScatter
  {
    lowest,
    middle,
    highest
  };

  /**
   * The three readings of the USFD law above 77.2 N/mm^2, see usfd_mass_loss().
   */
  enum class CatastrophicBranch
  {
    continuous,
    code,
    florence
  };

  /**
   * Constants of the steel and choices within laws of wear and fatigue.
   * Hardness and shear yield stress are recalled from the literature on rail
   * and wheel steels, unverified; K is that of the first branch of
   * usfd_mass_loss(). Units: Pa, kg/m^3, kg/J, 1.
   */
  struct DamageParameters
  {
    double hardness             = 3e9;    ///< H, of the softer body
    double density              = 7850.;  ///< rho
    double shear_yield_stress   = 300e6;  ///< k
    double worn_mass_per_energy = 5.3e-9; ///< K, worn mass per energy
    double archard_coefficient  = 0.;     ///< k of Archard; 0: by the chart

    ArchardScatter     archard_scatter     = ArchardScatter::middle;
    CatastrophicBranch catastrophic_branch = CatastrophicBranch::continuous;
  };
} // namespace RollingContact::Damage

#endif
