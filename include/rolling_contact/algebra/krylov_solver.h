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
   * x of A x = b by the generalised minimal residual method, with an
   * approximate inverse P of A: A P y = b, x = P y. The residual is at most
   * @p tolerance times b, or as small as @p most iterations make it.
   */
  std::vector<double> solved_by_krylov(const LinearMap           &A,
                                       const LinearMap           &P,
                                       const std::vector<double> &b,
                                       const double               tolerance,
                                       const unsigned int         most);
} // namespace RollingContact

#endif
