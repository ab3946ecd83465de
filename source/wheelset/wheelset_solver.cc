#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/scene/scene_parameters.h>
#include <rolling_contact/state/estimate_errors.h>
#include <rolling_contact/wheelset/wheelset_solver.h>

namespace RollingContact
{
  namespace
  {
    /// m, between shifts at which other equilibria are looked for
    const double search_step = 5e-4, search_range = 8e-3;

    /// residual with which the bodies of the scene begin
    const double closed_on_the_way = 1e-4;
  } // namespace

  WheelsetSolver::WheelsetSolver(const Situation &scene)
    : is_mirrored(scene.inputs->own<WheelsetParameters>().goes_to_the_left())
    , wheelset(is_mirrored ? scene.inputs->own<WheelsetParameters>().mirrored()
                           : scene.inputs->own<WheelsetParameters>())
    , cases(wheelset.cases())
    , radius(scene.wheel.radius)
    , rough(scene, wheelset, true)
    , fine(scene, wheelset, false)
    , walk(rough)
  {
    if (is_mirrored)
      for (RunningGear *gear : {&rough, &fine})
        gear->swap_sides();
  }

  std::vector<FoundEquilibrium> WheelsetSolver::next()
  {
    if (n_found == 0)
      walk.begin();
    walk.go_to(cases.at(n_found++), closed_on_the_way);
    std::vector<FoundEquilibrium> found = refined(rough.now());
    if (n_found == cases.size() && wheelset.searches && !wheelset.shift &&
        !wheelset.yaw && !wheelset.is_bogie)
      search_another(found[0]);
    finish(found);
    return found;
  }

  std::vector<FoundEquilibrium>
  WheelsetSolver::refined(const RunningState &walked)
  {
    fine.begin_with(walked, &rough);
    if (!fine.solve(walked) && !fine.bracket(walked, 1e-3))
      throw ConvergenceError(
        "Wheelset: the equilibrium at a shift of " +
        millimetres(walked.wheelsets[0].place.shift, 5) +
        " is lost on meshes of its own patches: " + fine.reason + '.');
    fine.polish();
    std::vector<FoundEquilibrium> found(fine.n_wheelsets());
    for (unsigned int i = 0; i < found.size(); ++i)
      {
        found[i].name       = wheelset.name_of(i);
        found[i].state      = fine.now().wheelsets[i];
        found[i].frame      = fine.now().frame;
        found[i].frame_left = fine.now().frame_left;
        found[i].derivatives =
          fine.balance(i).motion_derivatives(wheelset.hunting.mass > 0.);
      }
    hunt(found);
    return found;
  }

  void WheelsetSolver::hunt(std::vector<FoundEquilibrium> &found) const
  {
    if (wheelset.hunting.mass == 0.)
      return;
    std::vector<Hunting::Derivatives> derivatives;
    for (const FoundEquilibrium &one : found)
      if (one.derivatives)
        derivatives.push_back(*one.derivatives);
      else
        throw ConvergenceError(
          "Wheelset/Mass: no states beside the equilibrium were found.");
    found[0].hunting.emplace(wheelset, derivatives, radius);
  }

  void WheelsetSolver::search_another(FoundEquilibrium &found)
  {
    Equilibrium        &balance = rough.balance(0);
    const WheelsetState here    = balance.now();
    rough.ask_for(Equilibrium::tolerance);
    for (const double direction : {-1., 1.})
      {
        WheelsetState last = here;
        for (double away = search_step; away <= search_range;
             away += search_step)
          {
            const double shift = here.place.shift + direction * away;
            const auto   next  = balance.at_shift(here.acting, shift, last);
            if (!next)
              break;
            // pushed on here and back there: stable. In the first step the
            // forces are those of the equilibrium that is known
            const bool passed = away > search_step &&
                                last.residual[0] * direction > 0. &&
                                next->residual[0] * direction < 0.;
            if (passed && balance.bracket(here.acting, last, 1e-3))
              {
                found.another = balance.now();
                balance.begin_with(here);
                return;
              }
            last = *next;
          }
      }
    balance.begin_with(here);
  }

  void WheelsetSolver::finish(std::vector<FoundEquilibrium> &found)
  {
    for (FoundEquilibrium &one : found)
      {
        one.n_steps  = rough.n_steps() + fine.n_steps();
        one.n_states = rough.n_states() + fine.n_states();
        one.n_bodies = rough.n_bodies() + fine.n_bodies();
        if (!is_mirrored)
          continue;
        one.state = one.state.mirrored();
        one.frame = -one.frame;
        if (one.another)
          one.another = one.another->mirrored();
      }
    if (is_mirrored)
      fine.swap_sides();
    for (unsigned int i = 0; i < found.size(); ++i)
      finish_wheels(found[i], fine.wheels(i));
    if (is_mirrored)
      fine.swap_sides();
    find_bounds(found);
  }

  void WheelsetSolver::finish_wheels(FoundEquilibrium &found,
                                     WheelPair        &pair) const
  {
    const WheelsetState &state = found.state;
    found.roll                 = pair.roll(state.place);
    for (unsigned int wheel = 0; wheel < 2; ++wheel)
      {
        found.scenes[wheel].emplace(pair.scene_of(wheel,
                                                  state.place,
                                                  state.acting.curvature,
                                                  state.wheels[wheel].load));
        SteadyState<3> &steady =
          pair.state_in_track(wheel, *found.scenes[wheel]);
        estimate_errors(*found.scenes[wheel], steady);
        found.steady[wheel] = steady;
      }
  }

  void WheelsetSolver::find_bounds(std::vector<FoundEquilibrium> &found) const
  {
    std::vector<Eigen::Matrix3d> derivatives;
    Eigen::VectorXd              of_balances(3 * found.size());
    for (unsigned int i = 0; i < found.size(); ++i)
      {
        const auto bounds =
          found[i].bounds_of_balances(wheelset.axle_load,
                                      fine.wheels(i).half_base(),
                                      radius);
        if (!bounds || !found[i].derivatives)
          return;
        of_balances.segment<3>(3 * i) = *bounds;
        derivatives.push_back(found[i].derivatives->leftCols<3>());
      }
    const auto compliance = fine.compliance(derivatives);
    if (!compliance)
      return;
    const Eigen::VectorXd of_places = compliance->cwiseAbs() * of_balances;
    for (unsigned int i = 0; i < found.size(); ++i)
      found[i].bounds = of_places.segment<3>(3 * i);
  }
} // namespace RollingContact
