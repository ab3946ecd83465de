#ifndef rolling_contact_algebra_indefinite_factor_h
#define rolling_contact_algebra_indefinite_factor_h

#include <rolling_contact/algebra/symmetric_sparse_matrix.h>

#include <complex>
#include <cstddef>
#include <memory>
#include <vector>

namespace RollingContact
{
  /**
   * How many eigenvalues of a symmetric matrix are negative, by Sylvester's law
   * of inertia from MUMPS' factor L D L^T, which is not kept. Of K - lambda M:
   * how many eigenvalues of K x = lambda M x lie below lambda. Throws
   * MemoryError, and ConvergenceError if MUMPS fails.
   */
  std::size_t
  n_negative_eigenvalues(const SymmetricSparseMatrix     &matrix,
                         const std::vector<unsigned int> &node_of_unknown);

  /**
   * The factor of a complex symmetric matrix A + i B by MUMPS, for forced
   * vibration at one frequency: K - omega^2 M and what is lost.
   */
  class ComplexFactor
  {
  public:
    using Values = std::vector<std::complex<double>>;

    /**
     * Order, analyse and factorise @p real + i @p imaginary. Throws as
     * n_negative_eigenvalues().
     */
    ComplexFactor(const SymmetricSparseMatrix     &real,
                  const SymmetricSparseMatrix     &imaginary,
                  const std::vector<unsigned int> &node_of_unknown);

    ~ComplexFactor();

    ComplexFactor(const ComplexFactor &)            = delete;
    ComplexFactor &operator=(const ComplexFactor &) = delete;

    Values solve(const Values &right_hand_side);

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation;
  };
} // namespace RollingContact

#endif
