#ifndef rolling_contact_wheelset_curve_walk_h
#define rolling_contact_wheelset_curve_walk_h

#include <rolling_contact/wheelset/running_gear.h>

#include <vector>

namespace RollingContact
{
  /**
   * Equilibria from one case to the next, from straight track without forces on
   * in steps of curvature and of all that acts, each begun where the two before
   * point to: in a curve a wheelset in the middle of the track has both wheels
   * sliding, and nothing tells where the equilibrium is. Steps grow after
   * success and shrink after failure; where they become small, the shift is
   * bracketed.
   */
  class CurveWalk
  {
  public:
    explicit CurveWalk(RunningGear &gear)
      : gear(gear)
    {}

    /**
     * Find the equilibrium of straight track without forces. Throws
     * ConvergenceError if there is none.
     */
    void begin();

    /**
     * Go on to a case; the equilibrium is there then, closed to a residual
     * (over the axle load). Throws ConvergenceError that says where the walk
     * ended and why.
     */
    void go_to(const CurveCase &target,
               const double     residual = Equilibrium::tolerance);

  private:
    bool step_to(const CurveCase &acting);

    /** Where the last two points lead to. */
    RunningState predicted(const CurveCase &acting) const;

    RunningGear              &gear;
    std::vector<RunningState> last;                  ///< two at most
    double                    curvature_step = 2e-4; ///< 1/m
  };
} // namespace RollingContact

#endif
