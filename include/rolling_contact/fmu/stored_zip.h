#ifndef rolling_contact_fmu_stored_zip_h
#define rolling_contact_fmu_stored_zip_h

#include <string>
#include <utility>
#include <vector>

namespace RollingContact::Fmu
{
  /**
   * A zip file of files by name and content, which are stored as they are, with
   * the date 1980-01-01: the same files make the same bytes. Throws
   * std::length_error beyond 4 GB.
   */
  std::string
  stored_zip(const std::vector<std::pair<std::string, std::string>> &files);
} // namespace RollingContact::Fmu

#endif
