#include <rolling_contact/base/text.h>
#include <rolling_contact/surfaces/record_notes.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    std::string micrometres(const double length)
    {
      return significant(1e6 * length, 3) + " um";
    }

    /** How many points there are, and how far apart. */
    std::string points_of(const SurfaceRecord &record)
    {
      if (!record.is_map())
        return std::to_string(record.heights.size()) + " heights " +
               millimetres(record.spacing) + " apart" +
               (record.resampled ? " (resampled)" : "");
      return std::to_string(record.n_along()) + " by " +
             std::to_string(record.n_lines) + " heights (" +
             human_bytes(8. * record.heights.size()) + ") " +
             millimetres(record.spacing) + " by " +
             millimetres(record.line_spacing) + " apart" +
             (record.n_interpolated > 0
                ? ", " + std::to_string(record.n_interpolated) +
                    " of them filled in"
                : "");
    }
  } // namespace

  std::string text_of_waves(const std::array<double, 2> &shortest)
  {
    return millimetres(shortest[0]) +
           (shortest[1] == 0. || std::abs(shortest[1] / shortest[0] - 1) < 0.01
              ? ""
              : " along and " + millimetres(shortest[1]) + " across");
  }

  std::string note_of_filter(const SurfaceRecord         &record,
                             const FilteredRecord        &filtered,
                             const std::array<double, 2> &shortest)
  {
    const std::array<double, 2> passed{
      {shortest[0], record.is_map() ? shortest[1] : 0.}};
    const std::string about =
      record.is_map()
        ? " about a plane with a mean of " + micrometres(record.mean) +
            " and slopes of " +
            (filtered.is_periodic()
               ? ""
               : significant(record.slope_along, 2) + " along and ") +
            significant(record.slope_across, 2) + " across"
        : " about a mean of " + micrometres(record.mean);
    return record.entry + ": " + points_of(record) + ", rms " +
           micrometres(filtered.rms) + about +
           ", which is taken out; waves shorter than " + text_of_waves(passed) +
           " fade, below " +
           (record.is_map() ? "half of that" : millimetres(passed[0] / 2)) +
           " none is left: rms " + micrometres(filtered.removed_rms) +
           " is taken out" +
           (filtered.is_periodic() ? "; it comes again after a turn." : ".");
  }

  std::string doubt_of_ends(const SurfaceRecord &record)
  {
    const auto       &heights = record.heights;
    const std::size_t n       = record.n_along();
    const double      slope   = record.slope_along * record.spacing;
    double            largest = 0., jump = 0.;
    for (std::size_t k = 0; k < heights.size(); ++k)
      if (k % n > 0)
        largest =
          std::max(largest, std::abs(heights[k] - heights[k - 1] + slope));
      else if (const double here =
                 heights[k] - heights[k + n - 1] - slope * (n - 1.);
               std::abs(here) > std::abs(jump))
        jump = here;
    if (std::abs(jump) <= 3 * largest)
      return "";
    return record.entry + ": \"" + record.file +
           "\": it goes once around, but from its end to its beginning the "
           "height jumps by " +
           significant(1e6 * jump, 3) + " um, elsewhere by at most " +
           significant(1e6 * largest, 3) +
           " um from point to point: the filter makes waves of that. Take the "
           "drift out of the record.";
  }
} // namespace RollingContact
