#include <dmumps_c.h>
#include <mpi.h>
#include <zmumps_c.h>

#include <rolling_contact/algebra/dissection.h>
#include <rolling_contact/algebra/indefinite_factor.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/memory.h>
#include <rolling_contact/base/mpi_start.h>
#include <rolling_contact/base/text.h>

#include <cstdlib>
#include <mutex>
#include <string>

namespace RollingContact
{
  namespace
  {
    enum Job
    {
      start     = -1,
      end       = -2,
      solve     = 3,
      factorise = 4 // with the analysis
    };

    // MUMPS counts from 1
    const unsigned int output_streams = 3, verbosity = 4, ordering = 7,
                       parallel_root = 13, extra_memory = 14, no_factor = 31;
    const int          given_order = 1, first_extra = 40, largest_extra = 1000;
    const int          too_little_work_space[] = {-8, -9, -14, -17, -20};
    const int          no_memory[]             = {-5, -7, -13};
    const unsigned int status = 1, n_negative_pivots = 12;

    /// of address space, with what its libraries take
    const std::size_t room_for_mpi = std::size_t(256) << 20;

    /**
     * MUMPS wants MPI even on one process; a program that was not started by
     * mpirun has none yet. Open MPI ends the process where it finds no room.
     */
    void start_mpi()
    {
      if (address_space_left() < room_for_mpi)
        throw MemoryError(
          "MPI, which MUMPS needs, takes " +
          human_bytes(static_cast<double>(room_for_mpi)) +
          " of address space, of which " +
          human_bytes(static_cast<double>(address_space_left())) +
          " are left: raise the limit (ulimit -v).");
      // without a helper of its own, which would need room for files as well
      const char alone[] = "OMPI_MCA_ess_singleton_isolated";
      const bool is_set  = std::getenv(alone) != nullptr;
      if (!is_set)
        setenv(alone, "1", 1);
      int provided = 0;
      MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided);
      if (!is_set)
        unsetenv(alone);
      std::atexit([]() {
        int has_ended = 0;
        MPI_Finalized(&has_ended);
        if (!has_ended)
          MPI_Finalize();
      });
    }

    /// MUMPS keeps variables of its own between and within calls
    std::mutex library_in_use;

    void call_library(DMUMPS_STRUC_C &solver)
    {
      dmumps_c(&solver);
    }

    void call_library(ZMUMPS_STRUC_C &solver)
    {
      zmumps_c(&solver);
    }

    /**
     * An instance of MUMPS on this process for a symmetric matrix that is not
     * definite. It is ended even if what follows its start throws. Threads call
     * MUMPS one after the other.
     */
    template <typename Solver>
    struct MumpsInstance
    {
      MumpsInstance()
      {
        start_mpi_once(start_mpi);
        solver.par          = 1;
        solver.sym          = 2;
        solver.comm_fortran = MPI_Comm_c2f(MPI_COMM_SELF);
        run(Job::start);
      }

      ~MumpsInstance()
      {
        run(Job::end);
      }

      MumpsInstance(const MumpsInstance &)            = delete;
      MumpsInstance &operator=(const MumpsInstance &) = delete;

      void run(const Job job)
      {
        const std::lock_guard<std::mutex> alone(library_in_use);
        solver.job = job;
        call_library(solver);
      }

      Solver solver = {};
    };

    /**
     * A matrix and its factor in an instance of MUMPS.
     */
    template <typename Solver>
    class Mumps : public MumpsInstance<Solver>
    {
    public:
      using MumpsInstance<Solver>::run;
      using MumpsInstance<Solver>::solver;

      Mumps()
      {
        for (unsigned int k = 1; k <= output_streams; ++k)
          option(k) = -1;
        option(verbosity) = 0;
        check();
        option(parallel_root) = 1; // one root, or its pivots are not counted
      }

      MUMPS_INT &option(const unsigned int k)
      {
        return solver.icntl[k - 1];
      }

      MUMPS_INT
      information(const unsigned int k) const
      {
        return solver.infog[k - 1];
      }

      /** The pattern, in the order of nested dissection. */
      void set_pattern(const SymmetricSparseMatrix     &matrix,
                       const std::vector<unsigned int> &node_of_unknown)
      {
        solver.n   = matrix.size();
        solver.nnz = matrix.values.size();
        for (std::size_t j = 0; j < matrix.size(); ++j)
          for (auto k = matrix.column_starts[j];
               k < matrix.column_starts[j + 1];
               ++k)
            {
              rows.push_back(matrix.row_indices[k] + 1);
              columns.push_back(j + 1);
            }
        const auto order = dissection_order(matrix, node_of_unknown);
        position.resize(order.size());
        for (std::size_t k = 0; k < order.size(); ++k)
          position[order[k]] = k + 1;
        solver.irn       = rows.data();
        solver.jcn       = columns.data();
        solver.perm_in   = position.data();
        option(ordering) = given_order;
      }

      void factorise()
      {
        for (int extra = first_extra; extra <= largest_extra; extra *= 3)
          {
            option(extra_memory) = extra;
            run(Job::factorise);
            bool too_little = false;
            for (const int code : too_little_work_space)
              too_little = too_little || information(status) == code;
            if (!too_little)
              break;
          }
        check();
      }

      void check() const
      {
        for (const int code : no_memory)
          if (information(status) == code)
            throw MemoryError(
              "The factor of a matrix with " + std::to_string(solver.n) +
              " unknowns that is not definite does not fit into "
              "the memory: take a coarser mesh.");
        if (information(status) < 0)
          throw ConvergenceError(
            "MUMPS could not factorise a matrix with " +
            std::to_string(solver.n) +
            " unknowns (INFOG(1) = " + std::to_string(information(status)) +
            ", INFOG(2) = " + std::to_string(information(status + 1)) + ").");
      }

    private:
      std::vector<MUMPS_INT> rows, columns, position;
    };
  } // namespace

  std::size_t
  n_negative_eigenvalues(const SymmetricSparseMatrix     &matrix,
                         const std::vector<unsigned int> &node_of_unknown)
  {
    if (matrix.size() == 0)
      return 0;
    Mumps<DMUMPS_STRUC_C> mumps;
    mumps.set_pattern(matrix, node_of_unknown);
    std::vector<double> values = matrix.values;
    mumps.solver.a             = values.data();
    mumps.option(no_factor)    = 1;
    mumps.factorise();
    return mumps.information(n_negative_pivots);
  }

  struct ComplexFactor::Implementation
  {
    Mumps<ZMUMPS_STRUC_C>             mumps;
    std::vector<mumps_double_complex> values, right_hand_side;
  };

  ComplexFactor::~ComplexFactor() = default;

  ComplexFactor::ComplexFactor(const SymmetricSparseMatrix     &real,
                               const SymmetricSparseMatrix     &imaginary,
                               const std::vector<unsigned int> &node_of_unknown)
    : implementation(std::make_unique<Implementation>())
  {
    // both on the pattern of their sum
    const SymmetricSparseMatrix A = linear_combination(1., real, 0., imaginary),
                                B = linear_combination(0., real, 1., imaginary);
    auto &own                     = *implementation;
    own.mumps.set_pattern(A, node_of_unknown);
    own.values.resize(A.values.size());
    for (std::size_t k = 0; k < A.values.size(); ++k)
      own.values[k] = {A.values[k], B.values[k]};
    own.mumps.solver.a = own.values.data();
    own.mumps.factorise();
  }

  ComplexFactor::Values ComplexFactor::solve(const Values &right_hand_side)
  {
    auto &own = *implementation;
    own.right_hand_side.clear();
    for (const std::complex<double> &value : right_hand_side)
      own.right_hand_side.push_back({value.real(), value.imag()});
    own.mumps.solver.rhs  = own.right_hand_side.data();
    own.mumps.solver.nrhs = 1;
    own.mumps.solver.lrhs = right_hand_side.size();
    own.mumps.run(Job::solve);
    own.mumps.check();
    Values result;
    for (const auto &value : own.right_hand_side)
      result.emplace_back(value.r, value.i);
    return result;
  }
} // namespace RollingContact
