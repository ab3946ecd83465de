#ifndef rolling_contact_base_memory_h
#define rolling_contact_base_memory_h

#include <cstddef>
#include <string>

namespace RollingContact
{
  /** Largest memory this process ever held, in bytes (VmHWM); 0 if unknown. */
  std::size_t peak_memory();

  /** Count peak_memory_since_reset() from now on; false if the system does not
   * allow it. peak_memory() is not changed by it. */
  bool reset_peak_memory();

  /** Largest memory held since the last reset, libraries included, in bytes. */
  std::size_t peak_memory_since_reset();

  /** What this process can still get without swapping, in bytes: MemAvailable,
   * within the limits of ulimit -v and -d and those of its control group
   * (containers, batch systems); 0 if unknown. */
  std::size_t available_memory();

  /**
   * The memory that the limits of this process's control group and of its
   * parents leave, of version 1 and 2, in bytes; the largest number if there
   * are no limits.
   */
  std::size_t
  memory_left_of_groups(const std::string &list_of_groups = "/proc/self/cgroup",
                        const std::string &groups         = "/sys/fs/cgroup");

  /** What is left of the limits of ulimit -v and -d, in bytes; the largest
   * number if there are none. */
  std::size_t address_space_left();

  /** Give freed pages back to the system, which the C library keeps otherwise
   * (glibc only). For moments when much was freed in small pieces. */
  void release_free_memory();
} // namespace RollingContact

#endif
