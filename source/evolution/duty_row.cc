#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/evolution/duty_row.h>
#include <rolling_contact/wheelset/curve_walk.h>

namespace RollingContact
{
  namespace
  {
    /// m, how far a shift is sought from where it was
    const double near_by = 2e-3;

    /// residuals over the axle load: that is asked for, and that will do where
    /// forces jump as an edge of a stick zone passes a node
    const double enough = 1e-4, accepted = 3e-3;

    /// nodes of contacts on the way to a balance and of those that wear: crests
    /// of worn profiles that touch alone have few lines
    const double enough_on_the_way = 300., enough_of_wear = 500.;

    /// least size of an element over that of a mesh of its own
    const double smallest_element = 0.75;
  } // namespace

  DutyRow::DutyRow(const DutyCase &row)
    : row(row)
    , is_mirrored(
        row.scene.inputs->own<WheelsetParameters>().goes_to_the_left())
    , wheelset(is_mirrored
                 ? row.scene.inputs->own<WheelsetParameters>().mirrored()
                 : row.scene.inputs->own<WheelsetParameters>())
    , gear(row.scene, wheelset, true)
    , states(nullptr, Verbosity::quiet, smallest_element)
  {
    states.tries_last   = true;
    states.most_kept    = 2 * gear.n_wheelsets();
    states.enough_nodes = enough_of_wear;
    for (unsigned int i = 0; i < gear.n_wheelsets(); ++i)
      {
        gear.balance(i).accepted = accepted;
        gear.wheels(i).limit_nodes(enough_on_the_way);
      }
  }

  void DutyRow::balance()
  {
    gear.ask_for(enough);
    const auto from_here = [&]() {
      return gear.solve(gear.now()) || gear.bracket(gear.now(), near_by);
    };
    // another place may touch by now that bodies have no nodes for
    if (has_begun && from_here() && (reaches_all() || from_here()))
      return;
    CurveWalk walk(gear);
    walk.begin();
    walk.go_to(wheelset.cases().front(), enough);
    has_begun = true;
  }

  bool DutyRow::reaches_all()
  {
    bool does = true;
    for (unsigned int i = 0; i < gear.n_wheelsets(); ++i)
      {
        const WheelsetState &state = gear.now().wheelsets[i];
        does                       = gear.wheels(i).reaches_all(state.place,
                                          state.acting.curvature,
                                          {{state.wheels[0].load,
                                                                  state.wheels[1].load}}) &&
               does;
      }
    return does;
  }

  DutyState DutyRow::stand_on(const RunningSurfaces &surfaces,
                              const Damage::WearLaw &law)
  {
    const auto refuse = [&](const std::string &why) {
      return ConvergenceError("Duty, " + row.name + ": " + why);
    };
    try
      {
        return state_on(surfaces, law);
      }
    catch (const ConvergenceError &error)
      {
        throw refuse(error.what());
      }
    catch (const InputError &error)
      {
        throw refuse(error.what());
      }
  }

  const SteadyState<3> &DutyRow::solved(const PairSpec    &scene,
                                        const unsigned int wheel,
                                        const unsigned int kind)
  {
    ++n_solved;
    const std::string bodies =
      wheel == 0 ? "wheel on rail" : "the left wheel on its rail";
    states.reaches_all(scene, kind);
    const SteadyState<3> *steady = &states.solve(scene, bodies, kind);
    if (!steady->solver.converged)
      {
        // friction jumps over the load as an edge does
        states.holds_edges = true;
        steady             = &states.solve(scene, bodies, kind);
        states.holds_edges = false;
      }
    if (!steady->solver.converged)
      throw ConvergenceError(
        shortfall(steady->solver, scene.solver.controls.tolerance));
    return *steady;
  }

  DutyState DutyRow::state_on(const RunningSurfaces &surfaces,
                              const Damage::WearLaw &law)
  {
    BothWheelsOnRails both = surfaces.wheels_on_rails();
    if (is_mirrored)
      std::swap(both[0], both[1]);
    const unsigned int n = gear.n_wheelsets();
    for (unsigned int i = 0; i < n; ++i)
      gear.wheels(i).set_profiles(both);
    balance();
    DutyState found;
    found.contacts.reserve(2 * n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int k = 0; k < 2; ++k)
        {
          const WheelsetState &state = gear.now().wheelsets[i];
          PairSpec             scene = gear.wheels(i).scene_as_right_hand(
            k, state.place, state.acting.curvature, state.wheels[k].load);
          scene.mesh            = row.scene.mesh;
          scene.mesh.compliance = Compliance::half_spaces;
          scene.wear.report     = true; // for its least number of lines
          found.contacts.emplace_back(scene,
                                      solved(scene, k, 2 * i + k),
                                      law,
                                      i,
                                      is_mirrored ? 1 - k : k,
                                      1. / (n * 2 / surfaces.n_sides()));
        }
    for (const WearingContact &contact : found.contacts)
      found.summary.wheels.push_back(contact.summary);
    const double side = is_mirrored ? -1. : 1.;
    for (const WheelsetState &state : gear.now().wheelsets)
      found.summary.wheelsets.push_back({side * state.acting.curvature,
                                         side * state.place.shift,
                                         side * state.place.yaw,
                                         state.largest_residual()});
    return found;
  }
} // namespace RollingContact
