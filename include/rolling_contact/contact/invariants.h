#ifndef rolling_contact_contact_invariants_h
#define rolling_contact_contact_invariants_h

#include <rolling_contact/contact/contact_problem.h>

#include <string>
#include <utility>
#include <vector>

namespace RollingContact
{
  /**
   * How far a state breaks what must hold whatever solver found it. All are
   * sums over the nodes of area times the violation and dimensionless: forces
   * over the load N, or mu N for friction, gaps and slips by the norms of the
   * compliances. A natural residual of size e bounds each by e, so the
   * tolerance of the solver is their limit.
   */
  struct Invariants
  {
    double pull    = 0.; ///< p < 0
    double overlap = 0.; ///< u_n < 0
    double complementarity =
      0.;                       ///< p u_n, over the larger of p and u_n as well
    double cone           = 0.; ///< |q| > mu p
    double friction_power = 0.; ///< q . s > 0, over the largest mu p + s
    double load           = 0.; ///< sum of p against the load, if that is given
    double elastic_energy = 0.; ///< r . W r < 0, over the sum of its terms

    /**
     * Names and values of all members, in their order.
     */
    std::vector<std::pair<std::string, double>> named() const;

    /**
     * Name and value of the largest invariant, or of the first that is not
     * finite; `none` and 0 if nothing is violated.
     */
    std::pair<std::string, double> worst() const;
  };

  /**
   * The invariants of @p state, found from the problem alone and by no solver's
   * means. Not a number where the state is not; infinite where something is
   * violated that is measured by a load of zero.
   */
  Invariants invariants(const ContactProblem &problem,
                        const ContactState   &state);

  /**
   * Limit of the invariants of a state whose natural residual is at most
   * @p tolerance: that, with a margin for rounding.
   */
  double invariant_limit(const double tolerance);

  /**
   * Throws ConvergenceError, with @p where in front of the message, if an
   * invariant of a converged state exceeds its limit or is not a number.
   */
  void check_invariants(const Invariants  &found,
                        const double       tolerance,
                        const std::string &where);
} // namespace RollingContact

#endif
