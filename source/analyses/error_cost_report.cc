#include <rolling_contact/analyses/error_cost_report.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/run/figure.h>

#include <algorithm>

namespace RollingContact
{
  namespace
  {
    const std::vector<double> error_levels{1e-2, 3e-3, 1e-3, 3e-4, 1e-4};

    void plot(const std::vector<CostedError> &points,
              const std::string              &error,
              const std::string              &cost,
              RunContext                     &context)
    {
      Figure figure("Error against run time", "CPU seconds per " + cost, error);
      figure.set_scales(AxisScale::logarithmic, AxisScale::logarithmic);
      for (std::size_t begin = 0, end = 0; begin < points.size(); begin = end)
        {
          std::vector<double> x, y;
          for (end = begin; end < points.size() &&
                            points[end].method == points[begin].method;
               ++end)
            {
              x.push_back(points[end].cpu_seconds);
              y.push_back(points[end].error);
            }
          figure.add_curve(points[begin].method,
                           x,
                           y,
                           CurveStyle::line_and_points);
        }
      std::vector<double> x, y;
      for (const std::size_t i : pareto_front(points))
        {
          x.push_back(points[i].cpu_seconds);
          y.push_back(points[i].error);
        }
      figure.add_curve("Pareto front", x, y, CurveStyle::reference);
      figure.draw(context, "error_cpu");
    }
  } // namespace

  std::string aligned_table(const std::vector<std::vector<std::string>> &rows)
  {
    std::string text;
    for (const auto &row : rows)
      {
        for (std::size_t k = 0; k < row.size(); ++k)
          {
            std::size_t width = 0;
            for (const auto &other : rows)
              width = std::max(width, n_characters(other[k]));
            text += k == 0 ? left_aligned(row[k], width)
                           : "  " + right_aligned(row[k], width);
          }
        text += '\n';
      }
    return text;
  }

  void report_errors_and_costs(const std::vector<ErrorCostSet> &sets,
                               const std::string               &error,
                               const std::string               &cost,
                               RunContext                      &context)
  {
    plot(sets.front().points, error, cost, context);
    ResultsTable                          table(context.folder, "best.csv");
    std::vector<std::vector<std::string>> rows{
      {"", "at most", "error", "CPU s", "cheapest", "with"}};
    for (const ErrorCostSet &set : sets)
      for (const BestOfLevel &best : best_of_levels(set.points, error_levels))
        {
          const CostedError &point = set.points[best.point];
          table.set("of", set.part);
          table.set("error_level", best.level);
          table.set("error", point.error);
          table.set("cpu_s", point.cpu_seconds);
          table.set("method", point.method);
          table.set("resolution", point.resolution);
          table.end_row();
          rows.push_back({set.part,
                          significant(best.level, 1),
                          scientific(point.error, 2),
                          significant(point.cpu_seconds, 3),
                          point.method,
                          point.resolution});
        }
    table.flush();
    context.log.message(rows.size() > 1
                          ? aligned_table(rows)
                          : "No method reaches an error of " +
                              significant(error_levels.front(), 1) + ".");
  }

  void note_study_error(const std::vector<CostedError> &points,
                        const std::string              &quantity,
                        const std::string              &scale,
                        const std::string              &reference,
                        RunReport                      &report)
  {
    const auto front = pareto_front(points);
    if (front.empty())
      return;
    const CostedError &best = points[front.back()];
    report.errors.push_back(
      {quantity,
       best.error,
       scale,
       reference,
       false,
       "smallest: " + best.method + ", " + best.resolution});
  }
} // namespace RollingContact
