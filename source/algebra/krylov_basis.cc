#include <rolling_contact/algebra/krylov_basis.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/memory.h>
#include <rolling_contact/base/text.h>

#include <algorithm>
#include <string>

namespace RollingContact
{
  namespace
  {
    /// columns that are read at once
    const std::size_t panel_columns = 64;
  } // namespace

  void KrylovBasis::add(const DenseMatrix &block)
  {
    for (Eigen::Index j = 0; j < block.cols(); ++j, ++n_columns)
      {
        if (n_columns % panel_columns == 0)
          add_panel();
        panels.back().col(n_columns % panel_columns) = block.col(j);
      }
  }

  DenseMatrix KrylovBasis::project(const DenseMatrix &X,
                                   const std::size_t  first) const
  {
    DenseMatrix result(n_columns - first, X.cols());
    each_panel(first, [&](const Columns &V, const std::size_t at) {
      result.middleRows(at, V.cols()).noalias() = V.transpose() * X;
    });
    return result;
  }

  void KrylovBasis::add_combination(const double       alpha,
                                    const DenseMatrix &H,
                                    const std::size_t  first,
                                    DenseMatrix       &X) const
  {
    each_panel(first, [&](const Columns &V, const std::size_t at) {
      X.noalias() += alpha * V * H.middleRows(at, V.cols());
    });
  }

  void KrylovBasis::add_panel()
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

  void KrylovBasis::each_panel(
    const std::size_t                                                  first,
    const std::function<void(const Columns &V, const std::size_t at)> &action)
    const
  {
    for (std::size_t p = first / panel_columns; p < panels.size(); ++p)
      {
        const std::size_t begin = std::max(first, p * panel_columns),
                          end   = std::min(n_columns, (p + 1) * panel_columns);
        if (end > begin)
          action(panels[p].middleCols(begin - p * panel_columns, end - begin),
                 begin - first);
      }
  }
} // namespace RollingContact
