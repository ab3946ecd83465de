#include <cholmod.h>

#include <rolling_contact/algebra/dissection.h>
#include <rolling_contact/algebra/factorisation.h>
#include <rolling_contact/algebra/half_solves.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/memory.h>
#include <rolling_contact/base/stopwatch.h>
#include <rolling_contact/base/text.h>

#include <algorithm>
#include <atomic>
#include <new>
#include <string>

namespace RollingContact
{
  namespace
  {
    using Index = std::int64_t;
    static_assert(sizeof(Index) == sizeof(SuiteSparse_long),
                  "CHOLMOD's long interface works on 64-bit indices.");

    std::atomic<std::uint64_t> n_factorisations{0}, n_condensed_columns{0},
      n_solves{0};

    void check_memory(const Factorisation::Size &size)
    {
      const double bytes = size.memory_consumption();
      if (available_memory() > 0 && bytes > 0.7 * available_memory())
        throw MemoryError(
          "The factor of a body with " + std::to_string(size.n_unknowns) +
          " unknowns needs " + human_bytes(bytes) + ", more than 70 % of the " +
          human_bytes(available_memory()) +
          " free: take fewer Mesh/Elements across patch or a larger "
          "Mesh/Growth; in 3D 16 and 0.4 are usual.");
    }
  } // namespace

  struct Factorisation::Implementation
  {
    cholmod_common        common;
    cholmod_factor       *L = nullptr;
    SymmetricSparseMatrix matrix;
    mutable Size          size;
    std::vector<double>   workspace; ///< of the half-solves

    Implementation()
    {
      cholmod_l_start(&common);
      common.supernodal         = CHOLMOD_SUPERNODAL;
      common.nmethods           = 1;
      common.method[0].ordering = CHOLMOD_GIVEN;
      common.postorder          = 1;
      common.print              = 0;
    }

    ~Implementation()
    {
      cholmod_l_free_factor(&L, &common);
      cholmod_l_finish(&common);
    }

    cholmod_sparse view()
    {
      cholmod_sparse A{};
      A.nrow = A.ncol = matrix.size();
      A.nzmax         = matrix.values.size();
      A.p             = matrix.column_starts.data();
      A.i             = matrix.row_indices.data();
      A.x             = matrix.values.data();
      A.stype         = -1;
      A.itype         = CHOLMOD_LONG;
      A.xtype         = CHOLMOD_REAL;
      A.dtype         = CHOLMOD_DOUBLE;
      A.sorted        = 1;
      A.packed        = 1;
      return A;
    }
  };

  Factorisation::Factorisation(Factorisation &&) noexcept = default;

  Factorisation::~Factorisation() = default;

  Factorisation::Factorisation(SymmetricSparseMatrix            matrix,
                               const std::vector<unsigned int> &node_of_unknown)
    : implementation(std::make_unique<Implementation>())
  {
    const Stopwatch watch;
    auto           &own = *implementation;
    own.matrix          = std::move(matrix);
    std::vector<Index> permutation =
      dissection_order(own.matrix, node_of_unknown);
    cholmod_sparse A = own.view();
    own.L            = cholmod_l_analyze_p(&A,
                                reinterpret_cast<SuiteSparse_long *>(
                                  permutation.data()),
                                nullptr,
                                0,
                                &own.common);
    if (own.L == nullptr && own.common.status == CHOLMOD_OUT_OF_MEMORY)
      throw std::bad_alloc();
    if (own.L == nullptr)
      throw std::runtime_error("CHOLMOD could not analyse the matrix (status " +
                               std::to_string(own.common.status) + ").");
    release_free_memory();
    own.size.n_unknowns   = own.matrix.size();
    own.size.n_entries    = own.L->is_super ? own.L->xsize : own.common.lnz;
    own.size.n_operations = own.common.fl;
    own.size.analysis_s   = watch.seconds();
  }

  void Factorisation::factorise()
  {
    const Stopwatch watch;
    auto           &own = *implementation;
    if (own.matrix.size() == 0)
      return;
    if (own.L->xtype == CHOLMOD_PATTERN)
      check_memory(own.size);
    cholmod_sparse A = own.view();
    cholmod_l_factorize(&A, own.L, &own.common);
    if (own.common.status == CHOLMOD_OUT_OF_MEMORY)
      throw MemoryError("The factor needs " +
                        std::to_string(size().memory_consumption() >> 20) +
                        " MB, more than this machine has free: take fewer "
                        "Mesh/Elements across patch or a larger Mesh/Growth.");
    if (own.common.status != CHOLMOD_OK || own.L->minor < own.L->n)
      throw ConvergenceError(
        "The stiffness matrix is not positive definite (column " +
        std::to_string(own.L->minor) +
        "): the body is not held, or the material is unstable.");
    own.matrix = SymmetricSparseMatrix();
    release_free_memory();
    own.size.factor_s = watch.seconds();
    ++n_factorisations;
  }

  void Factorisation::factorise(SymmetricSparseMatrix matrix)
  {
    implementation->matrix = std::move(matrix);
    factorise();
  }

  namespace
  {
    void require_factor(const cholmod_factor *L)
    {
      if (L == nullptr)
        throw std::logic_error("The factor was released.");
    }
  } // namespace

  std::vector<double>
  Factorisation::solve(const std::vector<double> &right_hand_side) const
  {
    std::vector<double> z, x;
    ++n_solves;
    solve_forward(right_hand_side, z);
    solve_backward(z, x);
    return x;
  }

  void Factorisation::solve(DenseMatrix &block) const
  {
    auto &own = *implementation;
    require_factor(own.L);
    n_solves += block.cols();
    if (own.L->n == 0 || block.cols() == 0)
      return;
    cholmod_dense B{};
    B.nrow = B.d = block.rows();
    B.ncol       = block.cols();
    B.nzmax      = B.nrow * B.ncol;
    B.x          = block.data();
    B.xtype      = CHOLMOD_REAL;
    B.dtype      = CHOLMOD_DOUBLE;
    // cholmod_l_solve2() crashes where it finds no memory for these
    const auto make = [&](const std::size_t n_rows) {
      return cholmod_l_allocate_dense(
        n_rows, B.ncol, n_rows, CHOLMOD_REAL, &own.common);
    };
    cholmod_dense *X = make(B.nrow), *Y = make(B.nrow),
                  *E = make(std::max<std::size_t>(own.L->maxesize, 1));
    const bool solved =
      X != nullptr && Y != nullptr && E != nullptr &&
      cholmod_l_solve2(
        CHOLMOD_A, own.L, &B, nullptr, &X, nullptr, &Y, &E, &own.common);
    if (solved)
      std::copy_n(static_cast<const double *>(X->x), B.nzmax, block.data());
    cholmod_l_free_dense(&X, &own.common);
    cholmod_l_free_dense(&Y, &own.common);
    cholmod_l_free_dense(&E, &own.common);
    if (!solved)
      throw std::bad_alloc();
  }

  void Factorisation::solve_forward(const std::vector<double> &b,
                                    std::vector<double>       &z) const
  {
    solve_forward({&b}, {&z});
  }

  void Factorisation::solve_backward(std::vector<double> &z,
                                     std::vector<double> &x) const
  {
    solve_backward({&z}, {&x});
  }

  void Factorisation::solve_forward(
    const std::vector<const std::vector<double> *> &b,
    const std::vector<std::vector<double> *>       &z) const
  {
    auto &own = *implementation;
    require_factor(own.L);
    const Index *permutation = static_cast<const Index *>(own.L->Perm);
    for (std::size_t r = 0; r < b.size(); ++r)
      {
        z[r]->resize(own.L->n);
        for (std::size_t i = 0; i < own.L->n; ++i)
          (*z[r])[i] = (*b[r])[permutation[i]];
      }
    RollingContact::solve_forward(*own.L, z, own.workspace);
  }

  void Factorisation::solve_backward(
    const std::vector<std::vector<double> *> &z,
    const std::vector<std::vector<double> *> &x) const
  {
    auto &own = *implementation;
    require_factor(own.L);
    RollingContact::solve_backward(*own.L, z, own.workspace);
    const Index *permutation = static_cast<const Index *>(own.L->Perm);
    for (std::size_t r = 0; r < z.size(); ++r)
      {
        x[r]->resize(own.L->n);
        for (std::size_t i = 0; i < own.L->n; ++i)
          (*x[r])[permutation[i]] = (*z[r])[i];
      }
  }

  DenseMatrix Factorisation::condense(const SparseRows &loads,
                                      CondensedColumns *columns) const
  {
    require_factor(implementation->L);
    const Stopwatch watch;
    DenseMatrix W = condensed_compliance(*implementation->L, loads, columns);
    release_free_memory();
    implementation->size.condensation_s = watch.seconds();
    n_condensed_columns += loads.size();
    return W;
  }

  DenseMatrix Factorisation::condense(const std::vector<std::size_t> &unknowns,
                                      CondensedColumns *columns) const
  {
    SparseRows loads(unknowns.size());
    for (std::size_t k = 0; k < unknowns.size(); ++k)
      loads.add(k, unknowns[k], 1.);
    return condense(loads, columns);
  }

  Factorisation::Work Factorisation::work_done()
  {
    return {n_factorisations, n_condensed_columns, n_solves};
  }

  void Factorisation::release()
  {
    auto &own = *implementation;
    cholmod_l_free_factor(&own.L, &own.common);
    own.workspace = std::vector<double>();
    cholmod_l_free_work(&own.common);
    release_free_memory();
  }

  const Factorisation::Size &Factorisation::size() const
  {
    return implementation->size;
  }
} // namespace RollingContact
