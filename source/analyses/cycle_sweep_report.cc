#include <rolling_contact/analyses/cycle_sweep.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/run/figure.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace RollingContact
{
  namespace
  {
    /// two cycles are the same within this
    const double same_frequency = 1e-3, same_amplitude = 0.02;

    /**
     * The larger of the amplitudes along x and y; 0 for a motion that has
     * decayed.
     */
    double amplitude(const ResultsTable &results, const std::size_t row)
    {
      if (end_of_row(results, row) == Cycles::Motion::decayed)
        return 0.;
      const double unknown = std::nan("");
      return std::fmax(
        results.number(row, "cycle_velocity_x_amplitude_m/s").value_or(unknown),
        results.number(row, "cycle_velocity_y_amplitude_m/s")
          .value_or(unknown));
    }

    bool are_alike(const ResultsTable &results,
                   const std::size_t   a,
                   const std::size_t   b)
    {
      const double v = amplitude(results, a), w = amplitude(results, b);
      const RunEnd end = end_of_row(results, a);
      if (end != end_of_row(results, b) ||
          !(v == w || std::abs(v - w) <= same_amplitude * std::fmax(v, w)))
        return false;
      if (end != Cycles::Motion::periodic)
        return true;
      const double f = results.number(a, "cycle_frequency_Hz").value(),
                   g = results.number(b, "cycle_frequency_Hz").value();
      return std::abs(g - f) <= same_frequency * f;
    }

    std::string what_starts_say(const std::vector<SweepRun> &runs,
                                const std::vector<double>   &starts,
                                const ResultsTable          &results)
    {
      std::vector<std::size_t> different;
      for (std::size_t row = 0; row < results.n_rows(); ++row)
        if (runs[row].first &&
            std::none_of(different.begin(), different.end(), [&](const auto k) {
              return are_alike(results, k, row);
            }))
          different.push_back(row);
      return different.size() < 2
               ? std::to_string(starts.size()) +
                   " starts end in the same motion"
               : std::to_string(starts.size()) + " starts end in " +
                   std::to_string(different.size()) + " different motions";
    }

    std::string what_directions_say(const std::vector<SweepRun> &runs,
                                    const ResultsTable          &results)
    {
      std::string differing;
      for (std::size_t down = 0; down < results.n_rows(); ++down)
        for (std::size_t up = 0; up < down; ++up)
          if (!runs[down].up && runs[up].up &&
              runs[up].start == runs[down].start &&
              runs[up].value == runs[down].value &&
              !are_alike(results, up, down))
            differing +=
              (differing.empty() ? "" : ", ") + significant(*runs[up].value, 6);
      return differing.empty()
               ? "no hysteresis: up and down end in the same motion at each value"
               : "hysteresis: up and down end in different motions at " +
                   differing;
    }
  } // namespace

  void plot_sweep(const LimitCycleParameters  &parameters,
                  const std::vector<SweepRun> &runs,
                  RunContext                  &context)
  {
    if (parameters.axis_entry().empty())
      return;
    const ResultsTable &results = context.results;
    struct Branch
    {
      std::vector<double> x, y;
    };
    std::map<std::pair<std::size_t, bool>, Branch> branches;
    std::map<double, double>                       growths;
    for (std::size_t row = 0; row < results.n_rows(); ++row)
      {
        Branch &branch = branches[{runs[row].start, !runs[row].up}];
        branch.x.push_back(*runs[row].value);
        branch.y.push_back(amplitude(results, row));
        growths[*runs[row].value] = *results.number(row, "largest_growth_1/s");
      }
    Figure amplitudes("Limit cycles", parameters.axis, "amplitude (m/s)");
    for (const auto &[key, branch] : branches)
      amplitudes.add_curve("start " + std::to_string(key.first + 1) +
                             (key.second ? ", down" : ", up"),
                           branch.x,
                           branch.y,
                           CurveStyle::line_and_points);
    Branch growth;
    for (const auto &[x, y] : growths)
      {
        growth.x.push_back(x);
        growth.y.push_back(y);
      }
    Figure below("", parameters.axis, "growth (1/s)");
    below.add_curve("while it is small",
                    growth.x,
                    growth.y,
                    CurveStyle::line_and_points);
    amplitudes.add_panel(below);
    amplitudes.draw(context, "limit_cycles");
  }

  void note_sweep(const LimitCycleParameters  &parameters,
                  const std::vector<SweepRun> &runs,
                  const std::vector<double>   &starts,
                  RunContext                  &context)
  {
    const ResultsTable                &results = context.results;
    std::map<std::string, std::size_t> kinds;
    std::size_t                        n_changing = 0;
    for (std::size_t row = 0; row < results.n_rows(); ++row)
      {
        ++kinds[name_of(end_of_row(results, row))];
        n_changing += end_of_row(results, row) == Cycles::Motion::changing;
      }
    std::string text;
    for (const auto &[kind, n] : kinds)
      text += (text.empty() ? "" : ", ") + std::to_string(n) + " " + kind;
    context.report.set_finding("cycles",
                               "of " + std::to_string(results.n_rows()) +
                                 " runs " + text);
    if (starts.size() > 1)
      context.report.set_finding("starts",
                                 what_starts_say(runs, starts, results));
    if (parameters.direction == SweepDirection::both &&
        !parameters.axis_entry().empty())
      context.report.set_finding("sweep", what_directions_say(runs, results));
    if (n_changing > 0)
      context.log.warning(
        std::to_string(n_changing) +
        " of the runs still change at their end (column cycle of results.csv): "
        "take a later Time/End time.");
  }
} // namespace RollingContact
