#ifndef rolling_contact_wheelset_wheelset_solver_h
#define rolling_contact_wheelset_wheelset_solver_h

#include <rolling_contact/wheelset/curve_walk.h>
#include <rolling_contact/wheelset/found_equilibrium.h>

#include <vector>

namespace RollingContact
{
  /**
   * The equilibria of the wheelset or bogie of a scene in one case after the
   * other: a walk on half-spaces, then the balances once more on the bodies and
   * meshes of the scene. A curve to the left is solved as its mirror image.
   */
  class WheelsetSolver
  {
  public:
    /** Throws InputError if a profile cannot be read. */
    explicit WheelsetSolver(const Situation &scene);

    std::size_t n_cases() const
    {
      return cases.size();
    }

    /**
     * The next case: its wheelset, or the two of a bogie, with states of their
     * wheels in the track and bounds. Throws ConvergenceError if there is none.
     */
    std::vector<FoundEquilibrium> next();

  private:
    /** The equilibrium of a case, on meshes of its own patches. */
    std::vector<FoundEquilibrium> refined(const RunningState &walked);

    /** How small motions about it go on. */
    void hunt(std::vector<FoundEquilibrium> &found) const;

    /** Wheels as they stand in the track, with their errors. */
    void finish(std::vector<FoundEquilibrium> &found);

    void finish_wheels(FoundEquilibrium &found, WheelPair &pair) const;

    /** How far each wheelset may be off. */
    void find_bounds(std::vector<FoundEquilibrium> &found) const;

    /** Another equilibrium of the last case, if there is one. */
    void search_another(FoundEquilibrium &found);

    const bool               is_mirrored; ///< solved as a curve to the right
    const WheelsetParameters wheelset;    ///< as it is solved
    const std::vector<CurveCase> cases;
    const double                 radius; ///< of a wheel, m
    RunningGear                  rough, fine;
    CurveWalk                    walk;
    std::size_t                  n_found = 0;
  };
} // namespace RollingContact

#endif
