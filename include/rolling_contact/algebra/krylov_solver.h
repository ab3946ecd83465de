#ifndef rolling_contact_algebra_krylov_solver_h
#define rolling_contact_algebra_krylov_solver_h

#include <functional>
#include <vector>

namespace RollingContact
{
  /**
   * A square matrix by what it does.
   */
  using LinearMap =
    std::function<std::vector<double>(const std::vector<double> &)>;

  /**
   * Solve A x = b by the generalised minimal residual method, with an
   * approximate inverse P of A (A P y = b, x = P y) and @p x the first guess.
   * False, with the best x so far, if the residual is not below @p tolerance
   * times that of x = 0 after @p max_iterations.
   */
  bool solve_by_krylov(const LinearMap           &A,
                       const LinearMap           &P,
                       const std::vector<double> &b,
                       const double               tolerance,
                       const unsigned int         max_iterations,
                       std::vector<double>       &x);
} // namespace RollingContact

#endif
