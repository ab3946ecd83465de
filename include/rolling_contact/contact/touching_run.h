#ifndef rolling_contact_contact_touching_run_h
#define rolling_contact_contact_touching_run_h

#include <rolling_contact/contact/contact_problem.h>

namespace RollingContact
{
  /**
   * Consecutive touching nodes of a line, in the order of the flow.
   */
  struct TouchingRun
  {
    std::vector<unsigned int> nodes;
    bool leading = true;  ///< the point one element upstream is open
    bool cut     = false; ///< the line ends inside the contact
  };

  /**
   * All runs of touching nodes on the lines of the slip operator.
   */
  std::vector<TouchingRun> touching_runs(const SlipOperator &slip_operator,
                                         const std::vector<double> &pressure);

  /**
   * The coordinates of its nodes along the flow. Units: m.
   */
  std::vector<double> places(const TouchingRun      &run,
                             const ContactOperators &operators);

  /**
   * How much the curvature of the undeformed gap changes from one node of the
   * run to the next, at most, over its mean: far below one on a smooth profile,
   * above one where the gap has waves that its nodes do not resolve.
   */
  double change_of_curvature(const TouchingRun         &run,
                             const std::vector<double> &x,
                             const std::vector<double> &gap);
} // namespace RollingContact

#endif
