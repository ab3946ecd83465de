#ifndef rolling_contact_base_platform_h
#define rolling_contact_base_platform_h

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace RollingContact
{
  /** The BLAS that answers calls of this process, found at run time. */
  struct BlasLibrary
  {
    /**
     * Name of the library: "OpenBLAS 0.3.21 ...", "reference BLAS", the file's
     * name, or "none".
     */
    std::string name;
    /** The shared library that holds dgemm; empty if there is none. */
    std::string file;
    /**
     * Whether it is the reference BLAS, which factorises about 11 times slower.
     */
    bool is_reference;
  };

  BlasLibrary loaded_blas();

  /**
   * Sets one BLAS thread (process-wide, ending OpenBLAS's others, which would
   * take signals) and no OpenMP regions (in the calling thread and those OpenMP
   * starts from it): every thread that factorises calls it. With both kinds of
   * threads on busy cores CHOLMOD can be 20 times slower.
   */
  void use_one_solver_thread();

  /** With less address space left, in bytes, a thread of OpenBLAS may wait
   * without end for its 128 MB, and the end of the process for this thread. */
  inline constexpr std::size_t room_for_threads = std::size_t(160) << 20;

  /**
   * Let OpenBLAS take the memory now that @p n_threads threads at once work in:
   * later, when there is none left, it would wait for it without end. Throws
   * MemoryError if there is not enough. Does nothing with another BLAS.
   */
  void reserve_blas_memory(const unsigned int n_threads);

  /** Names and versions of the compiler, the C library, Boost and, if loaded,
   * SuiteSparse and BLAS. */
  std::vector<std::pair<std::string, std::string>> library_versions();

  unsigned int n_host_cpus();

  /**
   * Columns for text on the screen: the environment's COLUMNS, or those of the
   * terminal that standard output or error is; at least 20 and at most 80, and
   * 80 if neither is known.
   */
  std::size_t screen_width();
} // namespace RollingContact

#endif
