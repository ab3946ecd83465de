#include <rolling_contact/base/text.h>
#include <rolling_contact/surfaces/record_notes.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  std::string note_of_filter(const SurfaceRecord  &record,
                             const FilteredRecord &filtered,
                             const double          shortest)
  {
    const auto micrometres = [](const double length) {
      return significant(1e6 * length, 3) + " um";
    };
    return record.entry + ": " + std::to_string(record.heights.size()) +
           " heights " + millimetres(record.spacing) + " apart" +
           (record.resampled ? " (resampled)" : "") + ", rms " +
           micrometres(filtered.rms) + " about a mean of " +
           micrometres(record.mean) +
           ", which is taken out; waves shorter than " + millimetres(shortest) +
           " fade, below " + millimetres(shortest / 2) + " none is left: rms " +
           micrometres(filtered.removed_rms) + " is taken out" +
           (filtered.is_periodic() ? "; it comes again after a turn." : ".");
  }

  std::string doubt_of_ends(const SurfaceRecord &record)
  {
    const auto &heights = record.heights;
    double      largest = 0.;
    for (std::size_t k = 1; k < heights.size(); ++k)
      largest = std::max(largest, std::abs(heights[k] - heights[k - 1]));
    const double jump = heights.front() - heights.back();
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
