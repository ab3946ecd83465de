#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/evolution/evolution_report.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    const std::size_t most_curves = 6; ///< of profiles, and of rows of a duty

    /** The first and the last of n numbers, and some between. */
    std::vector<std::size_t> some_of(const std::size_t n)
    {
      const std::size_t        m = std::min(n, most_curves);
      std::vector<std::size_t> found;
      for (std::size_t k = 0; k < m; ++k)
        found.push_back(m == 1 ? 0 : std::lround(k * (n - 1.) / (m - 1.)));
      return found;
    }
  } // namespace

  void EvolutionReport::add_profiles(Figure            &sections,
                                     Figure            &depths,
                                     const std::size_t  side,
                                     const unsigned int body) const
  {
    const auto &from = before.curve(side, body);
    for (const std::size_t k : some_of(shown.size()))
      {
        const auto         &points = shown[k].second.curve(side, body).points();
        std::vector<double> y, z, at, depth;
        for (std::size_t i = 0; i < points.size(); ++i)
          {
            y.push_back(points[i].y / mm);
            z.push_back(-points[i].z / mm);
            const Profiles::CurvePoint &first = from.points()[i];
            at.push_back(first.y / mm);
            depth.push_back(
              std::hypot(points[i].y - first.y, points[i].z - first.z) / mm);
          }
        const double      gone = way(shown[k].first);
        const std::string label =
          (gone < 100. ? significant(gone, 3)
                       : std::to_string(std::lround(gone))) +
          (section.wears_wheel() ? " km" : " passages");
        sections.add_curve(label, y, z);
        depths.add_curve("", at, depth);
      }
  }

  void EvolutionReport::plot_profiles() const
  {
    for (std::size_t side = 0; side < before.n_sides(); ++side)
      for (unsigned int body = 0; body < 2; ++body)
        if (wears(body))
          {
            const std::string of    = body == 0 ? "wheel" : "rail";
            const std::string label = "y, to the field side (mm)";
            Figure            sections("Worn " + of, label, "height (mm)"),
              depths("", label, "depth (mm)");
            add_profiles(sections, depths, side, body);
            sections.add_panel(depths);
            sections.draw(context, "worn_" + of + ending(side));
          }
  }

  void EvolutionReport::add_columns(Figure                         &figure,
                                    const std::vector<std::string> &columns,
                                    const std::vector<std::string> &labels,
                                    const double                    scale,
                                    const bool changes) const
  {
    const ResultsTable &table = context.results;
    const std::size_t   n     = before.n_sides();
    for (std::size_t c = 0; c < columns.size(); ++c)
      for (std::size_t side = 0; side < n; ++side)
        {
          std::vector<double> x, y;
          for (std::size_t k = 0; k < shown.size(); ++k)
            {
              const auto value = table.number(n * k + side, columns[c]);
              const auto first = table.number(side, columns[c]);
              x.push_back(way(shown[k].first));
              y.push_back(value && first
                            ? scale * (*value - (changes ? *first : 0.))
                            : std::nan(""));
            }
          if (std::any_of(y.begin(), y.end(), [](const double value) {
                return std::isfinite(value);
              }))
            figure.add_curve(labels[c] + (n == 1      ? ""
                                          : side == 0 ? ", right"
                                                      : ", left"),
                             x,
                             y,
                             CurveStyle::line_and_points);
        }
  }

  void EvolutionReport::add_work_of_rows(Figure &figure) const
  {
    const std::size_t n = rows.n_rows() / shown.size();
    for (const std::size_t j : some_of(n))
      {
        std::vector<double> x, y;
        for (std::size_t k = 0; k < shown.size(); ++k)
          {
            double work = 0.;
            for (const std::string side : {"right", "left"})
              work += rows.number(n * k + j, side + "_creep_work_J/m")
                        .value_or(std::nan(""));
            x.push_back(way(shown[k].first));
            y.push_back(work);
          }
        figure.add_curve(duty[j * duty.size() / n].name, x, y);
      }
  }

  void EvolutionReport::plot_over_way() const
  {
    const std::string label =
      section.wears_wheel() ? "distance rolled (km)" : "passages";
    Figure depth("Evolution of profiles", label, "depth (mm)"),
      measures("", label, "change (mm)"), conicity("", label, "conicity, 3 mm"),
      work("", label, "T\u03b3 of both wheels (N)");
    std::vector<std::string> depths, bodies;
    for (unsigned int body = 0; body < 2; ++body)
      if (wears(body))
        {
          bodies.push_back(body == 0 ? "wheel" : "rail");
          depths.push_back(bodies.back() + "_depth_m");
        }
    add_columns(depth, depths, bodies, 1 / mm, false);
    depth.add_panel([&]() {
      add_columns(measures,
                  {"flange_height_m", "flange_thickness_m", "qr_m"},
                  {"Sh", "Sd", "qR"},
                  1 / mm,
                  true);
      return measures;
    }());
    add_columns(conicity,
                {"conicity_harmonic", "conicity_en_15302"},
                {"harmonic", "EN 15302"},
                1.,
                false);
    depth.add_panel(conicity);
    add_work_of_rows(work);
    depth.add_panel(work);
    depth.draw(context, "evolution");
  }
} // namespace RollingContact
