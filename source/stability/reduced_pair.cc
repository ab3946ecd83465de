#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/linear_algebra/dense_eigenvalues.h>
#include <rolling_contact/stability/reduced_pair.h>

#include <cmath>

namespace RollingContact
{
  namespace
  {
    void
    check_size(const DenseMatrix &M,
               const std::string &name,
               const std::size_t  n_rows,
               const std::size_t  n_columns)
    {
      if (M.n_rows() != n_rows || M.n_columns() != n_columns)
        throw InputError(
          name + " of the reduced bodies has " + std::to_string(M.n_rows()) +
          " x " + std::to_string(M.n_columns()) + " entries; it needs " +
          std::to_string(n_rows) + " x " + std::to_string(n_columns) + ".");
      for (std::size_t k = 0; k < n_rows * n_columns; ++k)
        if (!std::isfinite(M.data()[k]))
          throw InputError(name + " of the reduced bodies has an entry that is "
                                  "no number.");
    }
  } // namespace



  void
  check(const ReducedPair &pair)
  {
    const std::size_t m = pair.n_modes(), n = pair.W_res.n_rows();
    check_size(pair.K_m, "The stiffness", m, m);
    check_size(pair.C_m, "The damping", m, m);
    check_size(pair.Phi, "The modes at the contact", n, m);
    check_size(pair.W_res, "The residual compliance", n, n);
    if (pair.n_wheel_modes > m)
      throw InputError("There are " + std::to_string(pair.n_wheel_modes) +
                       " modes of the wheel, more than the " +
                       std::to_string(m) + " of both bodies.");
    if (n == 0)
      return;

    const std::vector<double> values  = symmetric_eigenvalues(pair.W_res);
    const double              largest = values.back();
    double                    skew    = 0.;
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < j; ++i)
        skew = std::max(skew, std::abs(pair.W_res(i, j) - pair.W_res(j, i)));
    if (skew > 1e-8 * std::abs(largest))
      throw InputError("The residual compliance is not symmetric: entries "
                       "differ by " +
                       significant(skew, 3) + " m/N from their mirror image.");
    if (values.front() < -1e-10 * std::max(largest, 0.))
      throw InputError(
        "The residual compliance of the bodies has a negative eigenvalue, " +
        significant(values.front(), 3) + " m/N, where its largest is " +
        significant(largest, 3) +
        " m/N; at least -1e-10 of that is allowed. Modes and compliance must "
        "come from the same stiffness matrix.");
  }



  void
  add_rotation(ReducedPair &pair, const DenseMatrix &S, const double rate)
  {
    const std::size_t m = pair.n_modes();
    check_size(S, "The matrix of rotation", m, m);
    const DenseMatrix S_S = S * S, C_S = pair.C_m * S;
    for (std::size_t j = 0; j < m; ++j)
      for (std::size_t i = 0; i < m; ++i)
        {
          pair.C_m(i, j) += 2 * rate * S(i, j);
          pair.K_m(i, j) += rate * rate * S_S(i, j) + rate * C_S(i, j);
        }
  }
} // namespace RollingContact
