#ifndef rolling_contact_run_pvd_h
#define rolling_contact_run_pvd_h

#include <rolling_contact/run/run_folder.h>

#include <string>
#include <vector>

namespace RollingContact
{
  /** A file of the run folder, shown as block `part` at a time (s, or km or
   * passages of an evolution). */
  struct PvdBlock
  {
    double       time;
    unsigned int part;
    std::string  name;
    std::string  file;
  };

  /**
   * Writes a ParaView collection. Blocks shown together differ in `part` and
   * have the same time. Throws InputError if the file cannot be written.
   */
  void write_pvd(const std::vector<PvdBlock> &blocks,
                 RunFolder                   &folder,
                 const std::string           &file_name);
} // namespace RollingContact

#endif
