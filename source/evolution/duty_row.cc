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

    /** The state; where friction jumps over the load, with edges held. */
    const SteadyState<3> &solved(const PairSpec    &scene,
                                 const std::string &bodies,
                                 const unsigned int kind,
                                 KeptStates<3>     &states)
    {
      const SteadyState<3> *steady = &states.solve(scene, bodies, kind);
      if (!steady->solver.converged)
        {
          states.holds_edges = true;
          steady             = &states.solve(scene, bodies, kind);
          states.holds_edges = false;
        }
      if (!steady->solver.converged)
        throw ConvergenceError(
          shortfall(steady->solver, scene.solver.controls.tolerance));
      return *steady;
    }
  } // namespace

  DutyRow::DutyRow(const DutyCase &row)
    : row(row)
    , is_mirrored(
        row.scene.inputs->own<WheelsetParameters>().goes_to_the_left())
    , wheelset(is_mirrored
                 ? row.scene.inputs->own<WheelsetParameters>().mirrored()
                 : row.scene.inputs->own<WheelsetParameters>())
    , gear(row.scene, wheelset, true)
  {
    for (unsigned int i = 0; i < gear.n_wheelsets(); ++i)
      gear.balance(i).accepted = accepted;
  }

  void DutyRow::balance()
  {
    gear.ask_for(enough);
    if (has_begun &&
        (gear.solve(gear.now()) || gear.bracket(gear.now(), near_by)))
      return;
    CurveWalk walk(gear);
    walk.begin();
    walk.go_to(wheelset.cases().front(), enough);
    has_begun = true;
  }

  DutyState DutyRow::stand_on(const RunningSurfaces &surfaces,
                              const Damage::WearLaw &law,
                              KeptStates<3>         &states,
                              const unsigned int     first_kind)
  {
    BothWheelsOnRails both = surfaces.wheels_on_rails();
    if (is_mirrored)
      std::swap(both[0], both[1]);
    const unsigned int n = gear.n_wheelsets();
    for (unsigned int i = 0; i < n; ++i)
      gear.wheels(i).set_profiles(both);
    balance();
    DutyState    found{gear.now(), {}};
    unsigned int kind = first_kind;
    found.contacts.reserve(n_contacts());
    for (unsigned int i = 0; i < n; ++i)
      {
        const WheelsetState &state = gear.now().wheelsets[i];
        for (unsigned int k = 0; k < 2; ++k)
          {
            PairSpec scene = gear.wheels(i).scene_as_right_hand(
              k, state.place, state.acting.curvature, state.wheels[k].load);
            scene.mesh            = row.scene.mesh;
            scene.mesh.compliance = Compliance::half_spaces;
            scene.wear.report     = true;
            found.contacts.emplace_back(scene,
                                        solved(scene,
                                               k == 0 ? "wheel on rail"
                                                      : "left wheel on rail",
                                               kind++,
                                               states),
                                        law,
                                        i,
                                        is_mirrored ? 1 - k : k,
                                        1. / (n * 2 / surfaces.n_sides()));
          }
      }
    if (is_mirrored)
      for (WheelsetState &state : found.running.wheelsets)
        state = state.mirrored();
    return found;
  }
} // namespace RollingContact
