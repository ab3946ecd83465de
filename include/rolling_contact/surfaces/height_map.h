#ifndef rolling_contact_surfaces_height_map_h
#define rolling_contact_surfaces_height_map_h

#include <rolling_contact/surfaces/height_map_file.h>

namespace RollingContact
{
  /**
   * Heights where nothing was measured, from those around by the equation of
   * Laplace with differences over the spacings, and no slope at the border.
   * At least one height is measured. Returns how many were filled.
   */
  std::size_t fill_missing(MeasuredMap &map);

  /**
   * A map about its plane, the weighted least squares with half the weight at
   * a border, so that whole waves have no mean. Missing points, below 1 %, are
   * filled; y = 0 is the middle of a map without places, and x = 0 its
   * beginning, or its middle if it @p stands. Throws InputError: less than 10
   * points along or 4 lines, spacings beyond 1e-9 to 1 m, more points missing,
   * heights beyond 5 mm.
   */
  SurfaceRecord
  surface_of_map(const SurfaceFile &file, MeasuredMap map, const bool stands);
} // namespace RollingContact

#endif
