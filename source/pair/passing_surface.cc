#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/pair/passing_surface.h>

#include <cmath>

namespace RollingContact
{
  void RecordSurface::require_inside(const Range       &along,
                                     const Range       &across,
                                     const std::string &what) const
  {
    const auto holds = [](const double first,
                          const double last,
                          const double spacing,
                          const Range &range) {
      const double rounding = 1e-6 * spacing;
      return range[0] >= first - rounding && range[1] <= last + rounding;
    };
    const auto refuse = [&](const double       first,
                            const double       last,
                            const Range       &range,
                            const std::string &name,
                            const std::string &cure) {
      throw InputError(record->entry + ": \"" + record->file +
                       "\": it goes from " + name + significant(first, 6) +
                       " to " + significant(last, 6) + " m, and " + what + ' ' +
                       (range[0] < range[1]
                          ? "from " + significant(range[0], 6) + " to "
                          : "to ") +
                       significant(range[1], 6) + " m of it. " + cure);
    };
    if (!filtered.is_periodic() &&
        !holds(record->begin, record->end(), record->spacing, along))
      refuse(record->begin,
             record->end(),
             along,
             "",
             passage.stands
               ? "Take a longer file, one with x = 0 nearer to its middle, or "
                 "a shorter Mesh/Candidate zone."
               : "Take another Surfaces/Position or Position unit, a shorter "
                 "run or a longer record" +
                   (passage.turn > 0.
                      ? ", or one of the whole turn of " +
                          significant(passage.turn, 6) + " m, which repeats."
                      : "."));
    if (record->is_map() && !holds(record->first_line,
                                   record->last_line(),
                                   record->line_spacing,
                                   across))
      refuse(record->first_line,
             record->last_line(),
             across,
             "y = ",
             "Take a wider map, one with y = 0 nearer to its middle, or a "
             "shorter Mesh/Candidate zone.");
  }

  void check_record(const SurfaceRecord         &record,
                    const FilteredRecord        &filtered,
                    const std::array<double, 2> &shortest,
                    const ZoneSizes             &sizes)
  {
    const std::string file = record.entry + ": \"" + record.file + "\": ";
    const std::array<double, 2> spacings{{record.spacing, record.line_spacing}};
    for (unsigned int d = 0; d < (record.is_map() ? 2 : 1); ++d)
      {
        if (spacings[d] > 2 * sizes.reach[d])
          throw InputError(
            file + "its points are " + significant(spacings[d], 4) +
            " m apart, more than the " + significant(2 * sizes.reach[d], 3) +
            " m that may touch. Check Surfaces/Position unit, or take a "
            "finer record.");
        if (shortest[d] < elements_in_wave * sizes.element[d] * (1 - 1e-9))
          throw InputError(
            "Surfaces/Shortest wavelength = " + significant(shortest[d], 4) +
            ": at least 4 elements make a wave, " +
            significant(elements_in_wave * sizes.element[d], 4) +
            " m on this mesh. Take a longer one, 0, or more Mesh/Elements "
            "across patch.");
      }
    if (std::abs(filtered.steepest) > steepest_surface)
      throw InputError(
        file + "the waves that the elements follow have a slope of " +
        significant(filtered.steepest, 3) + " at " +
        significant(filtered.steepest_at, 6) +
        (record.is_map() ? ", y = " + significant(filtered.steepest_y, 6)
                         : "") +
        " m, too steep for a surface that a wheel rolls on (at most 0.1). "
        "Check Surfaces/Height unit and Position unit, or the scales of an "
        ".sdf.");
  }
} // namespace RollingContact
