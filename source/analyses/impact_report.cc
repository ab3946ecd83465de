#include <rolling_contact/analyses/impact_report.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/run/figure.h>
#include <rolling_contact/run/history_table.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    const char history_file[] = "impact_history.csv";

    /** The largest of all runs of an error over the value it belongs to; none
     * where one is not known. */
    template <typename Error, typename Value>
    std::optional<double> largest_share(const std::vector<Impact> &impacts,
                                        const Error               &error,
                                        const Value               &value)
    {
      double largest = 0.;
      for (const Impact &impact : impacts)
        {
          const std::optional<double> it = error(impact);
          if (!it)
            return {};
          largest = std::max(largest, *it / value(impact.extremes()));
        }
      return largest;
    }

    void note_error(const std::string           &quantity,
                    const std::optional<double> &share,
                    RunReport                   &report)
    {
      report.errors.push_back(
        {quantity,
         share.value_or(std::nan("")),
         "itself",
         share ? "steps of twice the length" : "steps of twice the length fail",
         true,
         "by the length of the steps",
         share});
    }
  } // namespace

  ImpactExtremes::ImpactExtremes(const std::vector<ImpactStep> &steps)
  {
    least_load = steps.front();
    for (std::size_t i = 0; i < steps.size(); ++i)
      {
        const ImpactStep &it = steps[i];
        if (it.load > largest_load.load)
          largest_load = it;
        if (it.pressure > largest_pressure.pressure)
          largest_pressure = it;
        if (it.load < least_load.load)
          least_load = it;
        if (it.load == 0.)
          parted += it.time - (i > 0 ? steps[i - 1].time : 0.);
      }
  }

  void add_row(const Impact &impact, ResultsTable &table)
  {
    const ImpactExtremes found = impact.extremes();
    const ImpactStep    &rest  = impact.at_rest;
    table.set("speed_m/s", impact.speed);
    table.set("time_step_s", impact.step);
    table.set("n_steps", impact.n_steps);
    table.set("load_at_rest_N", rest.load);
    table.set("largest_load_N", found.largest_load.load);
    table.set("largest_load/at_rest", found.largest_load.load / rest.load);
    table.set("largest_load_error_N", impact.load_error);
    table.set("largest_load_at_m", found.largest_load.rolled);
    table.set("least_load_N", found.least_load.load);
    table.set("parted_s", found.parted);
    table.set("pressure_at_rest_Pa", rest.pressure);
    table.set("largest_pressure_Pa", found.largest_pressure.pressure);
    table.set("largest_pressure/at_rest",
              found.largest_pressure.pressure / rest.pressure);
    table.set("largest_pressure_error_Pa", impact.pressure_error);
    table.set("largest_pressure_at_m", found.largest_pressure.rolled);
    table.end_row();
  }

  const Impact &worst_of(const std::vector<Impact> &impacts)
  {
    return *std::max_element(impacts.begin(),
                             impacts.end(),
                             [](const Impact &a, const Impact &b) {
                               return a.load_ratio() < b.load_ratio();
                             });
  }

  void note_impacts(const std::vector<Impact> &impacts, RunContext &context)
  {
    const Impact        &worst = worst_of(impacts);
    const ImpactExtremes found = worst.extremes();
    context.report.set_finding(
      "impact",
      "the largest load is " + significant(1e-3 * found.largest_load.load, 4) +
        " kN, " + significant(worst.load_ratio(), 3) +
        " times that at rest, at " + significant(worst.speed, 3) +
        " m/s after " + significant(found.largest_load.rolled, 4) + " m");
    const auto parts =
      std::find_if(impacts.begin(), impacts.end(), [](const Impact &impact) {
        return impact.extremes().parted > 0.;
      });
    context.report.set_finding(
      "lift",
      parts == impacts.end()
        ? "none, wheel and rail touch all the time"
        : "contact is lost from " + significant(parts->speed, 3) +
            " m/s on, for " + significant(1e3 * parts->extremes().parted, 3) +
            " ms there");
    note_error("largest load",
               largest_share(
                 impacts,
                 [](const Impact &impact) { return impact.load_error; },
                 [](const ImpactExtremes &all) {
                   return all.largest_load.load;
                 }),
               context.report);
    note_error("largest pressure",
               largest_share(
                 impacts,
                 [](const Impact &impact) { return impact.pressure_error; },
                 [](const ImpactExtremes &all) {
                   return all.largest_pressure.pressure;
                 }),
               context.report);
  }

  void write_history(const Impact                   &impact,
                     const std::vector<std::string> &columns,
                     RunContext                     &context)
  {
    HistoryTable table(context.folder, history_file, columns, false);
    for (const std::vector<double> &row : impact.run.rows)
      table.add_row(row);
    table.publish();
  }

  void plot_impacts(const std::vector<Impact> &impacts, RunContext &context)
  {
    const Impact       &worst = worst_of(impacts);
    std::vector<double> speeds, loads, pressures, rolled, load;
    for (const Impact &impact : impacts)
      {
        speeds.push_back(impact.speed);
        loads.push_back(impact.load_ratio());
        pressures.push_back(impact.extremes().largest_pressure.pressure /
                            impact.at_rest.pressure);
      }
    for (const ImpactStep &it : worst.run.steps)
      {
        rolled.push_back(it.rolled);
        load.push_back(it.load / worst.at_rest.load);
      }
    Figure figure("Impact", "speed (m/s)", "largest over that at rest");
    figure.add_curve("load", speeds, loads, CurveStyle::line_and_points);
    figure.add_curve("peak pressure",
                     speeds,
                     pressures,
                     CurveStyle::line_and_points);
    Figure history("", "rolled (m)", "load over that at rest");
    history.add_curve("at " + significant(worst.speed, 3) + " m/s",
                      rolled,
                      load);
    figure.add_separate_panel(history);
    figure.draw(context, "impacts");
  }
} // namespace RollingContact
