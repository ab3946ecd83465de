#ifndef rolling_contact_results_estimated_bounds_h
#define rolling_contact_results_estimated_bounds_h

#include <rolling_contact/contact/resultants.h>
#include <rolling_contact/results/error_bounds.h>
#include <rolling_contact/state/error_estimate.h>

namespace RollingContact
{
  /**
   * The bounds of a state with the values @p result that an @p estimate of its
   * own errors gives, together with those of its circumstances, which stand for
   * the worst place of a mesh. Of the elements across the patch, E is what
   * every second node changes and m the bound without growth and residual:
   *   min(m, sqrt(w E m) + v m)
   * with w = 1 and v = 0.15 where m is of first order, w = 0.4 and v = 0.05
   * where of a higher in 2D, and w = 0.2 and v = 0.1 in 3D, under spin at least
   * E / 3 but at most 2 m; m alone where nothing is told by every second node.
   * Where nothing sticks it is min(m, E + R/8) with R = sum P_i t_i^2 / N, the
   * nodes' loads P_i and how much their slip changes to their neighbours, over
   * the smaller of both and at most 1: a stick zone smaller than an element is
   * not seen. With `upwind 1`, and in 3D with friction that falls with the
   * sliding speed, it is at least m where something sticks. With levels of
   * refinement E is not above what the last level changed, nor below a third of
   * itself, and the sum at least 1.3 times that. What is missing in the bulk
   * comes to it, 0.8 times, and 1.3 times under a given approach, whose load
   * has it in full. The weights hold 99 % of one set of random scenes and are
   * judged on others, see doc/explanation/errors.md.
   */
  ErrorBounds estimated_bounds(const BoundCircumstances &found,
                               const ErrorEstimate      &estimate,
                               const Resultants         &result);
} // namespace RollingContact

#endif
