#ifndef rolling_contact_time_history_rows_h
#define rolling_contact_time_history_rows_h

#include <rolling_contact/scene/situation.h>
#include <rolling_contact/time/checkpoint.h>
#include <rolling_contact/time/contact_stepper.h>

#include <string>
#include <vector>

namespace RollingContact
{
  struct HistoryStep;

  /**
   * The columns of history.csv that a scene has: those of every run, and some
   * with inertia, a free wheel, surfaces that move, falling friction, points.
   * Units: as the names say.
   */
  class HistoryRows
  {
  public:
    struct Column
    {
      std::string name;
      double (*value)(const HistoryStep &step);
    };

    explicit HistoryRows(const Situation &scene);

    const std::vector<std::string> &names() const
    {
      return all_names;
    }

    /**
     * The row of the step just taken; @p progress includes it.
     */
    template <int dim>
    std::vector<double> row(const ContactStepper<dim> &stepper,
                            const StepOutcome         &outcome,
                            const TransientProgress   &progress) const;

  private:
    const std::vector<Column> columns;
    std::vector<std::string>  all_names; ///< with those of points
  };
} // namespace RollingContact

#endif
