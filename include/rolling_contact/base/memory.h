#ifndef rolling_contact_base_memory_h
#define rolling_contact_base_memory_h

#include <cstddef>

namespace RollingContact
{
  /** Largest memory this process ever held, in bytes (VmHWM); 0 if unknown. */
  std::size_t
  peak_memory();

  /** Count peak_memory_since_reset() from now on; false if the system does not
   * allow it. peak_memory() is not changed by it. */
  bool
  reset_peak_memory();

  /** Largest memory held since the last reset, libraries included, in bytes. */
  std::size_t
  peak_memory_since_reset();

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
