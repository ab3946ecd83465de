#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>

#include <cmath>
#include <limits>

#define lapack_complex_float std::complex<float>
#define lapack_complex_double std::complex<double>
#include <lapacke.h>

namespace RollingContact
{
  bool solve_positive_definite(DenseMatrix &M, Columns B)
  {
    return M.size() == 0 || LAPACKE_dposv(LAPACK_COL_MAJOR,
                                          'L',
                                          M.rows(),
                                          B.cols(),
                                          M.data(),
                                          M.rows(),
                                          B.data(),
                                          B.outerStride()) == 0;
  }

  bool solve_positive_definite_band(DenseMatrix &band, Columns B)
  {
    return LAPACKE_dpbsv(LAPACK_COL_MAJOR,
                         'L',
                         band.cols(),
                         band.rows() - 1,
                         B.cols(),
                         band.data(),
                         band.rows(),
                         B.data(),
                         B.outerStride()) == 0;
  }

  bool solve_general(DenseMatrix &M, Columns B)
  {
    std::vector<int> pivots(M.rows());
    return M.size() == 0 || LAPACKE_dgesv(LAPACK_COL_MAJOR,
                                          M.rows(),
                                          B.cols(),
                                          M.data(),
                                          M.rows(),
                                          pivots.data(),
                                          B.data(),
                                          B.outerStride()) == 0;
  }

  bool solve_least_squares(DenseMatrix &M, std::vector<double> &b)
  {
    const int info = LAPACKE_dgels(LAPACK_COL_MAJOR,
                                   'N',
                                   M.rows(),
                                   M.cols(),
                                   1,
                                   M.data(),
                                   M.rows(),
                                   b.data(),
                                   M.rows());
    b.resize(M.cols());
    return info == 0;
  }

  ComplexLU::ComplexLU(ComplexMatrix M)
    : factors(std::move(M))
    , pivots(factors.rows())
  {
    if (factors.size() > 0)
      is_singular = LAPACKE_zgetrf(LAPACK_COL_MAJOR,
                                   factors.rows(),
                                   factors.rows(),
                                   factors.data(),
                                   factors.rows(),
                                   pivots.data()) != 0 ||
                    !factors.diagonal().allFinite();
  }

  void ComplexLU::solve(Eigen::Ref<ComplexMatrix> B) const
  {
    if (B.size() > 0)
      LAPACKE_zgetrs(LAPACK_COL_MAJOR,
                     'N',
                     factors.rows(),
                     B.cols(),
                     factors.data(),
                     factors.rows(),
                     pivots.data(),
                     B.data(),
                     B.outerStride());
  }

  std::complex<double> ComplexLU::log_determinant() const
  {
    if (is_singular)
      return -std::numeric_limits<double>::infinity();
    double modulus = 0., phase = 0.;
    for (std::size_t i = 0; i < pivots.size(); ++i)
      {
        modulus += std::log(std::abs(factors(i, i)));
        phase += std::arg(factors(i, i));
        if (pivots[i] != static_cast<int>(i) + 1)
          phase += pi;
      }
    return {modulus, std::remainder(phase, 2 * pi)};
  }

  namespace
  {
    void check(const int info, const std::string &what)
    {
      if (info != 0)
        throw ConvergenceError(
          what + " did not converge (LAPACK: info = " + std::to_string(info) +
          "); the matrix may hold no numbers.");
    }

    /** dsyevd with or without vectors. */
    std::vector<double> symmetric(const char job, DenseMatrix &M)
    {
      const int           n = M.rows();
      std::vector<double> values(n);
      if (n > 0)
        check(LAPACKE_dsyevd(
                LAPACK_COL_MAJOR, job, 'L', n, M.data(), n, values.data()),
              "The QR algorithm for symmetric eigenvalues");
      return values;
    }

    /**
     * dgeev; the vectors of conjugate pairs stand in @p vectors as real and
     * imaginary part.
     */
    ComplexValues general(DenseMatrix &M, DenseMatrix *vectors)
    {
      const int       n = M.rows();
      Eigen::VectorXd real(n), imaginary(n);
      if (n > 0)
        check(LAPACKE_dgeev(LAPACK_COL_MAJOR,
                            'N',
                            vectors ? 'V' : 'N',
                            n,
                            M.data(),
                            n,
                            real.data(),
                            imaginary.data(),
                            nullptr,
                            1,
                            vectors ? vectors->data() : nullptr,
                            vectors ? n : 1),
              "The QR algorithm for eigenvalues");
      ComplexValues values;
      for (int k = 0; k < n; ++k)
        values.emplace_back(real[k], imaginary[k]);
      return values;
    }
  } // namespace

  std::vector<double> symmetric_eigenvalues(DenseMatrix M)
  {
    return symmetric('N', M);
  }

  std::vector<double> symmetric_eigenpairs(DenseMatrix &M)
  {
    return symmetric('V', M);
  }

  ComplexValues eigenvalues(DenseMatrix M)
  {
    return general(M, nullptr);
  }

  Eigenpairs eigenpairs(DenseMatrix M)
  {
    const Eigen::Index         n = M.rows();
    const std::complex<double> i(0., 1.);
    DenseMatrix                real(n, n);
    Eigenpairs                 pairs{general(M, &real), real};
    for (Eigen::Index k = 0; k + 1 < n; ++k)
      if (pairs.values[k].imag() > 0.)
        {
          pairs.vectors.col(k)     = real.col(k) + i * real.col(k + 1);
          pairs.vectors.col(k + 1) = real.col(k) - i * real.col(k + 1);
        }
    return pairs;
  }

  Eigenpairs eigenpairs(ComplexMatrix M)
  {
    const int  n = M.rows();
    Eigenpairs pairs{ComplexValues(n), ComplexMatrix(n, n)};
    if (n > 0)
      check(LAPACKE_zgeev(LAPACK_COL_MAJOR,
                          'N',
                          'V',
                          n,
                          M.data(),
                          n,
                          pairs.values.data(),
                          nullptr,
                          1,
                          pairs.vectors.data(),
                          n),
            "The QR algorithm for eigenvalues");
    return pairs;
  }

  DenseMatrix left_singular_vectors(DenseMatrix M, std::vector<double> &values)
  {
    const int   m = M.rows(), n = M.cols(), k = std::min(m, n);
    DenseMatrix U(m, k);
    values.assign(k, 0.);
    std::vector<double> rest(k);
    if (k > 0)
      check(LAPACKE_dgesvd(LAPACK_COL_MAJOR,
                           'S',
                           'N',
                           m,
                           n,
                           M.data(),
                           m,
                           values.data(),
                           U.data(),
                           m,
                           nullptr,
                           n,
                           rest.data()),
            "The singular value decomposition");
    return U;
  }

  ComplexVector smallest_singular_vector(ComplexMatrix M)
  {
    const int           m = M.rows(), n = M.cols();
    ComplexMatrix       adjoint(n, n);
    std::vector<double> values(n), rest(n);
    check(LAPACKE_zgesvd(LAPACK_COL_MAJOR,
                         'N',
                         'A',
                         m,
                         n,
                         M.data(),
                         m,
                         values.data(),
                         nullptr,
                         m,
                         adjoint.data(),
                         n,
                         rest.data()),
          "The singular value decomposition");
    return adjoint.row(n - 1).adjoint();
  }
} // namespace RollingContact
