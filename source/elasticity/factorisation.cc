#include <cholmod.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/stopwatch.h>
#include <rolling_contact/elasticity/dissection.h>
#include <rolling_contact/elasticity/factorisation.h>

#include <algorithm>
#include <numeric>
#include <string>

namespace RollingContact
{
  namespace
  {
    using Index = std::int64_t;
    static_assert(sizeof(Index) == sizeof(SuiteSparse_long),
                  "CHOLMOD's long interface works on 64-bit indices.");

  } // namespace



  struct Factorisation::Implementation
  {
    cholmod_common        common;
    cholmod_factor       *L = nullptr;
    SymmetricSparseMatrix matrix;
    mutable Size          size;

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

    cholmod_sparse
    view()
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
    if (own.L == nullptr)
      throw std::runtime_error("CHOLMOD could not analyse the matrix (status " +
                               std::to_string(own.common.status) + ").");
    own.size.n_unknowns   = own.matrix.size();
    own.size.n_entries    = own.L->is_super ? own.L->xsize : own.common.lnz;
    own.size.n_operations = own.common.fl;
    own.size.analysis_s   = watch.seconds();
  }



  void
  Factorisation::factorise()
  {
    const Stopwatch watch;
    auto           &own = *implementation;
    if (own.matrix.size() == 0)
      return;
    cholmod_sparse A = own.view();
    cholmod_l_factorize(&A, own.L, &own.common);
    if (own.common.status == CHOLMOD_OUT_OF_MEMORY)
      throw InputError("The factor needs " +
                       std::to_string(size().memory_consumption() >> 20) +
                       " MB, more than this machine has free: take fewer "
                       "elements.");
    if (own.common.status != CHOLMOD_OK || own.L->minor < own.L->n)
      throw ConvergenceError(
        "The stiffness matrix is not positive definite (column " +
        std::to_string(own.L->minor) +
        "): the body is not held, or the material is unstable.");
    own.matrix        = SymmetricSparseMatrix();
    own.size.factor_s = watch.seconds();
  }



  std::vector<double>
  Factorisation::solve(const std::vector<double> &right_hand_side) const
  {
    auto               &own = *implementation;
    cholmod_dense       b{};
    std::vector<double> values = right_hand_side;
    b.nrow = b.d = b.nzmax = values.size();
    b.ncol                 = 1;
    b.x                    = values.data();
    b.xtype                = CHOLMOD_REAL;
    b.dtype                = CHOLMOD_DOUBLE;
    cholmod_dense *solution =
      cholmod_l_solve(CHOLMOD_A, own.L, &b, &own.common);
    if (solution == nullptr)
      throw std::runtime_error("CHOLMOD could not solve.");
    const double *begin = static_cast<const double *>(solution->x);
    values.assign(begin, begin + right_hand_side.size());
    cholmod_l_free_dense(&solution, &own.common);
    return values;
  }



  DenseMatrix
  Factorisation::condense(const std::vector<std::size_t> &unknowns,
                          CondensedColumns               *columns) const
  {
    const Stopwatch watch;
    DenseMatrix W = condensed_compliance(*implementation->L, unknowns, columns);
    implementation->size.condensation_s = watch.seconds();
    return W;
  }



  const Factorisation::Size &
  Factorisation::size() const
  {
    return implementation->size;
  }
} // namespace RollingContact
