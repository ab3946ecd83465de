#include <rolling_contact/assessment/reference_2d.h>
#include <rolling_contact/assessment/result_error.h>
#include <rolling_contact/assessment/state_errors.h>
#include <rolling_contact/base/text.h>

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
    };



    /**
     * The edge law keeps its order for one material that is not nearly
     * incompressible.
     */
    bool
    edge_law_holds(const SceneParameters &scene)
    {
      bool holds = std::abs(pair_constants(scene).dundurs_beta) < 1e-12;
      for (const BodyParameters *body : {&scene.wheel, &scene.rail})
        holds = holds && (body->rigid || body->material.poisson_ratio <= 0.45);
      return holds;
    }



    /**
     * Of prm/accuracy_2d.prm and prm/accuracy_3d.prm, and of unequal materials
     * and nu = 0.4999 in 2D.
     */
    template <int dim>
    Bound
    measured_bound(const SceneParameters &scene, const SteadyState<dim> &steady)
    {
      const SlipOperatorKind kind =
        steady.problem.operators.slip_operator().kind();
      if (kind == SlipOperatorKind::upwind_1)
        return {dim == 2 ? 0.65 : 1.1, 1.};
      if (kind == SlipOperatorKind::galerkin)
        return {dim == 2 ? 1.6 : 0.8, 1.};
      if (!edge_law_holds(scene))
        return {dim == 2 ? 0.5 : 0.65, 1.};
      if (kind == SlipOperatorKind::upwind_2)
        return {dim == 2 ? 0.4 : 0.65, 1.};
      if (dim == 2)
        return {2.3, 2.};
      return steady.problem.loads.creepages.spin == 0. ? Bound{1.3, 2.}
                                                       : Bound{0.9, 1.5};
    }



    /** Replaces a smaller error of the same quantity. */
    void
    keep_largest(const ErrorStatement &error, RunReport &report)
    {
      const auto known = std::find_if(report.errors.begin(),
                                      report.errors.end(),
                                      [&](const ErrorStatement &other) {
                                        return other.quantity == error.quantity;
                                      });
      if (known == report.errors.end())
        report.errors.push_back(error);
      else if (error.value > known->value)
        *known = error;
    }



    template <int dim>
    ErrorStatement
    estimated_force_error(const SceneParameters  &scene,
                          const SteadyState<dim> &steady)
    {
      // along a creep curve the levels were those of its first state
      if (steady.limit &&
          steady.problem.loads.creepages == scene.contact.creepages)
        return {"force",
                steady.limit->value_error,
                "mu N",
                "extrapolated over the levels",
                true,
                ""};
      const ResolutionEstimate estimate = resolution_estimate(scene, steady);
      return {"force", estimate.error, "mu N", estimate.text, true, ""};
    }



    /**
     * Against Carter where he holds, else estimated.
     */
    template <int dim>
    ErrorStatement
    force_error(const SceneParameters &scene, const SteadyState<dim> &steady)
    {
      if constexpr (dim == 2)
        if (follows_carter(scene, steady))
          {
            const Reference2D reference = reference_2d(scene, steady);
            return {"force",
                    std::abs(errors_2d(scene, steady, reference).force),
                    "mu N",
                    "Carter",
                    false,
                    ""};
          }
      return estimated_force_error(scene, steady);
    }
  } // namespace



  template <int dim>
  ResolutionEstimate
  resolution_estimate(const SceneParameters  &scene,
                      const SteadyState<dim> &steady)
  {
    const Bound  bound = measured_bound(scene, steady);
    const double n =
      steady.result.half_width_x > 0.
        ? 2 * steady.result.half_width_x / steady.grading.element_size_x
        : steady.grading.elements_across();
    ResolutionEstimate estimate;
    estimate.error = std::min(1., bound.constant / std::pow(n, bound.order));
    estimate.text =
      significant(bound.constant, 2) + "/n" +
      (bound.order > 1. ? "^" + significant(bound.order, 2) : "") +
      ", n = " + significant(n, 2) + " elements across the patch";
    return estimate;
  }



  template <int dim>
  void
  note_error(const SceneParameters  &scene,
             const SteadyState<dim> &steady,
             RunReport              &report)
  {
    if (steady.result.normal_force <= 0.)
      return;
    const bool        friction = steady.problem.n_tangential() > 0;
    const StateErrors errors   = state_errors<dim>(scene, steady, nullptr);
    if (friction)
      keep_largest(force_error(scene, steady), report);
    if (errors.load)
      keep_largest({"load",
                    std::abs(*errors.load),
                    "N",
                    "the exact clamped discs",
                    false,
                    ""},
                   report);
    if (dim == 3 || (!friction && !errors.load))
      keep_largest({"pressure", errors.pressure_l2, "p0", "Hertz", false, "L2"},
                   report);
  }



  template <int dim>
  void
  note_error_of_step(const SceneParameters  &scene,
                     const SteadyState<dim> &steady,
                     RunReport              &report)
  {
    if (steady.problem.n_tangential() == 0)
      {
        const double unknown = std::numeric_limits<double>::quiet_NaN();
        report.errors.push_back(
          {"load", unknown, "N", "neither mesh nor time step", true, ""});
        return;
      }
    const ResolutionEstimate estimate = resolution_estimate(scene, steady);
    report.errors.push_back({"force",
                             estimate.error,
                             "mu N",
                             estimate.text,
                             true,
                             "time step not estimated"});
  }



  template ResolutionEstimate
  resolution_estimate(const SceneParameters &, const SteadyState<2> &);
  template ResolutionEstimate
  resolution_estimate(const SceneParameters &, const SteadyState<3> &);
  template void
  note_error(const SceneParameters &, const SteadyState<2> &, RunReport &);
  template void
  note_error(const SceneParameters &, const SteadyState<3> &, RunReport &);
  template void
  note_error_of_step(const SceneParameters &,
                     const SteadyState<2> &,
                     RunReport &);
  template void
  note_error_of_step(const SceneParameters &,
                     const SteadyState<3> &,
                     RunReport &);
} // namespace RollingContact
