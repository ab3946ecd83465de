#include <rolling_contact/base/memory.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

#ifdef __GLIBC__
#  include <malloc.h>
#endif

namespace RollingContact
{
  namespace
  {
    /** The entry "key: 123 kB" of a file of /proc, in bytes. */
    std::size_t
    proc_entry(const std::string &file_name, const std::string &key)
    {
      std::ifstream file(file_name);
      for (std::string word; file >> word;)
        {
          std::size_t kilobytes = 0;
          if (word == key && file >> kilobytes)
            return 1024 * kilobytes;
          file.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
        }
      return 0;
    }



    std::size_t peak_before_reset = 0;
  } // namespace



  std::size_t
  peak_memory()
  {
    return std::max(peak_before_reset, peak_memory_since_reset());
  }



  bool
  reset_peak_memory()
  {
    const std::size_t peak = peak_memory();
    std::ofstream     file("/proc/self/clear_refs");
    file << 5 << std::flush; // VmHWM = VmRSS
    if (!file)
      return false;
    peak_before_reset = peak;
    return true;
  }



  std::size_t
  peak_memory_since_reset()
  {
    return proc_entry("/proc/self/status", "VmHWM:");
  }



  std::size_t
  resident_memory()
  {
    return proc_entry("/proc/self/status", "VmRSS:");
  }



  std::size_t
  available_memory()
  {
    return proc_entry("/proc/meminfo", "MemAvailable:");
  }



  void
  release_free_memory()
  {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
  }
} // namespace RollingContact
