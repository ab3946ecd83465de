#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/vector.hpp>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/fmu/bytes.h>
#include <rolling_contact/results/error_bounds.h>
#include <rolling_contact/state/estimate_errors.h>
#include <rolling_contact/state/state_finder.h>
#include <rolling_contact/wheelset/fmu_states.h>
#include <rolling_contact/wheelset/fmu_wheel.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace RollingContact
{
  namespace
  {
    const std::size_t most_kept = 4, most_patches = 8;

    std::string archived(const ContactState &state)
    {
      std::ostringstream out;
      boost::archive::binary_oarchive(out, boost::archive::no_header) << state;
      return out.str();
    }

    ContactState unarchived(const std::string &text)
    {
      std::istringstream in(text);
      ContactState       state;
      boost::archive::binary_iarchive(in, boost::archive::no_header) >> state;
      return state;
    }
  } // namespace

  FmuWheel::FmuWheel(const Situation &scene)
    : base(scene)
    , speed(scene.contact.rolling_speed())
    , profiles(fmu_profiles(scene))
    , split_bodies(std::make_shared<SplitBodies>())
  {}

  std::string FmuWheel::Recipe::bytes() const
  {
    Fmu::BytesOut out;
    out.add(asked.numbers());
    out.add(static_cast<double>(others.size()));
    for (const ZoneBox &box : others)
      {
        out.add(box.lower);
        out.add(box.upper);
      }
    return out.all();
  }

  FmuWheel::Recipe FmuWheel::Recipe::of_bytes(const std::string &bytes)
  {
    Fmu::BytesIn in(bytes);
    Recipe       found;
    found.asked = Fmu::WheelQuestion::of_numbers(
      in.numbers<Fmu::WheelQuestion::n_numbers>());
    for (std::size_t n = in.size(most_patches); n > 0; --n)
      {
        const auto lower = in.numbers<2>();
        found.others.push_back({lower, in.numbers<2>()});
      }
    return found;
  }

  Profiles::WheelsetPosition
  FmuWheel::place_of(const Fmu::WheelQuestion &asked) const
  {
    const double rest = Profiles::resting_roll(*profiles,
                                               *profiles,
                                               {{asked.on_own, asked.on_other}},
                                               asked.yaw);
    return {asked.on_own,
            rest + asked.rail_down / (2 * profiles->tape_circle_place()),
            asked.yaw};
  }

  PairSpec FmuWheel::scene_of(const Fmu::WheelQuestion         &asked,
                              const Profiles::WheelsetPosition &place) const
  {
    PairSpec scene       = base;
    scene.profiles.shift = place.shift;
    scene.profiles.roll  = place.roll;
    scene.profiles.yaw   = place.yaw;
    scene.frame          = std::make_shared<const Profiles::ContactFrame>(
      profiles, place, false, Profiles::SurfaceKind::curved);
    scene.motion                       = {speed,
                                          asked.motion.about_axle * speed,
                                          asked.motion.turn,
                                          asked.motion.aside * speed};
    scene.contact.vertical_load        = asked.load;
    scene.contact.friction_coefficient = asked.friction;
    scene.take_frame_loads();
    return scene;
  }

  bool FmuWheel::solve_from(const PairSpec     &scene,
                            const ContactState &start,
                            const bool          holds,
                            Kept               &kept)
  {
    kept.steady.state            = start;
    kept.steady.solver.converged = true; // as a start
    return kept.solve_from_here(scene, holds);
  }

  bool FmuWheel::is_found(const PairSpec     &scene,
                          const ContactState &start,
                          Kept               &kept) const
  {
    if (start.pressure.size() != kept.steady.problem.n_nodes())
      throw InputError("What is remembered of the last state is not of this "
                       "scene.");
    // with held edges where these jump with the load
    if (!solve_from(scene, start, false, kept) &&
        !solve_from(scene, start, true, kept))
      {
        const WantedMesh wanted = wanted_mesh(scene);
        if (!kept.suits(wanted, smallest_patch) || !kept.reaches(wanted))
          return false;
        solve_from(scene,
                   initial_state(kept.steady.problem, wanted.patch),
                   false,
                   kept);
      }
    return kept.serves(scene, smallest_patch);
  }

  FmuWheel::Kept FmuWheel::made(const Recipe &recipe)
  {
    const PairSpec   scene  = scene_of(recipe.asked, place_of(recipe.asked));
    const WantedMesh wanted = wanted_mesh(scene);
    ++n_made;
    Kept            found{KeptBodies<3>::made_for(
                 scene, wanted, recipe.others, split_bodies, context.run),
               recipe.bytes()};
    SteadyState<3> &steady = found.steady;
    if (!steady.solver.converged)
      {
        const ContactState start = steady.state;
        if (!solve_from(scene, start, true, found))
          found.failure =
            shortfall(steady.solver, scene.solver.controls.tolerance);
      }
    found.made  = found.elements_across();
    found.first = steady.state;
    if (found.patches.size() > most_patches)
      found.patches.resize(most_patches);
    return found;
  }

  FmuWheel::Kept &FmuWheel::bodies_of(const Recipe &recipe)
  {
    const std::string name = recipe.bytes();
    const auto        at =
      std::find_if(kept.begin(), kept.end(), [&](const Kept &one) {
        return one.recipe == name;
      });
    if (at != kept.end())
      kept.splice(kept.begin(), kept, at);
    else
      {
        if (kept.size() >= most_kept)
          kept.pop_back();
        kept.push_front(made(recipe));
      }
    return kept.front();
  }

  Fmu::WheelAnswer FmuWheel::told(const PairSpec &scene, Kept &kept) const
  {
    SteadyState<3> &steady = kept.steady;
    estimate_errors(scene, steady);
    const ErrorBounds bounds = error_bounds(scene, steady);
    SolvedWheel       state;
    state.forces       = track_forces(scene, steady.problem, steady.state);
    state.normal_force = steady.result.normal_force;
    state.max_pressure = steady.result.max_pressure;
    state.creep_work   = steady.result.creep_work;
    state.force_bound  = bounds.force
                           ? *bounds.force * scene.contact.friction_coefficient *
                              state.normal_force
                           : std::numeric_limits<double>::max();
    Fmu::WheelAnswer found;
    found.roll = *scene.profiles.roll;
    found.values =
      quantities_of(state,
                    *profiles,
                    {scene.profiles.shift, found.roll, scene.profiles.yaw});
    Fmu::BytesOut memory;
    memory.add(kept.recipe);
    memory.add(archived(steady.state));
    found.memory = memory.all();
    return found;
  }

  Fmu::WheelAnswer FmuWheel::answer(const Fmu::WheelQuestion &asked,
                                    const std::string        &memory)
  {
    const Profiles::WheelsetPosition place = place_of(asked);
    if (asked.load <= 0.)
      return {place.roll, {}, memory};
    const PairSpec scene = scene_of(asked, place);
    Recipe         recipe{asked, {}};
    if (!memory.empty())
      {
        Fmu::BytesIn      in(memory);
        const std::string last = in.text();
        Kept             &kept = bodies_of(Recipe::of_bytes(last));
        if (is_found(scene, unarchived(in.text()), kept))
          return told(scene, kept);
        // where patches were others may come again
        if (kept.suits(wanted_mesh(scene), smallest_patch))
          recipe.others = kept.patches;
      }
    Kept &kept = bodies_of(recipe);
    if (!kept.failure.empty())
      throw ConvergenceError(kept.failure);
    if (!solve_from(scene, kept.first, false, kept) &&
        !solve_from(scene, kept.first, true, kept))
      throw ConvergenceError(
        shortfall(kept.steady.solver, scene.solver.controls.tolerance));
    return told(scene, kept);
  }
} // namespace RollingContact
