#include <rolling_contact/analyses/corrugation_report.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/run/figure.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    bool are_neighbours(const CorrugationRow &a, const CorrugationRow &b)
    {
      return a.pad_offset == b.pad_offset && a.speed == b.speed;
    }

    /** The one that grows most. */
    const CorrugationRow &fastest(const std::vector<CorrugationRow> &rows)
    {
      return *std::max_element(rows.begin(), rows.end(), grows_less);
    }

    std::string place_of(const CorrugationRow &row)
    {
      return row.pad_offset
               ? ", pad offset " + significant(*row.pad_offset, 3) + " m"
               : "";
    }
  } // namespace

  std::vector<std::size_t>
  peaks_of_growth(const std::vector<CorrugationRow> &rows)
  {
    const auto is_below = [&](const std::size_t i, const std::size_t at) {
      return !are_neighbours(rows[i], rows[at]) ||
             rows[i].rate() < rows[at].rate();
    };
    std::vector<std::size_t> peaks;
    for (std::size_t i = 0; i < rows.size(); ++i)
      if ((i == 0 || is_below(i - 1, i)) &&
          (i + 1 == rows.size() || is_below(i + 1, i)))
        peaks.push_back(i);
    return peaks;
  }

  bool grows_less(const CorrugationRow &a, const CorrugationRow &b)
  {
    return a.rate() < b.rate();
  }

  void add_row(const CorrugationRow        &row,
               const CorrugationParameters &section,
               ResultsTable                &table)
  {
    table.set("pad_offset_m", row.pad_offset);
    table.set("speed_m/s", row.speed);
    table.set("wavelength_m", row.wavelength);
    table.set("frequency_Hz", row.frequency());
    table.set("growth", row.rate());
    table.set("growth_imaginary", row.passed.growth.total().imag());
    table.set("growth_uncertainty", row.uncertainty);
    table.set("growth_of_whole_bodies", row.of_whole_bodies);
    table.set("growth_by_traction", row.passed.growth.by_traction.real());
    table.set("growth_by_slip", row.passed.growth.by_slip.real());
    table.set("growth_of_passages", row.rate() * section.passages);
    table.set("growth_dB/1e6", row.rate() * 1e6 * decibels_of_e);
    table.set("load_N/m", std::abs(row.passed.load));
    table.set("load_phase_rad", std::arg(row.passed.load));
    table.set("contact_filter_dB", 20 * std::log10(row.passed.filter));
    table.set("receptance_x_m/N", std::abs(row.passed.receptance_x));
    table.set("receptance_z_m/N", std::abs(row.passed.receptance_z));
    table.end_row();
  }

  std::string verdict(const std::vector<CorrugationRow> &rows,
                      const CorrugationParameters       &section)
  {
    const CorrugationRow &most = fastest(rows);
    const std::string where = significant(1e3 * most.wavelength, 3) + " mm (" +
                              significant(most.frequency(), 3) + " Hz) at " +
                              significant(most.speed, 3) + " m/s" +
                              place_of(most);
    const auto n = std::count_if(rows.begin(), rows.end(), [](const auto &it) {
      return it.rate() > 0.;
    });
    const std::string value =
      significant(most.rate() * section.passages, 3) +
      (most.uncertainty
         ? " +- " + significant(*most.uncertainty * section.passages, 2)
         : "");
    if (n == 0)
      return "no wave grows; the least flattened has " + where + ", exp(" +
             value + ") in " + significant(section.passages, 3) + " passages";
    const auto n_surely =
      std::count_if(rows.begin(), rows.end(), [](const auto &it) {
        return it.rate() > it.uncertainty.value_or(0.);
      });
    return std::to_string(n) + " of " + std::to_string(rows.size()) +
           " waves grow, " + std::to_string(n_surely) +
           " beyond their uncertainty; most that of " + where + ", exp(" +
           value + ") in " + significant(section.passages, 3) + " passages";
  }

  namespace
  {
    /** Values of the rows of one speed and place. */
    template <class Function>
    std::vector<double> values_of(const std::vector<CorrugationRow> &rows,
                                  const Function                    &value)
    {
      std::vector<double> result;
      for (const CorrugationRow &row : rows)
        result.push_back(value(row));
      return result;
    }
  } // namespace

  void plot_growth(const std::vector<CorrugationRow> &rows,
                   const CorrugationParameters       &section,
                   RunContext                        &context)
  {
    const CorrugationRow &most = fastest(rows);
    const std::string     growth =
      "growth in " + significant(section.passages, 3) + " passages";
    Figure by_length("Waves on the " + name_of(section.worn) + place_of(most),
                     "wavelength (mm)",
                     growth),
      by_frequency("", "frequency (Hz)", growth),
      receptance("", "frequency (Hz)", "receptance (m/N)");
    for (Figure *figure : {&by_length, &by_frequency})
      figure->set_scales(AxisScale::logarithmic, AxisScale::linear);
    receptance.set_scales(AxisScale::logarithmic, AxisScale::logarithmic);
    std::vector<CorrugationRow> at_place;
    std::vector<double>         vertical, lengthwise, at;
    for (std::size_t i = 0; i < rows.size();)
      {
        std::vector<CorrugationRow> of_speed;
        for (const CorrugationRow &first = rows[i];
             i < rows.size() && are_neighbours(rows[i], first);
             ++i)
          of_speed.push_back(rows[i]);
        if (of_speed.front().pad_offset != most.pad_offset)
          continue;
        const std::string label =
          significant(of_speed.front().speed, 3) + " m/s";
        const auto rates = values_of(of_speed, [&](const auto &row) {
          return row.rate() * section.passages;
        });
        by_length.add_curve(label,
                            values_of(of_speed,
                                      [](const auto &row) {
                                        return 1e3 * row.wavelength;
                                      }),
                            rates);
        by_frequency.add_curve(
          "",
          values_of(of_speed, [](const auto &row) { return row.frequency(); }),
          rates);
        at_place.insert(at_place.end(), of_speed.begin(), of_speed.end());
      }
    std::sort(at_place.begin(),
              at_place.end(),
              [](const auto &a, const auto &b) {
                return a.frequency() < b.frequency();
              });
    for (const CorrugationRow &row : at_place)
      {
        at.push_back(row.frequency());
        vertical.push_back(std::abs(row.passed.receptance_z));
        lengthwise.push_back(std::abs(row.passed.receptance_x));
      }
    receptance.add_curve("vertical", at, vertical);
    receptance.add_curve("longitudinal", at, lengthwise);
    by_length.add_curve("no growth",
                        {1e3 * rows.front().wavelength,
                         1e3 * rows.back().wavelength},
                        {0., 0.},
                        CurveStyle::reference);
    by_frequency.add_curve("",
                           {at.front(), at.back()},
                           {0., 0.},
                           CurveStyle::reference);
    by_length.add_separate_panel(by_frequency);
    by_length.add_separate_panel(receptance);
    by_length.draw(context, "corrugation");
  }
} // namespace RollingContact
