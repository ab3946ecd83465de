#include <boost/config.hpp>
#include <boost/version.hpp>

#include <dlfcn.h>
#include <fmt/ranges.h>
#include <gnu/libc-version.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/memory.h>
#include <rolling_contact/base/platform.h>
#include <rolling_contact/base/text.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <mutex>

namespace RollingContact
{
  namespace
  {
    /** A function of whatever libraries are loaded, or null. */
    template <typename Function>
    Function *loaded_function(const char *name)
    {
      return reinterpret_cast<Function *>(dlsym(RTLD_DEFAULT, name));
    }

    /** The library that holds a symbol, links resolved; empty if none does. */
    std::string file_of_symbol(const char *name)
    {
      const void *address = dlsym(RTLD_DEFAULT, name);
      Dl_info     info    = {};
      if (address == nullptr || dladdr(address, &info) == 0)
        return {};
      std::error_code             error;
      const std::filesystem::path file =
        std::filesystem::canonical(info.dli_fname, error);
      return error ? info.dli_fname : file.string();
    }

    bool contains(const std::string &text, const std::string &part)
    {
      return text.find(part) != std::string::npos;
    }
  } // namespace

  BlasLibrary loaded_blas()
  {
    const std::string file      = file_of_symbol("dgemm_");
    const std::string file_name = std::filesystem::path(file).filename();
    if (file.empty())
      return {"none", "", false};

    const auto openblas_config =
      loaded_function<char *()>("openblas_get_config");
    if (contains(file, "openblas") && openblas_config != nullptr)
      return {openblas_config(), file, false};

    const bool is_fast = contains(file, "openblas") || contains(file, "mkl") ||
                         contains(file, "blis") || contains(file, "atlas");
    if (!is_fast && file_name.rfind("libblas.", 0) == 0)
      return {"reference BLAS", file, true};
    return {file_name, file, false};
  }

  void use_one_solver_thread()
  {
    static std::once_flag once; // OpenBLAS starts threads when told again
    std::call_once(once, []() {
      for (const char *name :
           {"openblas_set_num_threads", "MKL_Set_Num_Threads"})
        if (const auto set_threads = loaded_function<void(int)>(name))
          set_threads(1);
      if (const auto end_threads =
            loaded_function<int()>("blas_thread_shutdown_");
          end_threads != nullptr && address_space_left() > room_for_threads)
        end_threads();
    });
    if (const auto set_levels =
          loaded_function<void(int)>("omp_set_max_active_levels"))
      set_levels(0);
  }

  void reserve_blas_memory(const unsigned int n_threads)
  {
    // of one thread: at most 128 MB in OpenBLAS 0.3 on x86-64
    constexpr std::size_t buffer_size = std::size_t(128) << 20;

    const auto take = loaded_function<void *(int)>("blas_memory_alloc");
    const auto give = loaded_function<void(void *)>("blas_memory_free");
    if (take == nullptr || give == nullptr)
      return;
    const std::size_t needed = n_threads * buffer_size + buffer_size / 4;
    if (address_space_left() < needed)
      throw MemoryError("OpenBLAS needs " +
                        human_bytes(static_cast<double>(needed)) +
                        " of address space, of which " +
                        human_bytes(static_cast<double>(address_space_left())) +
                        " are left: raise the limit (ulimit -v).");
    std::vector<void *> buffers;
    for (unsigned int k = 0; k < n_threads; ++k)
      buffers.push_back(take(0));
    for (void *buffer : buffers)
      give(buffer);
  }

  std::vector<std::pair<std::string, std::string>> library_versions()
  {
    std::string boost_version = BOOST_LIB_VERSION;
    std::replace(boost_version.begin(), boost_version.end(), '_', '.');

    std::vector<std::pair<std::string, std::string>> versions{
      {"compiler", BOOST_COMPILER},
      {"C library", gnu_get_libc_version()},
      {"Boost", boost_version}};

    if (const auto suitesparse_version =
          loaded_function<int(int[3])>("SuiteSparse_version"))
      {
        int numbers[3] = {};
        suitesparse_version(numbers);
        versions.emplace_back("SuiteSparse",
                              fmt::format("{}", fmt::join(numbers, ".")));
      }
    versions.emplace_back("BLAS", loaded_blas().name);
    return versions;
  }

  unsigned int n_host_cpus()
  {
    return static_cast<unsigned int>(
      std::max(1L, sysconf(_SC_NPROCESSORS_ONLN)));
  }

  std::size_t screen_width()
  {
    const unsigned long most = 80, least = 20;
    unsigned long       width    = 0;
    const char *const   variable = std::getenv("COLUMNS");
    if (variable != nullptr)
      width = std::strtoul(variable, nullptr, 10);
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
      {
        winsize size = {};
        if (width == 0 && ioctl(stream, TIOCGWINSZ, &size) == 0)
          width = size.ws_col;
      }
    return width == 0 ? most : std::clamp(width, least, most);
  }
} // namespace RollingContact
