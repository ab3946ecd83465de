#include <rolling_contact/base/text.h>
#include <rolling_contact/run/figure.h>
#include <rolling_contact/tables/table_output.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace RollingContact
{
  namespace
  {
    const std::size_t most_lines = 5;

    /**
     * A column of results.csv as a panel.
     */
    struct PlottedQuantity
    {
      std::string column, label;
      double      factor;
    };

    std::string short_name(const std::string &entry)
    {
      return entry.substr(entry.rfind('/') + 1);
    }

    /**
     * "Normal load 80 kN", "Creepage x 0.001".
     */
    std::string label_of(const std::string &entry,
                         const double       value,
                         const std::string &unit)
    {
      const bool is_thousand =
        std::abs(value) >= 1e3 && (unit == "N" || unit == "Pa");
      return short_name(entry) + ' ' +
             significant(is_thousand ? 1e-3 * value : value, 4) +
             (unit == "1" ? "" : ' ' + (is_thousand ? 'k' + unit : unit));
    }

    /**
     * Up to most_lines of n points, ends and middle among them.
     */
    std::vector<std::size_t> chosen_of(const std::size_t n)
    {
      std::vector<std::size_t> chosen;
      const std::size_t        m = std::min(n, most_lines);
      for (std::size_t k = 0; k < m; ++k)
        chosen.push_back(m == 1 ? 0 : (k * (n - 1) + (m - 1) / 2) / (m - 1));
      return chosen;
    }

    double value_of(const ResultsTable &results,
                    const std::size_t   row,
                    const std::string  &column)
    {
      return status_of_row(results, row) != TableStatus::solved
               ? std::numeric_limits<double>::quiet_NaN()
               : results.number(row, column)
                   .value_or(std::numeric_limits<double>::quiet_NaN());
    }

    /**
     * A section of the table along one axis.
     */
    class Section
    {
    public:
      Section(const TablePlan    &plan,
              const ResultsTable &results,
              const std::size_t   along)
        : plan(plan)
        , results(results)
        , along(along)
        , lines(along)
      {
        for (std::size_t d = 0; d < plan.axes.size(); ++d)
          middle.push_back(plan.axes[d].values.size() / 2);
        for (std::size_t d = plan.axes.size(); d-- > 0;)
          if (d != along && plan.axes[d].values.size() > 1)
            lines = d;
      }

      void draw(const std::vector<PlottedQuantity> &quantities,
                const std::string                  &name,
                RunContext                         &context) const
      {
        std::optional<Figure> figure;
        for (const PlottedQuantity &quantity : quantities)
          {
            const auto panel = panel_of(quantity);
            if (panel && figure)
              figure->add_panel(*panel);
            else if (panel)
              figure = *panel;
          }
        if (figure)
          figure->draw(context, name);
      }

    private:
      std::size_t row_of(std::vector<std::size_t> at) const
      {
        std::size_t row = 0;
        for (std::size_t d = 0; d < plan.axes.size(); ++d)
          row = row * plan.axes[d].values.size() + at[d];
        return row;
      }

      std::string title() const
      {
        std::string text;
        for (std::size_t d = 0; d < plan.axes.size(); ++d)
          if (d != along && d != lines)
            text += (text.empty() ? "" : ", ") +
                    label_of(plan.axes[d].entry,
                             plan.axes[d].values[middle[d]],
                             plan.units[d]);
        return text.empty() ? "Table" : "Table at " + text;
      }

      /** None if all of it is zero or unknown. */
      std::optional<Figure> panel_of(const PlottedQuantity &quantity) const
      {
        const std::string unit = plan.units[along];
        Figure            panel(title(),
                     short_name(plan.axes[along].entry) +
                       (unit == "1" ? "" : " (" + unit + ")"),
                     quantity.label);
        bool              is_seen = false;
        const auto        chosen  = lines == along
                                      ? std::vector<std::size_t>{0}
                                      : chosen_of(plan.axes[lines].values.size());
        for (const std::size_t line : chosen)
          {
            std::vector<std::size_t> at = middle;
            std::vector<double>      values;
            if (lines != along)
              at[lines] = line;
            for (at[along] = 0; at[along] < plan.axes[along].values.size();
                 ++at[along])
              {
                values.push_back(quantity.factor * value_of(results,
                                                            row_of(at),
                                                            quantity.column));
                is_seen = is_seen || std::abs(values.back()) > 1e-6;
              }
            panel.add_curve(lines == along
                              ? "finite elements"
                              : label_of(plan.axes[lines].entry,
                                         plan.axes[lines].values[line],
                                         plan.units[lines]),
                            plan.axes[along].values,
                            values,
                            CurveStyle::line_and_points);
          }
        return is_seen ? std::optional<Figure>(panel) : std::nullopt;
      }

      const TablePlan         &plan;
      const ResultsTable      &results;
      const std::size_t        along;
      std::size_t              lines; ///< the axis of the lines
      std::vector<std::size_t> middle;
    };
  } // namespace

  void plot_sections(const TablePlan &plan, RunContext &context)
  {
    const std::vector<PlottedQuantity> quantities{
      {"force_x_N", "F_x (kN)", 1e-3},
      {"force_y_N", "F_y (kN)", 1e-3},
      {"spin_moment_Nm", "M_z (Nm)", 1.}};
    for (std::size_t d = 0; d < plan.axes.size(); ++d)
      if (plan.axes[d].values.size() > 1)
        Section(plan, context.results, d)
          .draw(quantities, "table_" + std::to_string(d + 1), context);
  }
} // namespace RollingContact
