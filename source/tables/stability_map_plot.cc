#include <rolling_contact/base/text.h>
#include <rolling_contact/run/figure.h>
#include <rolling_contact/tables/stability_map_plot.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace RollingContact
{
  namespace
  {
    /// largest step of a branch from one value to the next, over its frequency
    const double longest_step = 0.02;

    const std::size_t most_branches = 8;

    const double nan = std::numeric_limits<double>::quiet_NaN();

    double distance(const ListedVibration &a, const ListedVibration &b)
    {
      const double two_pi = 2 * std::acos(-1.);
      return std::hypot(a.frequency - b.frequency,
                        (a.growth - b.growth) / two_pi) /
             std::max(a.frequency, b.frequency);
    }

    /** An axis as it is drawn: degrees for angles, kN, mm. */
    struct DrawnAxis
    {
      DrawnAxis(const TablePlan &plan, const std::size_t k)
        : values(plan.axes[k].values)
      {
        const std::string &entry = plan.axes[k].entry;
        std::string        unit  = plan.units[k];
        double             scale = 1.;
        double             size  = 0.;
        for (const double value : values)
          size = std::max(size, std::abs(value));
        if (unit == "rad")
          {
            scale = 180 / std::acos(-1.);
            unit  = "degrees";
          }
        else if (unit == "N" && size >= 1e3)
          {
            scale = 1e-3;
            unit  = "kN";
          }
        else if (unit == "m" && size < 1.)
          {
            scale = 1e3;
            unit  = "mm";
          }
        for (double &value : values)
          value *= scale;
        label = entry + (unit == "1" ? "" : " (" + unit + ")");
      }

      std::vector<double> values;
      std::string         label;
    };

    /** Both edges of a cell around each value, half way to its neighbours. */
    std::vector<double> edges_of(const std::vector<double> &values)
    {
      const std::size_t   n = values.size();
      std::vector<double> edges;
      for (std::size_t k = 0; k < n; ++k)
        {
          const double left  = k == 0 ? values[1] - values[0]
                                      : values[k] - values[k - 1],
                       right = k + 1 == n ? values[k] - values[k - 1]
                                          : values[k + 1] - values[k];
          edges.push_back(values[k] - left / 2);
          edges.push_back(values[k] + right / 2);
        }
      return edges;
    }

    /** A value for each corner of each cell. */
    std::vector<double> at_corners(const std::vector<double> &values,
                                   const std::size_t          n_x,
                                   const std::size_t          n_y)
    {
      std::vector<double> corners;
      for (std::size_t j = 0; j < 2 * n_y; ++j)
        for (std::size_t i = 0; i < 2 * n_x; ++i)
          corners.push_back(values[j / 2 * n_x + i / 2]);
      return corners;
    }

    /** The line on which values between those at (x[i], y[j]) are 0, in pieces
     * with a gap behind each. */
    struct ZeroLine
    {
      ZeroLine(const std::vector<double> &x,
               const std::vector<double> &y,
               const std::vector<double> &values)
      {
        for (std::size_t j = 0; j + 1 < y.size(); ++j)
          for (std::size_t i = 0; i + 1 < x.size(); ++i)
            {
              const auto corner = [&](const std::size_t k) {
                const std::size_t right = k == 1 || k == 2, up = k >= 2;
                return Corner{x[i + right],
                              y[j + up],
                              values[(j + up) * x.size() + i + right]};
              };
              std::vector<Corner> ends;
              for (std::size_t k = 0; k < 4; ++k)
                if (const Corner a = corner(k), b = corner((k + 1) % 4);
                    (a.value > 0.) != (b.value > 0.) &&
                    std::isfinite(a.value - b.value))
                  {
                    const double t = a.value / (a.value - b.value);
                    ends.push_back(
                      {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), 0.});
                  }
              for (std::size_t k = 0; k + 1 < ends.size(); k += 2)
                for (const Corner &at :
                     {ends[k], ends[k + 1], Corner{nan, nan, 0.}})
                  {
                    this->x.push_back(at.x);
                    this->y.push_back(at.y);
                  }
            }
      }

      std::vector<double> x, y;

    private:
      struct Corner
      {
        double x, y, value;
      };
    };

    void plot_map(const TablePlan &plan, RunContext &context)
    {
      const DrawnAxis     x(plan, 0), y(plan, 1);
      const std::size_t   n_x = x.values.size(), n_y = y.values.size();
      std::vector<double> growth(n_x * n_y, nan), frequency(n_x * n_y, nan),
        count(n_x * n_y, nan);
      const ResultsTable &results = context.results;
      for (std::size_t row = 0; row < results.n_rows(); ++row)
        {
          // states count the last axis fastest
          const std::size_t state = state_of_row(results, row),
                            at    = state % n_y * n_x + state / n_y;
          growth[at] = results.number(row, "largest_growth_1/s").value_or(nan);
          count[at]  = results.number(row, "n_unstable").value_or(nan);
          if (growth[at] > 0.)
            frequency[at] =
              1e-3 * results.number(row, "fastest_Hz").value_or(nan);
        }
      const auto draw = [&](const std::string         &title,
                            const std::string         &label,
                            const std::vector<double> &values,
                            const std::string         &name,
                            const MapColours           colours) {
        if (std::none_of(values.begin(), values.end(), [](const double v) {
              return std::isfinite(v);
            }))
          return;
        Figure figure(title, x.label, y.label);
        figure.add_map(label,
                       edges_of(x.values),
                       edges_of(y.values),
                       at_corners(values, n_x, n_y),
                       colours);
        if (colours == MapColours::from_zero)
          if (const ZeroLine zero(x.values, y.values, values); !zero.x.empty())
            figure.add_curve("", zero.x, zero.y, CurveStyle::reference);
        figure.draw(context, name);
      };
      draw("Growth of the vibration that grows fastest",
           std::any_of(growth.begin(),
                       growth.end(),
                       [](const double v) { return v > 0.; })
             ? "1/s; grey: none grows"
             : "1/s; none grows",
           growth,
           "stability_map",
           MapColours::from_zero);
      draw("Frequency of the vibration that grows fastest",
           "kHz; white: none grows",
           frequency,
           "stability_map_frequency",
           MapColours::from_least);
      draw("Vibrations that grow",
           "number",
           count,
           "stability_map_count",
           MapColours::from_least);
    }

    void plot_locus(const TablePlan &plan, RunContext &context)
    {
      const DrawnAxis                           axis(plan, 0);
      std::vector<std::vector<ListedVibration>> vibrations(axis.values.size());
      for (std::size_t row = 0; row < context.results.n_rows(); ++row)
        if (const auto *listed =
              context.results.value<std::vector<ListedVibration>>(row,
                                                                  "vibrations"))
          vibrations[state_of_row(context.results, row)] = *listed;
      std::vector<Branch> all = branches(axis.values, vibrations);
      // those that grow somewhere; where none does those that come nearest
      std::stable_sort(all.begin(),
                       all.end(),
                       [](const Branch &a, const Branch &b) {
                         return a.largest_growth() > b.largest_growth();
                       });
      all.resize(std::min(all.size(), most_branches));
      while (all.size() > 3 && all.back().largest_growth() <= 0.)
        all.pop_back();
      std::stable_sort(all.begin(),
                       all.end(),
                       [](const Branch &a, const Branch &b) {
                         return a.vibrations[0].frequency <
                                b.vibrations[0].frequency;
                       });
      Figure figure("Vibrations about the steady rolling state",
                    axis.label,
                    "growth (1/s)");
      Figure frequencies("", axis.label, "frequency (kHz)");
      for (const Branch &branch : all)
        {
          std::vector<double> growth, frequency;
          for (const ListedVibration &vibration : branch.vibrations)
            {
              growth.push_back(vibration.growth);
              frequency.push_back(1e-3 * vibration.frequency);
            }
          figure.add_curve(significant(branch.vibrations[0].frequency, 4) +
                             " Hz",
                           branch.at,
                           growth,
                           CurveStyle::line_and_points);
          frequencies.add_curve("",
                                branch.at,
                                frequency,
                                CurveStyle::line_and_points);
        }
      if (all.empty())
        return;
      figure.add_panel(frequencies);
      figure.draw(context, "root_locus");
    }

    void plot_growth_of_rows(const TablePlan &plan, RunContext &context)
    {
      const auto texts_of = [&](const std::string &column) {
        for (const auto &[name, texts] : plan.titles)
          if (name == column)
            return texts;
        return std::vector<std::string>(plan.values.size());
      };
      const std::vector<std::string> of_rows = texts_of("name"),
                                     wheels  = texts_of("wheel");
      std::vector<std::string> names, sides;
      const auto               place_of = [](const std::string        &text,
                               std::vector<std::string> &all) {
        const auto at = std::find(all.begin(), all.end(), text) - all.begin();
        if (at == static_cast<long>(all.size()))
          all.push_back(text);
        return static_cast<std::size_t>(at);
      };
      for (std::size_t state = 0; state < of_rows.size(); ++state)
        {
          place_of(of_rows[state], names);
          place_of(wheels[state], sides);
        }
      std::vector<std::vector<double>> growth(sides.size()), at(sides.size());
      const ResultsTable              &results = context.results;
      for (std::size_t row = 0; row < results.n_rows(); ++row)
        if (const auto here = results.number(row, "largest_growth_1/s"))
          {
            const std::size_t state = state_of_row(results, row),
                              side  = place_of(wheels[state], sides);
            growth[side].push_back(*here);
            at[side].push_back(1. + place_of(of_rows[state], names) +
                               0.36 * (side - (sides.size() - 1) / 2.));
          }
      Figure figure("Vibration that grows fastest, or decays slowest",
                    "growth (1/s)",
                    "");
      figure.set_names(names);
      for (std::size_t side = 0; side < sides.size(); ++side)
        figure.add_curve(sides[side].empty() ? "" : sides[side] + "-hand wheel",
                         growth[side],
                         at[side],
                         CurveStyle::bars);
      figure.draw(context, "growth");
    }
  } // namespace

  double Branch::largest_growth() const
  {
    double largest = -std::numeric_limits<double>::infinity();
    for (const ListedVibration &vibration : vibrations)
      largest = std::max(largest, vibration.growth);
    return largest;
  }

  std::vector<Branch>
  branches(const std::vector<double>                       &values,
           const std::vector<std::vector<ListedVibration>> &vibrations)
  {
    struct Step
    {
      double      length;
      std::size_t branch, vibration;
    };
    std::vector<Branch>      all;
    std::vector<std::size_t> alive;
    for (std::size_t k = 0; k < values.size(); ++k)
      {
        std::vector<Step> steps;
        for (const std::size_t b : alive)
          for (std::size_t v = 0; v < vibrations[k].size(); ++v)
            steps.push_back(
              {distance(all[b].vibrations.back(), vibrations[k][v]), b, v});
        std::sort(steps.begin(), steps.end(), [](const Step &a, const Step &b) {
          return a.length < b.length;
        });
        std::vector<bool> has_step(all.size(), false),
          is_taken(vibrations[k].size(), false);
        std::vector<std::size_t> now;
        for (const Step &step : steps)
          if (step.length < longest_step && !has_step[step.branch] &&
              !is_taken[step.vibration])
            {
              has_step[step.branch] = is_taken[step.vibration] = true;
              all[step.branch].at.push_back(values[k]);
              all[step.branch].vibrations.push_back(
                vibrations[k][step.vibration]);
              now.push_back(step.branch);
            }
        for (std::size_t v = 0; v < vibrations[k].size(); ++v)
          if (!is_taken[v])
            {
              now.push_back(all.size());
              all.push_back({{values[k]}, {vibrations[k][v]}});
            }
        alive = now;
      }
    return all;
  }

  void plot_stability_map(const TablePlan &plan, RunContext &context)
  {
    if (!plan.titles.empty() && plan.axes.empty())
      plot_growth_of_rows(plan, context);
    else if (plan.axes.size() == 2 && plan.axes[0].values.size() > 1 &&
             plan.axes[1].values.size() > 1)
      plot_map(plan, context);
    else if (plan.axes.size() == 1)
      plot_locus(plan, context);
  }
} // namespace RollingContact
