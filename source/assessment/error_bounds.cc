#include <rolling_contact/assessment/error_bounds.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/contact/touching_run.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace RollingContact
{
  namespace
  {
    /**
     * c / n^p.
     */
    struct Bound
    {
      double constant;
      double order;

      double
      at(const double n) const
      {
        return constant / std::pow(n, order);
      }
    };



    /**
     * What decides which bound holds.
     */
    struct Circumstances
    {
      SlipOperatorKind kind  = SlipOperatorKind::calibrated;
      double           n     = 0.; ///< elements across the patch
      double           beta  = 0.; ///< |Dundurs' constant|
      double           waves = 0.; ///< largest change_of_curvature()
      double thickness = std::numeric_limits<double>::infinity(); ///< over a
      bool   edges_settled = true, edge_law = true;
      bool   nearly_incompressible = false, spin = false;
      bool   refined = false; ///< lines end at smaller elements
    };



    template <int dim>
    Circumstances
    circumstances(const SceneParameters &scene, const SteadyState<dim> &steady)
    {
      const ContactProblem &problem = steady.problem;
      const double          a       = steady.result.half_width_x;
      Circumstances         found;
      found.kind          = problem.operators.slip_operator().kind();
      found.n             = a > 0. ? 2 * a / steady.grading.element_size_x
                                   : steady.grading.elements_across();
      found.beta          = std::abs(pair_constants(scene).dundurs_beta);
      found.spin          = problem.loads.creepages.spin != 0.;
      found.edge_law      = steady.state.edge_law;
      found.edges_settled = steady.solver.edges_settled;
      for (const BodyParameters *body : {&scene.wheel, &scene.rail})
        if (!body->rigid)
          {
            found.nearly_incompressible = found.nearly_incompressible ||
                                          body->material.poisson_ratio > 0.45;
            if (a > 0.)
              found.thickness =
                std::min(found.thickness,
                         body->body_shape()->thickness_below() / a);
          }
      for (const TouchingRun &run :
           touching_runs(problem.operators.slip_operator(),
                         steady.state.pressure))
        {
          found.refined = found.refined || run.cut;
          found.waves =
            std::max(found.waves,
                     change_of_curvature(run,
                                         places(run, problem.operators),
                                         problem.loads.gap));
        }
      return found;
    }



    /**
     * The edge law keeps its order for one material that is not nearly
     * incompressible.
     */
    bool
    edge_law_holds(const Circumstances &found)
    {
      return found.beta < 1e-12 && !found.nearly_incompressible &&
             found.edge_law;
    }



    /**
     * Below one half-width of thickness, and with waves that no mesh of this
     * size resolves, nothing was found that bounds the error.
     */
    const double thinnest = 1., roughest = 3.;

    /**
     * Waves that the edge law leaves to upwind 2, see slip_rows().
     */
    const double unresolved = 0.5;

    /**
     * Bodies thinner than so many half-widths count as thin.
     */
    const double thin = 3.;

    /**
     * What a wave adds, over change_of_curvature().
     */
    const double of_waves = 0.05;

    /**
     * What the growth of the mesh adds, over Mesh/Growth, and the residual of
     * the solver, over itself.
     */
    const double of_growth = 2e-3, of_residual = 4.;

    /**
     * Change of the gap's curvature from which on waves count.
     */
    const double wavy = 0.1;

    /**
     * Factor of the bound where the edge law does not keep its order and the
     * body is thin, the rim refined, or the gap has waves as well.
     */
    const double of_both = 2.5;

    /**
     * Factor of the bound where the one edge of a plane patch did not settle;
     * in 3D it is a few of many.
     */
    const double of_unsettled = 2.;



    Bound
    force_bound(const int dim, const Circumstances &found)
    {
      const bool plane     = dim == 2;
      const bool disturbed = found.thickness < thin || found.refined;
      if (found.kind == SlipOperatorKind::upwind_1)
        return {plane ? 0.65 : 1.1, 1.};
      if (found.kind == SlipOperatorKind::galerkin)
        return {plane ? 1.6 : 0.8, 1.};
      const bool upwind_2 = found.kind == SlipOperatorKind::upwind_2;
      if (found.beta > 1e-12 || !(upwind_2 || edge_law_holds(found)))
        return {((plane ? 0.6 : 0.75) + 2.4 * found.beta) *
                  (disturbed || found.waves > wavy ? of_both : 1.),
                1.};
      if (upwind_2 || found.waves > unresolved)
        return {plane ? 0.4 : 0.65, 1.};
      if (plane)
        return {disturbed ? 5. : 1.3, 2.};
      return found.spin ? Bound{0.5, 1.5} : Bound{disturbed ? 2.6 : 1.3, 2.};
    }



    std::string
    in_words(const Bound &bound, const double n)
    {
      return significant(bound.constant, 2) + "/n" +
             (bound.order > 1. ? "^" + significant(bound.order, 2) : "") +
             ", n = " + significant(n, 2) + " elements across the patch";
    }
  } // namespace



  template <int dim>
  ErrorBounds
  error_bounds(const SceneParameters &scene, const SteadyState<dim> &steady)
  {
    const Circumstances found = circumstances(scene, steady);
    ErrorBounds         bounds;
    if (found.thickness < thinnest)
      bounds.text = "a body is thinner than half the patch";
    else if (found.waves > roughest)
      bounds.text = "the surface has waves of few elements";
    if (!bounds.text.empty())
      return bounds;

    const Bound  bound = force_bound(dim, found);
    const double added = of_waves * (found.waves > wavy ? found.waves : 0.) +
                         of_growth * scene.mesh.growth +
                         of_residual * steady.solver.residual.tangential;
    bounds.force =
      std::min(1.,
               (dim == 3 || found.edges_settled ? 1. : of_unsettled) *
                   bound.at(found.n) +
                 added);
    bounds.text = in_words(bound, found.n) + ", and " + scientific(added, 1) +
                  " for " + (found.waves > wavy ? "waves, " : "") +
                  "the growth of the mesh and the residual";
    if (dim == 3)
      bounds.moment = bounds.force;
    bounds.max_pressure =
      Bound{2., 2.}.at(found.n) +
      (found.waves > wavy ? 0.3 * found.waves : 0.) +
      4 * found.beta * scene.contact.friction_coefficient / found.n +
      of_growth * scene.mesh.growth +
      of_residual * steady.solver.residual.normal;
    return bounds;
  }



  template ErrorBounds
  error_bounds(const SceneParameters &, const SteadyState<2> &);
  template ErrorBounds
  error_bounds(const SceneParameters &, const SteadyState<3> &);
} // namespace RollingContact
