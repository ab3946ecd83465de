#ifndef rolling_contact_algebra_dense_matrix_h
#define rolling_contact_algebra_dense_matrix_h

#include <boost/serialization/array_wrapper.hpp>

#include <Eigen/Core>

#include <complex>
#include <cstddef>
#include <vector>

namespace RollingContact
{
  /**
   * Dense matrices stored by columns, as BLAS and LAPACK want them. Products
   * are made by BLAS (EIGEN_USE_BLAS), systems and eigenvalues by LAPACK, see
   * lapack.h. Sizes alone leave the entries undefined: Zero() sets them.
   */
  using DenseMatrix   = Eigen::MatrixXd;
  using ComplexMatrix = Eigen::MatrixXcd;
  using ComplexVector = Eigen::VectorXcd;

  /**
   * A list of complex numbers, such as eigenvalues.
   */
  using ComplexValues = std::vector<std::complex<double>>;

  /**
   * The entries of a standard vector for expressions of matrices, without a
   * copy.
   */
  inline Eigen::Map<const Eigen::VectorXd>
  as_vector(const std::vector<double> &x)
  {
    return {x.data(), static_cast<Eigen::Index>(x.size())};
  }

  inline Eigen::Map<Eigen::VectorXd> as_vector(std::vector<double> &x)
  {
    return {x.data(), static_cast<Eigen::Index>(x.size())};
  }

  /**
   * Column @p j of a matrix as a standard vector.
   */
  inline std::vector<double> column_of(const DenseMatrix &M,
                                       const std::size_t  j)
  {
    return {M.data() + j * M.rows(), M.data() + (j + 1) * M.rows()};
  }

  /**
   * Vectors of so many entries side by side.
   */
  DenseMatrix columns_of(const std::vector<std::vector<double>> &vectors,
                         const std::size_t                       n_rows);

  /**
   * M x by dgemv.
   */
  std::vector<double> operator*(const DenseMatrix         &M,
                                const std::vector<double> &x);

  /**
   * M^T x.
   */
  inline std::vector<double> transposed_product(const DenseMatrix         &M,
                                                const std::vector<double> &x)
  {
    std::vector<double> result(M.cols());
    as_vector(result) = M.transpose() * as_vector(x);
    return result;
  }

  /**
   * Product of x with the block of @p n_rows that starts there, by dgemv.
   */
  std::vector<double> block_product(const DenseMatrix         &M,
                                    const std::size_t          first_row,
                                    const std::size_t          first_column,
                                    const std::size_t          n_rows,
                                    const std::vector<double> &x);

  inline std::size_t memory_consumption(const DenseMatrix &M)
  {
    return M.size() * sizeof(double);
  }

  double dot(const std::vector<double> &x, const std::vector<double> &y);

  double norm(const std::vector<double> &x);

  /**
   * x + factor y.
   */
  std::vector<double>
  sum(std::vector<double> x, const double factor, const std::vector<double> &y);

  /**
   * A X of a sparse matrix, which multiplies vectors, and a block of columns.
   */
  template <class Matrix>
  DenseMatrix times(const Matrix &A, const DenseMatrix &X)
  {
    DenseMatrix         result(X.rows(), X.cols());
    std::vector<double> image(X.rows());
    for (Eigen::Index j = 0; j < X.cols(); ++j)
      {
        A.multiply(column_of(X, j), image);
        result.col(j) = as_vector(image);
      }
    return result;
  }

  /**
   * X^T A X of a sparse matrix; empty if A is.
   */
  template <class Matrix>
  DenseMatrix projected(const Matrix &A, const DenseMatrix &X)
  {
    if (A.size() == 0)
      return {};
    return X.transpose() * times(A, X);
  }
} // namespace RollingContact

namespace Eigen
{
  /** For Boost.Serialization. */
  template <typename Archive>
  void serialize(Archive &archive, MatrixXd &M, const unsigned int)
  {
    Index          rows = M.rows(), columns = M.cols();
    archive &rows &columns;
    M.resize(rows, columns);
    auto     entries = boost::serialization::make_array(M.data(), M.size());
    archive &entries;
  }
} // namespace Eigen

#endif
