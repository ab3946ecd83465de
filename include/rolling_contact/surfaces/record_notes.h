#ifndef rolling_contact_surfaces_record_notes_h
#define rolling_contact_surfaces_record_notes_h

#include <rolling_contact/surfaces/filtered_record.h>

namespace RollingContact
{
  /**
   * How many heights a record has, and what the filter took of them below the
   * @p shortest wavelength that passes it, in a sentence. Units: m.
   */
  std::string note_of_filter(const SurfaceRecord  &record,
                             const FilteredRecord &filtered,
                             const double          shortest);

  /**
   * A warning of a record of a turn whose ends do not meet; empty if they do.
   */
  std::string doubt_of_ends(const SurfaceRecord &record);
} // namespace RollingContact

#endif
