#include <rolling_contact/analyses/creep_curve_plot.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/run/figure.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace RollingContact
{
  namespace
  {
    /** One of creepage y, creepage x and spin, as it is shown. */
    struct Component
    {
      double Creepages::*value;
      std::string        axis;
      std::string        name;
      std::string        unit;
      double             factor;
    };

    const std::array<Component, 3> &components()
    {
      static const std::array<Component, 3> all{
        {{&Creepages::y, "lateral creepage (%)", "lateral creepage", "%", 100.},
         {&Creepages::x,
          "longitudinal creepage (%)",
          "longitudinal creepage",
          "%",
          100.},
         {&Creepages::spin, "spin (1/m)", "spin", "1/m", 1.}}};
      return all;
    }

    bool varies(const std::vector<Creepages> &points,
                const Component              &component)
    {
      return std::any_of(points.begin(),
                         points.end(),
                         [&](const Creepages &point) {
                           return point.*component.value !=
                                  points[0].*component.value;
                         });
    }

    /** "spin 0.5 1/m" of what varies besides the abscissa. */
    std::string label_of(const std::vector<Creepages> &points,
                         const std::size_t             k,
                         const Component              &abscissa)
    {
      std::string label;
      for (const Component &component : components())
        if (&component != &abscissa && varies(points, component))
          label +=
            (label.empty() ? "" : ", ") + component.name + ' ' +
            significant(component.factor * (points[k].*component.value), 4) +
            ' ' + component.unit;
      return label;
    }

    /** The points by what the other components are. */
    std::vector<CreepLine> lines_over(const std::vector<Creepages> &points,
                                      const Component              &abscissa)
    {
      std::vector<CreepLine> lines;
      for (std::size_t k = 0; k < points.size(); ++k)
        {
          const auto line =
            std::find_if(lines.begin(), lines.end(), [&](const CreepLine &it) {
              Creepages first       = points[it.points[0]];
              first.*abscissa.value = points[k].*abscissa.value;
              return first.x == points[k].x && first.y == points[k].y &&
                     first.spin == points[k].spin;
            });
          if (line != lines.end())
            line->points.push_back(k);
          else
            lines.push_back({label_of(points, k, abscissa), {k}});
        }
      return lines;
    }

    /** Whether values are more than rounding of what they are measured by. */
    bool is_noticeable(const std::vector<double> &values, const double scale)
    {
      return std::any_of(values.begin(), values.end(), [&](const double value) {
        return std::abs(value) > 1e-6 * scale;
      });
    }

    std::vector<double> part_of(const std::vector<double>      &values,
                                const std::vector<std::size_t> &indices,
                                const double                    factor)
    {
      std::vector<double> part;
      for (const std::size_t k : indices)
        part.push_back(factor * values[k]);
      return part;
    }

    void add_references(const std::vector<ReferenceCurve> &references,
                        const std::vector<double>         &abscissa,
                        Figure                            &figure)
    {
      CurveStyle style = CurveStyle::reference;
      for (const ReferenceCurve &reference : references)
        if (reference.saturates)
          {
            figure.add_curve(reference.label,
                             abscissa,
                             reference.ratios,
                             style);
            style = CurveStyle::line;
          }
        else
          {
            std::vector<double> shown_x, shown;
            for (std::size_t k = 0; k < reference.ratios.size(); ++k)
              if (reference.ratios[k] <= 1.2)
                {
                  shown_x.push_back(abscissa[k]);
                  shown.push_back(reference.ratios[k]);
                }
            figure.add_curve(reference.label,
                             shown_x,
                             shown,
                             CurveStyle::dashed);
          }
    }
  } // namespace

  CreepLines::CreepLines(const std::vector<Creepages> &points)
  {
    const Component *chosen = &components()[1];
    for (const Component &component : components())
      if (varies(points, component))
        {
          auto over = lines_over(points, component);
          if (!lines.empty() && over.size() >= lines.size())
            continue;
          lines  = std::move(over);
          chosen = &component;
        }
    if (lines.empty() || 2 * lines.size() > points.size())
      {
        lines = {{"", {}}};
        for (std::size_t k = 0; k < points.size(); ++k)
          lines[0].points.push_back(k);
      }
    if (lines.size() == 1)
      lines[0].label = "finite elements";
    label = chosen->axis;
    for (const Creepages &point : points)
      abscissa.push_back(chosen->factor * (point.*chosen->value));
  }

  void plot_creep_curve(const std::vector<Creepages> &points,
                        const CreepCurveForces       &curve,
                        const std::string            &scale,
                        RunContext                   &context)
  {
    const CreepLines lines(points);
    const auto       panel_of = [&](const std::string         &y_label,
                              const std::vector<double> &values,
                              const double               factor) {
      Figure panel("Creep curve", lines.label, y_label);
      for (const CreepLine &line : lines.lines)
        panel.add_curve(line.label,
                        part_of(lines.abscissa, line.points, 1.),
                        part_of(values, line.points, factor),
                        CurveStyle::line_and_points);
      return panel;
    };
    Figure figure = panel_of("|T| / (" + scale + "N)", curve.force_ratio, 1.);
    if (lines.lines.size() == 1)
      add_references(curve.references, lines.abscissa, figure);
    double largest = 0.;
    for (std::size_t k = 0; k < points.size(); ++k)
      largest =
        std::max(largest, std::hypot(curve.force_x[k], curve.force_y[k]));
    for (const auto &[label, values, factor, length] :
         {std::tuple("F_x (kN)", &curve.force_x, 1e-3, 1.),
          std::tuple("F_y (kN)", &curve.force_y, 1e-3, 1.),
          std::tuple("M_z (Nm)", &curve.moment, 1., curve.half_width)})
      if (is_noticeable(*values, largest * length))
        figure.add_panel(panel_of(label, *values, factor));
    figure.draw(context, "creep_curve");
  }
} // namespace RollingContact
