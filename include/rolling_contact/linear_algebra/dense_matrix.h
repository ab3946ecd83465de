#ifndef rolling_contact_linear_algebra_dense_matrix_h
#define rolling_contact_linear_algebra_dense_matrix_h

#include <cstddef>
#include <vector>

namespace RollingContact
{
  /**
   * A dense matrix stored by columns, as BLAS and LAPACK want it. Contact space
   * is made of these; the header stays free of deal.II so that the kernels
   * compile in a second.
   */
  class DenseMatrix
  {
  public:
    DenseMatrix() = default;
    DenseMatrix(const std::size_t n_rows, const std::size_t n_columns);

    std::size_t
    n_rows() const
    {
      return rows;
    }

    std::size_t
    n_columns() const
    {
      return columns;
    }

    double &
    operator()(const std::size_t i, const std::size_t j)
    {
      return values[i + j * rows];
    }

    double
    operator()(const std::size_t i, const std::size_t j) const
    {
      return values[i + j * rows];
    }

    double *
    data()
    {
      return values.data();
    }

    const double *
    data() const
    {
      return values.data();
    }

    /**
     * Copy the lower triangle onto the upper one.
     */
    void
    mirror_lower_triangle();

    /**
     * Product with a block, result = M(rows, columns) x for the block that
     * starts at (@p first_row, @p first_column) and has the sizes of @p result
     * and @p x.
     */
    void
    multiply_block(const std::size_t          first_row,
                   const std::size_t          first_column,
                   const std::vector<double> &x,
                   std::vector<double>       &result) const;

    /**
     * Product of the block of @p n_rows that starts there with x.
     */
    std::vector<double>
    block_product(const std::size_t          first_row,
                  const std::size_t          first_column,
                  const std::size_t          n_rows,
                  const std::vector<double> &x) const
    {
      std::vector<double> result(n_rows, 0.);
      multiply_block(first_row, first_column, x, result);
      return result;
    }

    std::size_t
    memory_consumption() const
    {
      return values.capacity() * sizeof(double);
    }

    /** For Boost.Serialization. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &rows &columns &values;
    }

  private:
    std::size_t         rows    = 0;
    std::size_t         columns = 0;
    std::vector<double> values;
  };

  /**
   * Solve M X = B in place of @p right_hand_sides by Cholesky (dposv), @p M
   * symmetric positive definite and destroyed. Returns false when M is not
   * positive definite.
   */
  bool
  solve_positive_definite(DenseMatrix &M, DenseMatrix &right_hand_sides);

  /**
   * Solve M X = B in place of @p right_hand_sides by LU (dgesv), @p M
   * destroyed. Returns false when M is singular.
   */
  bool
  solve_general(DenseMatrix &M, DenseMatrix &right_hand_sides);

  /**
   * Least-squares solution of M x = b by QR (dgels) for a matrix of full rank
   * with at least as many rows as columns, @p M destroyed. Returns false when M
   * has no full rank.
   */
  bool
  solve_least_squares(DenseMatrix &M, std::vector<double> &right_hand_side);

  /**
   * Largest eigenvalue of a symmetric @p M (dsyevr), which is destroyed, and
   * its @p vector; infinite and no vector if none is found.
   */
  double
  largest_eigenvalue(DenseMatrix &M, std::vector<double> &vector);

  /**
   * All eigenvalues of a symmetric @p M in ascending order (dsyevd), and their
   * orthonormal vectors in the columns of @p M. Throws std::runtime_error if
   * they are not found.
   */
  void
  symmetric_eigenpairs(DenseMatrix &M, std::vector<double> &values);

  double
  dot(const std::vector<double> &x, const std::vector<double> &y);

  double
  norm(const std::vector<double> &x);
} // namespace RollingContact

#endif
