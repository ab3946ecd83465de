#ifndef rolling_contact_state_steady_state_h
#define rolling_contact_state_steady_state_h

#include <rolling_contact/contact/halved_problem.h>
#include <rolling_contact/contact/patches.h>
#include <rolling_contact/contact/resultants.h>
#include <rolling_contact/pair/patch_estimate.h>
#include <rolling_contact/pair/rolling_pair.h>
#include <rolling_contact/run/run_context.h>
#include <rolling_contact/scene/pair_spec.h>
#include <rolling_contact/solvers/contact_solver.h>
#include <rolling_contact/state/error_estimate.h>
#include <rolling_contact/state/level_history.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * What an analysis demands of a state and its mesh, beyond what the scene
   * says.
   */
  struct StateDemands
  {
    PairDemands pair;
    /** Half-length of the zone of contact nodes over the half-width of the
     * estimated patch, where the scene gives none. */
    double zone = 1.15;
    /** Least distance from the estimated patch to the zone's border, in
     * elements: nodes touch up to 0.4 elements outside of the patch, and bodies
     * of finite size have patches a little larger than Hertz's. */
    double margin = 1.2;
    /** Largest patch that may come, over the estimated one. */
    double growth = 1.;
    /** The flow keeps its direction: an element more on the upstream side. */
    bool one_direction = true;
    /** Where patches of other states will be that are solved on this mesh, on
     * profiles. */
    std::vector<ZoneBox> other_patches;
    /** Its patch as estimated, where that is known already. */
    std::optional<PatchEstimate> patch;
    /** Corrections of an approximate compliance may begin with rough
     * responses. */
    bool rough_responses = true;
  };

  /**
   * The demands of rolling in time: vibration makes patches larger than
   * Hertz's, time cannot go back to enlarge the zone, and small errors of the
   * compliance add up.
   */
  StateDemands demands_in_time(const PairDemands &pair);

  /**
   * One steady rolling state on the mesh that was made for it.
   */
  template <int dim>
  struct SteadyState
  {
    /** Shared by the states that are solved on the same bodies. */
    std::shared_ptr<RollingPair<dim>> pair;
    Grading<dim>                      grading;
    unsigned int                      level = 0;
    ContactProblem                    problem;
    ContactState                      state;
    SolverReport                      solver;
    Resultants                        result;
    bool   restored = false; ///< its step's own gap and slip are not known
    double wall_s   = 0.;
    std::optional<double> contact_stiffness; ///< dN/d(approach), N/m

    std::optional<double>     change; ///< from the level before
    std::optional<LevelLimit> limit;  ///< of the levels up to this

    /** What this state tells of its errors, if it was asked for. */
    std::optional<ErrorEstimate> estimate;

    /** What estimates are made with, for all states of this problem; empty
     * until it was needed. */
    std::vector<HalvedProblem> halves;
  };

  /**
   * Element sizes for a patch of this size; offset in elements.
   */
  template <int dim>
  Grading<dim> make_grading(const PairSpec      &scene,
                            const StateDemands  &demands,
                            const PatchEstimate &patch,
                            const unsigned int   elements_across_patch,
                            const double         offset);

  /**
   * What the solvers start from: contact on the estimated patch, no traction.
   */
  ContactState initial_state(const ContactProblem &problem,
                             const PatchEstimate  &patch);

  /**
   * The state of @p previous at the nodes of another mesh: interpolated, zero
   * where that mesh had no trace.
   */
  template <int dim>
  ContactState transferred_state(const SteadyState<dim> &previous,
                                 const ContactProblem   &problem);

  /**
   * Solve the contact problem of a state with the scene's solver, from where it
   * is; where its load is inclined, with the normal load that this gives; where
   * forces of friction are asked for, with the creepages that have them.
   */
  template <int dim>
  void solve_contact(const PairSpec     &scene,
                     const StateDemands &demands,
                     SteadyState<dim>   &steady);

  /**
   * True if the patch reaches the border of the candidate zone.
   */
  template <int dim>
  bool zone_too_small(const SteadyState<dim> &steady)
  {
    return reaches_border(steady.pair->border_nodes(),
                          steady.problem,
                          steady.state.pressure);
  }

  /**
   * True if the patch reaches the border of the zone at the side of a disc or
   * block, or in the line of nodes next to it.
   */
  template <int dim>
  bool reaches_side(const PairSpec &scene, const SteadyState<dim> &steady);

  /**
   * Let the zone of a state grow by so many elements on each side, but across
   * no farther than the sides of discs and blocks, unless the patch reaches
   * these.
   */
  template <int dim>
  void enlarge_zone(const PairSpec         &scene,
                    const SteadyState<dim> &steady,
                    const unsigned int      n_elements,
                    Grading<dim>           &grading);

  /** The contact_patches() of a state. */
  template <int dim>
  std::vector<ContactPatch> patches_of(const SteadyState<dim> &steady)
  {
    return contact_patches(steady.pair->trace(), steady.problem, steady.state);
  }

  /**
   * Why a solve failed, "reason. Natural residual 1e-3, required 1e-10".
   */
  std::string shortfall(const SolverReport &solver, const double tolerance);

  /**
   * Throws ConvergenceError, with @p where in front, unless the state converged
   * on a patch inside its candidate zone.
   */
  template <int dim>
  void require_solved(const PairSpec         &scene,
                      const SteadyState<dim> &steady,
                      const std::string      &where);
} // namespace RollingContact

#endif
