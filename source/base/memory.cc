#include <sys/resource.h>

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
    std::size_t proc_entry(const std::string &file_name, const std::string &key)
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

  std::size_t peak_memory()
  {
    return std::max(peak_before_reset, peak_memory_since_reset());
  }

  bool reset_peak_memory()
  {
    const std::size_t peak = peak_memory();
    std::ofstream     file("/proc/self/clear_refs");
    file << 5 << std::flush; // VmHWM = VmRSS
    if (!file)
      return false;
    peak_before_reset = peak;
    return true;
  }

  std::size_t peak_memory_since_reset()
  {
    return proc_entry("/proc/self/status", "VmHWM:");
  }

  std::size_t resident_memory()
  {
    return proc_entry("/proc/self/status", "VmRSS:");
  }

  namespace
  {
    constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max();

    std::size_t left_of(const std::size_t limit, const std::size_t used)
    {
      if (limit == unlimited)
        return unlimited;
      return limit > used ? limit - used : 0;
    }

    std::size_t limit_of(const __rlimit_resource resource)
    {
      rlimit limit{};
      return getrlimit(resource, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY
               ? limit.rlim_cur
               : unlimited;
    }

    /** The number a file begins with; the other value if it begins with a word
     * or cannot be read. */
    std::size_t number_in(const std::string &file_name,
                          const std::size_t  otherwise)
    {
      std::ifstream file(file_name);
      std::size_t   number = 0;
      return file >> number ? number : otherwise;
    }

    /** What the control group in this folder can still get, files that are only
     * kept in memory not counted (cgroup v2). */
    std::size_t left_of_group(const std::string &folder)
    {
      const std::size_t limit = number_in(folder + "/memory.max", unlimited);
      if (limit == unlimited)
        return unlimited;
      const std::size_t used = number_in(folder + "/memory.current", 0);
      std::ifstream     stat(folder + "/memory.stat");
      std::size_t       kept = 0;
      for (std::string word; stat >> word;)
        if (word == "inactive_file")
          stat >> kept;
      return left_of(limit, used - std::min(used, kept));
    }

    /** As left_of_group(), of this process's group and those it is in. */
    std::size_t left_of_groups()
    {
      std::size_t   left = unlimited;
      std::ifstream file("/proc/self/cgroup");
      for (std::string line; std::getline(file, line);)
        if (line.rfind("0::/", 0) == 0)
          for (std::string group = line.substr(3);;
               group.erase(group.rfind('/')))
            {
              left = std::min(left, left_of_group("/sys/fs/cgroup" + group));
              if (group.empty())
                break;
            }
      return left;
    }
  } // namespace

  std::size_t address_space_left()
  {
    return std::min(left_of(limit_of(RLIMIT_AS),
                            proc_entry("/proc/self/status", "VmSize:")),
                    left_of(limit_of(RLIMIT_DATA),
                            proc_entry("/proc/self/status", "VmData:")));
  }

  std::size_t available_memory()
  {
    const std::size_t free = proc_entry("/proc/meminfo", "MemAvailable:");
    if (free == 0)
      return 0;
    return std::max<std::size_t>(
      1, std::min({free, address_space_left(), left_of_groups()}));
  }

  void release_free_memory()
  {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
  }
} // namespace RollingContact
