#ifndef rolling_contact_results_state_damage_h
#define rolling_contact_results_state_damage_h

#include <rolling_contact/damage/line_depths.h>
#include <rolling_contact/results/lines_across.h>

#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * Wear and fatigue of a steady state: what its nodes and its lines along x
   * are to the laws of room `damage`, and what is told of it where Wear/Report
   * asks for that.
   */
  class StateDamage
  {
  public:
    /** For states of which it is_asked(). Keeps references. */
    StateDamage(const PairSpec       &scene,
                const ContactProblem &problem,
                const ContactState   &state);

    /** Whether it is to be told: not without friction, not of time steps. */
    static bool is_asked(const PairSpec &scene, const ContactProblem &problem);

    /** Archard's law by its chart asks for Contact/Speed. */
    bool can_tell(const Damage::WearLaw &law) const
    {
      return !law.needs_speed(scene.wear) || scene.contact.speed.has_value();
    }

    /** The laws that can be told. */
    std::vector<Damage::WearLaw> laws() const;

    /** Worn depth of the rail per metre rolled over each node. Units: m/m. */
    std::vector<double> rates(const Damage::WearLaw &law) const;

    /** |q|/p - k/p, NaN where there is no pressure. */
    std::vector<double> surface_indices() const;

    /** Worn depth of the rail under a line for a passage. Units: m. */
    double depth(const LineAcross               &line,
                 const Damage::WearLaw          &law,
                 const Damage::DamageParameters &constants) const;

    /** Points (|q|/p, p/k) of the nodes that slide in the shakedown map. */
    std::pair<std::vector<double>, std::vector<double>> sliding_points() const;

    /** Shares of friction with their loads. */
    std::vector<Damage::FrictionUse> friction_uses() const;

  private:
    const PairSpec                  &scene;
    const ContactProblem            &problem;
    const ContactState              &state;
    const TangentialProblem          tangential;
    std::vector<Damage::RubbingNode> nodes;
  };

  /**
   * Radius at which the wheel rolls on a line; that of the wheel without
   * profiles, none for a wheel that is flat. Units: m.
   */
  std::optional<double> rolling_radius(const PairSpec &scene, const double y);

  /** Wear and fatigue in the row of results.csv of a state. */
  void set_damage_columns(const PairSpec       &scene,
                          const SteadyState<3> &steady,
                          ResultsTable         &table);

  /** Depths per passage of a line in its row of across.csv. */
  void set_depth_columns(const PairSpec    &scene,
                         const StateDamage &damage,
                         const LineAcross  &line,
                         ResultsTable      &table);

  /** The summary's line on a state; nothing unless Wear/Report asks for it. */
  void note_damage(const PairSpec       &scene,
                   const SteadyState<3> &steady,
                   RunReport            &report);

  /**
   * The shakedown map with a point for each patch and each node that slides,
   * NAME.svg. Nothing unless Wear/Report asks for it.
   */
  void plot_shakedown_map(const PairSpec       &scene,
                          const SteadyState<3> &steady,
                          RunContext           &context,
                          const std::string    &name = "shakedown");
} // namespace RollingContact

#endif
