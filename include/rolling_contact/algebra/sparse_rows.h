#ifndef rolling_contact_algebra_sparse_rows_h
#define rolling_contact_algebra_sparse_rows_h

#include <rolling_contact/algebra/dense_matrix.h>

#include <utility>
#include <vector>

namespace RollingContact
{
  /**
   * A small sparse square matrix by rows, whose rows can be replaced one by
   * one: the contact operators H and B1, a few entries in each row.
   */
  class SparseRows
  {
  public:
    using Row = std::vector<std::pair<unsigned int, double>>;

    explicit SparseRows(const unsigned int n = 0)
      : rows(n)
    {}

    unsigned int size() const
    {
      return rows.size();
    }

    Row &operator[](const unsigned int i)
    {
      return rows[i];
    }

    const Row &operator[](const unsigned int i) const
    {
      return rows[i];
    }

    /**
     * Add a value to an entry: entries of the same column in a row are summed.
     */
    void add(const unsigned int i, const unsigned int j, const double value);

    /**
     * Product y_c = M x_c for each of the consecutive blocks x_c of length
     * size().
     */
    std::vector<double> multiply(const std::vector<double> &x) const;

    /**
     * Product y_c = M^T x_c for each of the consecutive blocks x_c of length
     * size().
     */
    std::vector<double> multiply_transposed(const std::vector<double> &x) const;

    SparseRows transposed() const;

    /**
     * The matrix M in dense form.
     */
    DenseMatrix dense() const;

  private:
    std::vector<Row> rows;
  };

  /**
   * Value of a row applied to the block of @p x that starts at @p offset.
   */
  double apply(const SparseRows::Row     &row,
               const std::vector<double> &x,
               const std::size_t          offset = 0);

  /**
   * The rows of a matrix @p P of @p n columns once for each component, one
   * component after the other: column j of component c becomes @p numbers[c n +
   * j].
   */
  SparseRows of_components(const SparseRows               &P,
                           const std::vector<std::size_t> &numbers,
                           const std::size_t               n);
} // namespace RollingContact

#endif
