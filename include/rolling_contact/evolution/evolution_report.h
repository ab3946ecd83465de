#ifndef rolling_contact_evolution_evolution_report_h
#define rolling_contact_evolution_evolution_report_h

#include <rolling_contact/evolution/evolution_state.h>
#include <rolling_contact/evolution/wear_step.h>
#include <rolling_contact/run/figure.h>
#include <rolling_contact/run/run_context.h>
#include <rolling_contact/surfaces/conicity.h>
#include <rolling_contact/surfaces/profile_measures.h>

#include <optional>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * What a body of a side has lost, and where most. Units: m, m^2.
   */
  struct BodyWear
  {
    double depth = 0., at_y = 0., area = 0.;
  };

  /**
   * Profiles after a part of the way. Units: m, 1.
   */
  struct WornSide
  {
    std::array<BodyWear, 2>                 bodies; ///< wheel, rail
    std::optional<Profiles::FlangeMeasures> flange;
  };

  /**
   * The output of an evolution of profiles: results.csv with a row for each
   * step and side, duty.csv with a row for each row of the duty at each step, a
   * file of each profile at each step, a film of them, and evolution.svg.
   */
  class EvolutionReport
  {
  public:
    EvolutionReport(const Situation             &scene,
                    const EvolutionParameters   &section,
                    const std::vector<DutyCase> &duty,
                    const RunningSurfaces       &before,
                    RunContext                  &context);

    /** What the sides have lost so far. */
    std::vector<WornSide> worn(const RunningSurfaces &surfaces) const;

    void add(const EvolutionPoint  &point,
             const RunningSurfaces &surfaces,
             const DutyStates      &states);

    /** What there is so far, in a state. */
    void save(EvolutionState &state) const;

    /** As it was saved. */
    void restore(const EvolutionState &state);

    const RunningSurfaces &last_surfaces() const
    {
      return shown.back().second;
    }

    /** Once all are there, or as far as it came. */
    void finish(const std::string &why_ended);

  private:
    void add_side(const EvolutionPoint             &point,
                  const std::size_t                 side,
                  const WornSide                   &worn,
                  const Profiles::RadiusDifference &difference);

    void add_duty(const EvolutionPoint &point, const DutyStates &states);

    void set_way(const EvolutionPoint &point, ResultsTable &table) const;

    /** Each profile as a file NAME with the ending of the format. */
    void write_profiles(const std::string                &name,
                        const std::array<std::string, 2> &endings,
                        const Profiles::ProfileFormat     format,
                        const double                      share,
                        const RunningSurfaces            &surfaces);

    /** What to read the file of a curve with, for its comment. */
    std::string title_of(const Profiles::ProfileCurve &curve,
                         const unsigned int            body,
                         const double                  radius,
                         const double                  share) const;

    /** In its own axes, as a file of a profile has it. */
    Profiles::ProfileCurve section_of(const Profiles::ProfileCurve &curve,
                                      const unsigned int            body) const;

    /** Strips of the profiles that have none yet, and profiles.pvd. */
    void add_to_film();

    /** See worn_strip(). */
    void write_strip(const std::string     &file,
                     const RunningSurfaces &surfaces,
                     const unsigned int     side,
                     const unsigned int     body) const;

    void plot_over_way() const;

    void plot_profiles() const;

    /** Sections and depths over y of a body of a side. */
    void add_profiles(Figure            &sections,
                      Figure            &depths,
                      const std::size_t  side,
                      const unsigned int body) const;

    /** Columns of results.csv, or their change, over the way; y is scaled. */
    void add_columns(Figure                         &figure,
                     const std::vector<std::string> &columns,
                     const std::vector<std::string> &labels,
                     const double                    scale,
                     const bool                      changes) const;

    void add_work_of_rows(Figure &figure) const;

    /** How far the worst step is off. */
    void state_error() const;

    /** The part of the way in km rolled, or in passages. */
    double way(const double share) const;

    bool wears(const unsigned int body) const
    {
      return body == 0 ? section.wears_wheel() : section.wears_rail();
    }

    /** "", or "_right" and "_left". */
    std::string ending(const std::size_t side) const;

    const Situation             &scene;
    const EvolutionParameters   &section;
    const std::vector<DutyCase> &duty;
    const RunningSurfaces        before;
    RunContext                  &context;
    ResultsTable                 rows; ///< of the duty

    std::size_t n_filmed = 0; ///< of those that were shown

    /** Profiles as they were shown, with the way to there. */
    std::vector<std::pair<double, RunningSurfaces>> shown;
  };
} // namespace RollingContact

#endif
