#ifndef rolling_contact_algebra_condensation_h
#define rolling_contact_algebra_condensation_h

#include <rolling_contact/algebra/sparse_rows.h>

#include <cstddef>
#include <cstdint>
#include <vector>

struct cholmod_factor_struct;

namespace RollingContact
{
  /**
   * Condensed columns Y = L^-1 E for the loads E of contact, unit columns of
   * its unknowns for one, kept as one dense block for each supernode on the
   * elimination-tree paths of these columns. Columns are sorted by the first of
   * their rows that is eliminated, so that those alive in a supernode, where
   * they have a row in its subtree, are in the range [first_column,
   * first_column + n_columns); of unit columns there are no others in it.
   */
  struct CondensedColumns
  {
    struct Block
    {
      std::int64_t        first_row    = 0;
      std::int64_t        n_rows       = 0;
      std::int64_t        first_column = 0;
      std::int64_t        n_columns    = 0;
      std::vector<double> values;
    };

    std::vector<Block>        blocks;
    std::vector<std::int64_t> column_order;

    /**
     * Add a product with Y, z += scale Y r, with z in elimination order.
     */
    void add_product(const double               scale,
                     const std::vector<double> &r,
                     std::vector<double>       &z) const;

    /**
     * Product Y^T z, with z in elimination order.
     */
    std::vector<double> transposed_product(const std::vector<double> &z) const;

    std::size_t memory_consumption() const;
  };

  /**
   * Compliance W = E^T K^-1 E = Y^T Y from CHOLMOD's supernodal factor of K;
   * row k of @p loads has unknowns and values of column k of E, see
   * Factorisation::condense().
   * Supernode by supernode on the elimination paths, with BLAS-3.
   */
  DenseMatrix condensed_compliance(const cholmod_factor_struct &L,
                                   const SparseRows            &loads,
                                   CondensedColumns            *columns);
} // namespace RollingContact

#endif
