#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/memory.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/linear_algebra/blas.h>
#include <rolling_contact/linear_algebra/krylov_basis.h>

#include <algorithm>
#include <string>

namespace RollingContact
{
  namespace
  {
    /// columns that are read at once
    const std::size_t panel_columns = 64;
  } // namespace



  void
  KrylovBasis::add(const DenseMatrix &block)
  {
    for (std::size_t j = 0; j < block.n_columns(); ++j, ++n_columns)
      {
        if (n_columns % panel_columns == 0)
          add_panel();
        std::copy_n(block.data() + j * n_rows,
                    n_rows,
                    panels.back().data() +
                      (n_columns % panel_columns) * n_rows);
      }
  }



  DenseMatrix
  KrylovBasis::project(const DenseMatrix &X, const std::size_t first) const
  {
    DenseMatrix  result(n_columns - first, X.n_columns());
    const int    n = X.n_columns(), rows = n_rows, ldc = result.n_rows();
    const double one = 1., zero = 0.;
    each_panel(first, [&](const double *V, std::size_t at, std::size_t k) {
      const int m = k;
      if (n > 0)
        dgemm_("T",
               "N",
               &m,
               &n,
               &rows,
               &one,
               V,
               &rows,
               X.data(),
               &rows,
               &zero,
               result.data() + at,
               &ldc);
    });
    return result;
  }



  void
  KrylovBasis::add_combination(const double       alpha,
                               const DenseMatrix &H,
                               const std::size_t  first,
                               DenseMatrix       &X) const
  {
    const int    n = X.n_columns(), rows = n_rows, ldh = H.n_rows();
    const double one = 1.;
    each_panel(first, [&](const double *V, std::size_t at, std::size_t k) {
      const int inner = k;
      if (n > 0)
        dgemm_("N",
               "N",
               &rows,
               &n,
               &inner,
               &alpha,
               V,
               &rows,
               H.data() + at,
               &ldh,
               &one,
               X.data(),
               &rows);
    });
  }



  void
  KrylovBasis::add_panel()
  {
    const double bytes = sizeof(double) * n_rows * panel_columns;
    if (available_memory() > 0 && bytes > 0.7 * available_memory())
      throw MemoryError("The modes of a body with " + std::to_string(n_rows) +
                        " unknowns need more than the " +
                        human_bytes(available_memory()) +
                        " free: lower Modes/Maximum frequency or take a "
                        "coarser mesh.");
    panels.emplace_back(n_rows, panel_columns);
  }



  void
  KrylovBasis::each_panel(
    const std::size_t first,
    const std::function<
      void(const double *V, const std::size_t at, const std::size_t k)> &action)
    const
  {
    for (std::size_t p = first / panel_columns; p < panels.size(); ++p)
      {
        const std::size_t begin = std::max(first, p * panel_columns),
                          end   = std::min(n_columns, (p + 1) * panel_columns);
        if (end > begin)
          action(panels[p].data() + (begin - p * panel_columns) * n_rows,
                 begin - first,
                 end - begin);
      }
  }
} // namespace RollingContact
