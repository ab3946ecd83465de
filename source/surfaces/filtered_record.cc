#include <rolling_contact/base/constants.h>
#include <rolling_contact/surfaces/filtered_record.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    const double closes = 0.01; // of the circumference

    /** Height of a cubic B-spline's sum over that of its coefficients, of a
     * wave with so many waves per spacing. */
    double height_of_splines(const double waves)
    {
      return (2 + std::cos(2 * pi * waves)) / 3;
    }

    /** The points of a record without the last one, which is the first again.
     */
    std::vector<double> without_last(const SurfaceRecord &record)
    {
      std::vector<double> heights;
      const std::size_t   n = record.n_along();
      for (std::size_t k = 0; k < record.heights.size(); ++k)
        if ((k + 1) % n > 0)
          heights.push_back(record.heights[k]);
      return heights;
    }
  } // namespace

  struct FilteredRecord::Axis::Splines
  {
    std::array<std::size_t, 4> points{};
    std::array<double, 4>      weights{{1., 0., 0., 0.}};
  };

  FilteredRecord::Axis::Splines
  FilteredRecord::Axis::at(const double place) const
  {
    Splines found;
    if (n == 1)
      return found;
    double from = place - begin;
    if (period > 0.)
      from -= period * std::floor(from / period);
    else
      {
        const double length = spacing * (n - 1.);
        from                = std::fmod(std::abs(from), 2 * length);
        from                = std::min(from, 2 * length - from);
      }
    const std::size_t last = n - 1,
                      k    = std::min(static_cast<std::size_t>(from / spacing),
                                   period > 0. ? last : last - 1);
    const double t = from / spacing - k, s = 1 - t;
    found.weights = {{s * s * s / 6,
                      2. / 3 - t * t * (2 - t) / 2,
                      2. / 3 - s * s * (2 - s) / 2,
                      t * t * t / 6}};
    for (std::size_t j = 0; j < 4; ++j)
      if (period > 0.)
        found.points[j] = (k + j + last) % n;
      else
        {
          const std::size_t point = k + j == 0 ? 1 : k + j - 1;
          found.points[j]         = point > last ? 2 * last - point : point;
        }
    return found;
  }

  FilteredRecord::FilteredRecord(const SurfaceRecord   &record,
                                 const Signals::CutOff &cut_off,
                                 const double           circumference,
                                 const double           stretch)
    : along{record.begin, record.spacing, 0., record.n_along()}
    , across{record.first_line, record.line_spacing, 0., record.n_lines}
  {
    coefficients         = record.heights;
    const double to_last = record.end() - record.begin,
                 beyond  = to_last + record.spacing;
    // the last value may be the first one again
    const bool has_first_again =
      std::abs(to_last - circumference) < std::abs(beyond - circumference);
    if (circumference > 0. && std::abs((has_first_again ? to_last : beyond) -
                                       circumference) <= closes * circumference)
      {
        if (has_first_again)
          coefficients = without_last(record);
        along.n = coefficients.size() / record.n_lines;
        for (std::size_t k = 0; k < coefficients.size(); ++k)
          coefficients[k] += record.slope_along * record.spacing *
                             (k % along.n - (record.n_along() - 1.) / 2);
        along.period  = circumference;
        along.spacing = circumference / along.n;
      }
    rms = Signals::root_mean_square(coefficients);
    const Signals::GridDirection x{along.n, along.spacing, is_periodic()},
      y{across.n, record.is_map() ? across.spacing : 1., false};
    const std::vector<double> smooth =
      Signals::low_pass(coefficients, x, y, cut_off, stretch);
    for (std::size_t k = 0; k < smooth.size(); ++k)
      coefficients[k] -= smooth[k];
    removed_rms = Signals::root_mean_square(coefficients);
    measure_slopes(smooth);
    coefficients = smooth;
    Signals::scale_waves(
      coefficients, x, y, [&](const double k, const double l) {
        return 1 / (height_of_splines(k * x.spacing) *
                    (y.n == 1 ? 1. : height_of_splines(l * y.spacing)));
      });
  }

  void FilteredRecord::measure_slopes(const std::vector<double> &smooth)
  {
    double     squares = 0.;
    const auto add =
      [&](const std::size_t from, const std::size_t to, const double spacing) {
        const double slope = (smooth[to] - smooth[from]) / spacing;
        squares += slope * slope / smooth.size();
        if (std::abs(slope) <= std::abs(steepest))
          return;
        steepest    = slope;
        steepest_at = along.begin + along.spacing * (from % along.n);
        steepest_y  = across.begin + across.spacing * (from / along.n);
      };
    for (std::size_t k = 0; k < smooth.size(); ++k)
      {
        if ((k + 1) % along.n > 0)
          add(k, k + 1, along.spacing);
        if (k + along.n < smooth.size())
          add(k, k + along.n, across.spacing);
      }
    rms_slope = std::sqrt(squares);
  }

  void FilteredRecord::keep_across(const double least_y, const double most_y)
  {
    const auto line = [&](const double y) {
      return std::clamp<double>((y - across.begin) / across.spacing,
                                0.,
                                across.n - 1.);
    };
    if (across.n == 1)
      return;
    // a spline reaches two lines further
    const std::size_t first = std::max(0., std::floor(line(least_y)) - 2),
                      end =
                        std::min<double>(across.n, std::ceil(line(most_y)) + 3);
    first_kept   = first;
    coefficients = std::vector<double>(coefficients.begin() + first * along.n,
                                       coefficients.begin() + end * along.n);
  }

  double FilteredRecord::value(const double position, const double y) const
  {
    const Axis::Splines x = along.at(position), lines = across.at(y);
    const std::size_t   last = coefficients.size() / along.n - 1;
    double              sum  = 0.;
    for (std::size_t l = 0; l < (across.n == 1 ? 1 : 4); ++l)
      {
        const std::size_t line =
          std::min(std::max(lines.points[l], first_kept) - first_kept, last);
        double along_line = 0.;
        for (std::size_t k = 0; k < 4; ++k)
          along_line +=
            x.weights[k] * coefficients[line * along.n + x.points[k]];
        sum += lines.weights[l] * along_line;
      }
    return sum;
  }
} // namespace RollingContact
