#include <rolling_contact/analyses/load_curve.h>
#include <rolling_contact/analyses/solve_to_target.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/stopwatch.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/input/number_list.h>
#include <rolling_contact/results/bodies_report.h>
#include <rolling_contact/results/profile_columns.h>
#include <rolling_contact/results/reference_3d.h>
#include <rolling_contact/results/result_row.h>
#include <rolling_contact/results/state_report.h>
#include <rolling_contact/run/figure.h>
#include <rolling_contact/scene/entries.h>
#include <rolling_contact/state/estimate_errors.h>

#include <cmath>

namespace RollingContact
{
  namespace
  {
    const char loads_need_contact[] =
      "Analysis = load curve needs contact: check Contact/Approach and "
      "Contact/Normal load.";
  } // namespace

  namespace
  {
    /**
     * The stiffness is found with 10 % more than the largest load.
     */
    StateDemands load_curve_demands()
    {
      StateDemands demands;
      demands.growth           = 1.05;
      demands.pair.bulk_errors = true;
      return demands;
    }

    /**
     * By Hertz, half-widths go with the root of the load in 2D, with its third
     * root in 3D.
     */
    TargetDemands targets(const std::vector<double> &load_fractions,
                          const int                  dim)
    {
      TargetDemands targets;
      targets.patches.clear();
      for (const double share : load_fractions)
        targets.patches.push_back(std::pow(share, 1. / dim));
      return targets;
    }
  } // namespace

  template <int dim>
  void LoadCurve<dim>::run()
  {
    if (!bodies_touch(scene))
      throw InputError(loads_need_contact);
    SteadyState<dim> steady = solve_to_target<dim>(
      scene,
      load_curve_demands(),
      targets(scene.inputs->own<LoadCurveParameters>().load_fractions, dim),
      context,
      [](const auto &) {});
    require_solved(scene, steady, "Load curve, the largest load");
    if (steady.result.normal_force <= 0.)
      throw InputError(loads_need_contact);
    describe_bodies(steady, context);
    if (steady.problem.operators.frames().is_plane())
      steady.problem.loads.inclined_load.reset();
    const double     largest = steady.result.normal_force;
    StateReview<dim> review(scene, context);
    for (const double share :
         scene.inputs->own<LoadCurveParameters>().load_fractions)
      {
        throw_if_interrupted();
        const Stopwatch   watch;
        PhaseTimer::Scope phase(context.timer, Phase::contact_solve);
        solve_at(share * largest, steady);
        const double k           = stiffness(steady);
        steady.contact_stiffness = k;
        steady.wall_s            = watch.seconds();
        estimate_errors(scene, steady);
        add_result_row(scene, steady, context);
        review.add(steady, significant(steady.result.normal_force, 4) + " N");
        loads.push_back(steady.result.normal_force);
        approaches.push_back(steady.state.approach);
        if (dim == 3 && scene.has_plain_surfaces())
          hertz.push_back(reference_3d(scene, loads.back(), {}).hertz.approach);
      }
    review.warn(steady);
    context.log.message(context.results.screen_table({"normal_force_N",
                                                      "approach_m",
                                                      "contact_stiffness_N/m",
                                                      "half_width_x_m",
                                                      "max_pressure_Pa"}));
    note_state(steady, context.report);
    note_profiles(scene, steady, context.report);
    warn_of_missed_target(scene, context);
    context.report.set_finding("spring",
                               "k = " +
                                 significant(*steady.contact_stiffness, 5) +
                                 " N/m under the last load");
    if (scene.inputs->output.plot)
      plot();
  }

  template <int dim>
  void LoadCurve<dim>::solve_at(const double      load,
                                SteadyState<dim> &steady) const
  {
    steady.problem.loads.normal_load = load;
    if (steady.problem.loads.inclined_load)
      steady.problem.loads.inclined_load = {load, 0.};
    solve_contact(scene, load_curve_demands(), steady);
    steady.result = resultants(steady.problem, steady.state);
    require_solved(scene, steady, "Load curve, " + significant(load, 6) + " N");
  }

  template <int dim>
  double LoadCurve<dim>::stiffness(SteadyState<dim> &steady) const
  {
    const double load = steady.result.normal_force, change = 0.1;
    const auto   given  = steady.problem.loads;
    const auto   solver = steady.solver;
    const auto   state  = steady.state;
    solve_at((1 + change) * load, steady);
    const double above = steady.state.approach;
    solve_at((1 - change) * load, steady);
    const double below   = steady.state.approach;
    steady.problem.loads = given;
    steady.state         = state;
    steady.solver        = solver;
    steady.result        = resultants(steady.problem, state);
    return 2 * change * load / (above - below);
  }

  template <int dim>
  void LoadCurve<dim>::plot() const
  {
    const auto scaled = [](std::vector<double> values, const double factor) {
      for (double &value : values)
        value *= factor;
      return values;
    };
    Figure figure("Load curve", "approach (\u00b5m)", "load (kN)");
    figure.add_curve("finite elements",
                     scaled(approaches, 1e6),
                     scaled(loads, 1e-3),
                     CurveStyle::line_and_points);
    if (!hertz.empty())
      figure.add_curve("Hertz, without bulk",
                       scaled(hertz, 1e6),
                       scaled(loads, 1e-3),
                       CurveStyle::reference);
    figure.draw(context, "load_curve");
  }

  template class LoadCurve<2>;
  template class LoadCurve<3>;

  void LoadCurveParameters::declare(Entries &entries)
  {
    entries.section("Load curve").read_by_analyses("load curve");
    entries.list("Shares of load", load_fractions, "0.1 : 1 : 10", "1").help =
      "Loads, divided by the load of section Contact for which the mesh is "
      "made: " +
      std::string(number_list_form) + ".";
  }

  void LoadCurveParameters::check() const
  {
    for (const double fraction : load_fractions)
      if (!(fraction > 0. && fraction <= 1.))
        throw InputError("Load curve/Shares of load contains " +
                         significant(fraction, 15) +
                         ": give shares above 0 and at most 1.");
  }

  AnalysisKind load_curve_kind()
  {
    AnalysisKind kind = kind_of<LoadCurve>(
      "load curve",
      "approach and contact stiffness under many loads, see section Load "
      "curve");
    kind.sections = {"Load curve"};
    kind.own_section.emplace(LoadCurveParameters());
    return kind;
  }
} // namespace RollingContact
