#ifndef rolling_contact_base_memory_h
#define rolling_contact_base_memory_h

#include <cstddef>

namespace RollingContact
{
  /** Largest memory this process ever held, in bytes (VmHWM); 0 if unknown. */
  std::size_t
  peak_memory();

  /** Memory this process holds now, in bytes (VmRSS); 0 if unknown. */
  std::size_t
  resident_memory();

  /** What the machine can still give without swapping, in bytes
   * (MemAvailable); 0 if unknown. Knows no limit set by a batch system. */
  std::size_t
  available_memory();

  /** Give freed pages back to the system, which the C library keeps otherwise
   * (glibc only). For moments when much was freed in small pieces. */
  void
  release_free_memory();
} // namespace RollingContact

#endif
