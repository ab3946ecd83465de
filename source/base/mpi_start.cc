#include <mpi.h>

#include <rolling_contact/base/mpi_start.h>

#include <mutex>

namespace RollingContact
{
  void start_mpi_once(const std::function<void()> &start)
  {
    static std::mutex                 starting;
    const std::lock_guard<std::mutex> alone(starting);
    int                               is_started = 0;
    MPI_Initialized(&is_started);
    if (!is_started)
      start();
  }
} // namespace RollingContact
