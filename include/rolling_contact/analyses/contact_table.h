#ifndef rolling_contact_analyses_contact_table_h
#define rolling_contact_analyses_contact_table_h

#include <rolling_contact/run/run_context.h>
#include <rolling_contact/scene/analysis_kind.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/surfaces/conicity.h>

#include <optional>
#include <vector>

namespace RollingContact
{
  /**
   * `Analysis = contact table`: where rigid profiles touch when the wheelset is
   * shifted, and how it is steered by that, or by a radius difference from a
   * file: a row of contact_table.csv for each shift and pictures; no finite
   * elements. Units: m, rad.
   */
  class ContactTable : public Analysis
  {
  public:
    ContactTable(const Situation &scene, RunContext &context);

    void run() override;

  private:
    /**
     * Both contacts of the wheelset at a shift.
     */
    struct Row
    {
      double                 shift, roll;
      Profiles::RigidContact right, left;
    };

    Row find(const double shift) const;

    /**
     * The conicities with each positive shift as amplitude, NaN where they are
     * not known.
     */
    void find_conicities();

    void write_rows();

    void summarise_contacts() const;

    void summarise_conicity() const;

    void plot_sections() const;

    void plot_gaps() const;

    void plot_steering() const;

    const Situation &scene;
    RunContext      &context;
    /** None if a file gives the radius difference; then there are no rows. */
    std::optional<Profiles::WheelOnRail> side;
    std::vector<Row>                     rows;
    Profiles::RadiusDifference           radius_difference;
    std::vector<double> harmonic, equivalent; ///< conicities, 1
  };

  AnalysisKind contact_table_kind();
} // namespace RollingContact

#endif
