#ifndef rolling_contact_algebra_half_solves_h
#define rolling_contact_algebra_half_solves_h

#include <vector>

struct cholmod_factor_struct;

namespace RollingContact
{
  /**
   * Forward solve x <- L^-1 x of one or two columns in elimination order, with
   * CHOLMOD's supernodal factor L. A half-solve waits for the memory that L is
   * read from, so that two columns take little longer than one; each gets the
   * digits it gets alone. @p workspace is resized as needed.
   */
  void solve_forward(const cholmod_factor_struct              &L,
                     const std::vector<std::vector<double> *> &x,
                     std::vector<double>                      &workspace);

  /**
   * Backward solve x <- L^-T x, as solve_forward().
   */
  void solve_backward(const cholmod_factor_struct              &L,
                      const std::vector<std::vector<double> *> &x,
                      std::vector<double>                      &workspace);
} // namespace RollingContact

#endif
