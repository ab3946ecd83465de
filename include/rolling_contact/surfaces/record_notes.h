#ifndef rolling_contact_surfaces_record_notes_h
#define rolling_contact_surfaces_record_notes_h

#include <rolling_contact/surfaces/filtered_record.h>

#include <array>

namespace RollingContact
{
  /**
   * How many heights a record has, and what the filter took of them below the
   * @p shortest wavelengths along and across that pass it, in a sentence.
   * Units: m.
   */
  std::string note_of_filter(const SurfaceRecord         &record,
                             const FilteredRecord        &filtered,
                             const std::array<double, 2> &shortest);

  /**
   * The shortest wavelengths that pass a filter, along and, unless it is 0,
   * across, as text.
   * Units: m.
   */
  std::string text_of_waves(const std::array<double, 2> &shortest);

  /**
   * A warning of a record of a turn whose ends do not meet; empty if they do.
   */
  std::string doubt_of_ends(const SurfaceRecord &record);
} // namespace RollingContact

#endif
