#include <sys/resource.h>

#include <rolling_contact/base/memory.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
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

    /** What a version of control groups calls its files. */
    struct GroupFiles
    {
      std::string folder, limit, used, kept;
    };

    /** What the control group in this folder can still get, files that are only
     * kept in memory not counted. */
    std::size_t left_of_group(const std::string &folder, const GroupFiles &name)
    {
      const std::size_t limit = number_in(folder + name.limit, unlimited);
      if (limit == unlimited)
        return unlimited;
      const std::size_t used = number_in(folder + name.used, 0);
      std::ifstream     stat(folder + "/memory.stat");
      std::size_t       kept = 0;
      for (std::string word; stat >> word;)
        if (word == name.kept)
          stat >> kept;
      return left_of(limit, used - std::min(used, kept));
    }

    /** The files of the hierarchy that a line of /proc/self/cgroup,
     * "number:controllers:group", tells of; none if it is not of memory. */
    std::optional<GroupFiles> files_of(const std::string &controllers)
    {
      if (controllers.empty())
        return GroupFiles{"",
                          "/memory.max",
                          "/memory.current",
                          "inactive_file"};
      if ((',' + controllers + ',').find(",memory,") == std::string::npos)
        return {};
      return GroupFiles{"/memory",
                        "/memory.limit_in_bytes",
                        "/memory.usage_in_bytes",
                        "total_inactive_file"};
    }
  } // namespace

  std::size_t memory_left_of_groups(const std::string &list_of_groups,
                                    const std::string &groups)
  {
    std::size_t   left = unlimited;
    std::ifstream file(list_of_groups);
    for (std::string line; std::getline(file, line);)
      {
        const std::size_t first  = line.find(':'),
                          second = line.find(":/", first + 1);
        if (first == std::string::npos || second == std::string::npos)
          continue;
        const auto name = files_of(line.substr(first + 1, second - first - 1));
        for (std::string group = line.substr(second + 1); name;
             group.erase(group.rfind('/')))
          {
            left =
              std::min(left,
                       left_of_group(groups + name->folder + group, *name));
            if (group.empty())
              break;
          }
      }
    return left;
  }

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
      1, std::min({free, address_space_left(), memory_left_of_groups()}));
  }

  void release_free_memory()
  {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
  }
} // namespace RollingContact
