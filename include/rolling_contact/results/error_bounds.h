#ifndef rolling_contact_results_error_bounds_h
#define rolling_contact_results_error_bounds_h

#include <rolling_contact/scene/pair_spec.h>
#include <rolling_contact/state/steady_state.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * What decides which bounds hold for a state. Lengths over the half-width of
   * the patch, residuals over N and mu N.
   */
  struct BoundCircumstances
  {
    int              dim         = 2;
    SlipOperatorKind kind        = SlipOperatorKind::calibrated;
    double           n           = 0.; ///< elements across the patch
    double           beta        = 0.; ///< |Dundurs' constant|
    double           waves       = 0.; ///< largest change_of_curvature()
    double           on_upwind_2 = 0.; ///< share of leading edges left to it
    double thickness = std::numeric_limits<double>::infinity(); ///< smallest
    bool   edges_settled = true, edge_law = true;
    bool   spin              = false;
    bool   expected          = false; ///< before there is a state
    double incompressibility = 0.;    ///< up to nu = 0.45; 1 at nu = 0.5
    bool   varying_friction  = false; ///< from place to place, or with a memory
    bool   falling_friction  = false; ///< with the sliding speed
    bool   refined           = false; ///< lines end at smaller elements
    bool   split             = false; ///< compliance of SplitBody
    bool   approach_given    = false; ///< the load is found, and has an error
    double friction          = 0.;    ///< mu
    double growth            = 0.;    ///< of the mesh
    double residual_normal = 0., residual_tangential = 0.;
    /**
     * Second difference of the pressure across at its peak, over the peak: how
     * sharply it bends under profiles, where it follows no closed form.
     */
    double bend_of_peak   = 0.;
    double element_aspect = 1.; ///< 3D: length in x over width of elements
  };

  /**
   * How many times the bound of the circumstances a state under spin in 3D may
   * be off, with few elements across the patch, as every second node tells.
   */
  constexpr double most_under_spin = 2.;

  /**
   * How far a state may be off from that of an infinitely fine mesh of the same
   * bodies, and from what that is concluded. A bound that is not known is
   * empty. What the time step of a transient run adds is in none, see
   * StepErrors.
   */
  struct ErrorBounds
  {
    std::optional<double> force;        ///< over mu N
    std::optional<double> moment;       ///< 3D: over mu N a
    std::optional<double> max_pressure; ///< over the peak pressure
    std::optional<double> normal_force; ///< over N, under a given approach
    std::optional<double> dissipation;  ///< over the heat of friction
    std::string           text;         ///< what that of the force is made of
    /** Share of first order in what the mesh adds to that of the force. */
    double first_order = 1.;
  };

  /**
   * Bounds of the error that follow without a solution: c / n^p, measured by
   * tests/campaigns/error_bounds, with n elements across the patch in the
   * rolling direction. Additions account for thin bodies, materials that
   * differ, surfaces with waves, long elements, the growth of the mesh, the
   * residual of the solver, little friction, and edges of the patch that did
   * not settle or at which upwind 2 took the place of the edge law.
   */
  ErrorBounds error_bounds(const BoundCircumstances &found);

  /**
   * What is known without a state, of a patch with this half-width. Units: m.
   */
  BoundCircumstances expected_circumstances(const PairSpec &scene,
                                            const double    half_width);

  /**
   * What a state turned out to be.
   */
  template <int dim>
  BoundCircumstances bound_circumstances(const PairSpec         &scene,
                                         const SteadyState<dim> &steady);

  /**
   * What the residual of the solver adds to the bound of the force, over mu N.
   */
  double residual_share(const BoundCircumstances &found);

  /**
   * The bounds of a state: those of its circumstances, or, where it has an
   * estimate of its own errors, estimated_bounds().
   */
  template <int dim>
  ErrorBounds error_bounds(const PairSpec         &scene,
                           const SteadyState<dim> &steady);

  /**
   * How far the creepages of a state that were found for asked forces may be
   * off, in the order of these, by the bounds of its forces; empty if those are
   * not known or the forces so close to what friction can carry that every
   * larger creepage may be it. Units: 1, 1/m.
   */
  template <int dim>
  std::vector<double> creepage_bounds(const PairSpec         &scene,
                                      const SteadyState<dim> &steady,
                                      const ErrorBounds      &bounds);
} // namespace RollingContact

#endif
