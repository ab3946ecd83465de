#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/results/bodies_report.h>
#include <rolling_contact/results/interface_fields.h>
#include <rolling_contact/results/lines_across.h>
#include <rolling_contact/results/profile_plot.h>
#include <rolling_contact/scene/scene_parameters.h>
#include <rolling_contact/state/estimate_errors.h>
#include <rolling_contact/wheelset/found_place.h>
#include <rolling_contact/wheelset/wheelset_analysis.h>

#include <cmath>

namespace RollingContact
{
  namespace
  {
    /// m, between shifts at which other equilibria are looked for
    const double search_step = 5e-4, search_range = 8e-3;
  } // namespace

  WheelsetAnalysis::WheelsetAnalysis(const Situation &scene,
                                     RunContext      &context)
    : scene(scene)
    , context(context)
    , is_mirrored(scene.inputs->own<WheelsetParameters>().goes_to_the_left())
    , wheelset(is_mirrored ? scene.inputs->own<WheelsetParameters>().mirrored()
                           : scene.inputs->own<WheelsetParameters>())
    , rough(scene, wheelset, true)
    , fine(scene, wheelset, false)
    , rough_balance(rough, wheelset)
    , fine_balance(fine, wheelset)
    , report(scene, scene.inputs->own<WheelsetParameters>(), context)
  {
    if (is_mirrored)
      for (WheelPair *pair : {&rough, &fine})
        pair->swap_sides();
  }

  void WheelsetAnalysis::run()
  {
    PhaseTimer::Scope            phase(context.timer, Phase::contact_solve);
    CurveWalk                    walk(rough_balance);
    const std::vector<CurveCase> cases = wheelset.cases();
    walk.begin();
    for (std::size_t k = 0; k < cases.size(); ++k)
      {
        walk.go_to(cases[k]);
        FoundEquilibrium found = refined(rough_balance.now());
        if (k + 1 == cases.size() && wheelset.searches && !wheelset.shift &&
            !wheelset.yaw)
          search_another(found);
        finish(found);
        report.add(found);
        write_fields(found, k, cases.size());
        if (k == 0)
          describe_bodies(found.steady[0], context);
      }
    report.finish();
  }

  FoundEquilibrium WheelsetAnalysis::refined(const WheelsetState &walked)
  {
    fine_balance.begin_with(walked, rough_balance.derivatives());
    if (!fine_balance.solve(walked.acting, walked) &&
        !fine_balance.bracket(walked.acting, walked, 1e-3))
      throw ConvergenceError(
        "Wheelset: the equilibrium at a shift of " +
        millimetres(walked.place.shift, 5) +
        " is lost on meshes of its own patches: " + fine_balance.reason + '.');
    fine_balance.polish();
    FoundEquilibrium found;
    found.state       = fine_balance.now();
    const bool hunts  = wheelset.hunting.mass > 0.;
    found.derivatives = fine_balance.motion_derivatives(hunts);
    if (hunts && !found.derivatives)
      throw ConvergenceError(
        "Wheelset/Mass: no states beside the equilibrium were found: " +
        fine_balance.reason + '.');
    if (hunts)
      found.hunting.emplace(wheelset.hunting,
                            *found.derivatives,
                            wheelset.axle_load,
                            fine.radius());
    return found;
  }

  void WheelsetAnalysis::search_another(FoundEquilibrium &found)
  {
    const WheelsetState here = rough_balance.now();
    for (const double direction : {-1., 1.})
      {
        WheelsetState last = here;
        for (double away = search_step; away <= search_range;
             away += search_step)
          {
            const double shift = here.place.shift + direction * away;
            const auto next = rough_balance.at_shift(here.acting, shift, last);
            if (!next)
              break;
            // pushed on here and back there: stable. In the first step the
            // forces are those of the equilibrium that is known
            const bool passed = away > search_step &&
                                last.residual[0] * direction > 0. &&
                                next->residual[0] * direction < 0.;
            if (passed && rough_balance.bracket(here.acting, last, 1e-3))
              {
                found.another = rough_balance.now();
                rough_balance.begin_with(here);
                return;
              }
            last = *next;
          }
      }
    rough_balance.begin_with(here);
  }

  void WheelsetAnalysis::finish(FoundEquilibrium &found)
  {
    found.n_steps = rough_balance.n_steps + fine_balance.n_steps;
    if (is_mirrored)
      {
        found.state = found.state.mirrored();
        if (found.another)
          found.another = found.another->mirrored();
        fine.swap_sides();
      }
    const WheelsetState &state = found.state;
    found.roll                 = fine.roll(state.place);
    for (unsigned int wheel = 0; wheel < 2; ++wheel)
      {
        found.scenes[wheel].emplace(fine.scene_of(wheel,
                                                  state.place,
                                                  state.acting.curvature,
                                                  state.wheels[wheel].load));
        SteadyState<3> &steady =
          fine.state_in_track(wheel, *found.scenes[wheel]);
        estimate_errors(*found.scenes[wheel], steady);
        found.steady[wheel] = steady;
      }
    if (is_mirrored)
      fine.swap_sides();
    found.find_bounds(wheelset.axle_load, fine.half_base(), fine.radius());
    context.log.detail(
      "Equilibrium: " + std::to_string(rough.n_states) + " states on " +
      std::to_string(rough.n_bodies()) + " sets of rough bodies, " +
      std::to_string(fine.n_states) + " on " + std::to_string(fine.n_bodies()) +
      " sets of those of the scene.");
    found.n_states = rough.n_states + fine.n_states;
    found.n_bodies = rough.n_bodies() + fine.n_bodies();
  }

  void WheelsetAnalysis::write_fields(const FoundEquilibrium &found,
                                      const std::size_t       number,
                                      const std::size_t       of)
  {
    const std::string names[] = {"right", "left"};
    for (unsigned int wheel = 0; wheel < 2; ++wheel)
      {
        const std::string name =
          names[wheel] + (of > 1 ? '_' + std::to_string(number + 1) : "");
        const PairSpec       &of_wheel = *found.scenes[wheel];
        const SteadyState<3> &steady   = found.steady[wheel];
        if (scene.inputs->output.interface_fields)
          write_interface(of_wheel,
                          steady,
                          context.folder,
                          "interface_" + name + ".vtu");
        write_lines_across(of_wheel,
                           steady,
                           context,
                           "across_" + name + ".csv");
        if (scene.inputs->output.plot)
          plot_profiles(of_wheel, steady, context, "profiles_" + name);
      }
  }

  namespace
  {
    std::unique_ptr<Analysis> make_wheelset(const Situation &scene,
                                            RunContext      &context)
    {
      return std::make_unique<WheelsetAnalysis>(scene, context);
    }
  } // namespace

  AnalysisKind wheelset_kind()
  {
    AnalysisKind kind;
    kind.name = "wheelset";
    kind.help =
      "where a wheelset runs in balance, on straight track and in curves, see "
      "section Wheelset";
    kind.in_2d = kind.in_3d = &make_wheelset;
    kind.sections           = {"Wheelset"};
    kind.own_section.emplace(WheelsetParameters());
    kind.on_ranks    = false;
    kind.finds_place = true;
    kind.rules       = rules_of_wheelsets();
    return kind;
  }
} // namespace RollingContact
