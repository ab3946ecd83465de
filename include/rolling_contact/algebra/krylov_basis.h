#ifndef rolling_contact_algebra_krylov_basis_h
#define rolling_contact_algebra_krylov_basis_h

#include <rolling_contact/algebra/dense_matrix.h>

#include <functional>
#include <vector>

namespace RollingContact
{
  /**
   * The columns V of a Krylov space, kept in panels, so that it grows without
   * being copied.
   */
  class KrylovBasis
  {
  public:
    explicit KrylovBasis(const std::size_t n_rows)
      : n_rows(n_rows)
    {}

    std::size_t size() const
    {
      return n_columns;
    }

    /**
     * Throws MemoryError if there is no room for more.
     */
    void add(const DenseMatrix &block);

    /** V^T X of the columns from @p first on. */
    DenseMatrix project(const DenseMatrix &X, const std::size_t first) const;

    /** X += alpha V H with the columns from @p first on. */
    void add_combination(const double       alpha,
                         const DenseMatrix &H,
                         const std::size_t  first,
                         DenseMatrix       &X) const;

  private:
    void add_panel();

    using Columns = Eigen::Ref<const DenseMatrix>;

    /** Calls @p action with the columns of each panel from @p first on, and how
     * many there were before. */
    void
    each_panel(const std::size_t first,
               const std::function<void(const Columns &V, const std::size_t at)>
                 &action) const;

    std::size_t              n_rows, n_columns = 0;
    std::vector<DenseMatrix> panels;
  };
} // namespace RollingContact

#endif
