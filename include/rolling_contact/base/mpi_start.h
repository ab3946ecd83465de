#ifndef rolling_contact_base_mpi_start_h
#define rolling_contact_base_mpi_start_h

#include <functional>

namespace RollingContact
{
  /**
   * Call @p start, which starts MPI, unless MPI was started before. Of threads
   * that come at once, one starts it and the others wait.
   */
  void start_mpi_once(const std::function<void()> &start);
} // namespace RollingContact

#endif
