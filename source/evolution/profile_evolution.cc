#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/files.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/ranks.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/evolution/profile_evolution.h>
#include <rolling_contact/scene/known_entries.h>
#include <rolling_contact/wheelset/found_place.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /// depth of the first step over the tolerance of its error
    const double first_depth = 4.;

    /// of the error over the tolerance, beyond which a step is taken again
    const double too_far = 4.;

    const double safety = 0.9, most_growth = 2., least_growth = 0.25;

    /// of the way: shorter steps end the evolution
    const double least_share = 1e-5;

    /// what is left of the way over that of a step, which is taken with it
    const double remainder = 1.01;

    RunningSurfaces surfaces_of(const Situation           &scene,
                                const EvolutionParameters &section)
    {
      const WheelsetParameters &wheelset =
        scene.inputs->own<WheelsetParameters>();
      const auto             &folder = scene.inputs->prm_folder;
      const ProfileParameters left   = wheelset.left_profiles(scene.profiles);
      std::vector<RunningSurfaces::Side> sides{
        {{scene.profiles.wheel(folder), scene.profiles.rail(folder)}}};
      if (!section.both_directions)
        sides.push_back({{left.wheel(folder), left.rail(folder)}});
      const double radius = scene.wheel.radius;
      return RunningSurfaces(sides,
                             {{radius,
                               wheelset.left_wheel_radius.value_or(radius)}},
                             scene.profiles.tape_circle());
    }
  } // namespace

  ProfileEvolution::ProfileEvolution(const Situation &scene,
                                     RunContext      &context)
    : scene(scene)
    , section(scene.inputs->own<EvolutionParameters>())
    , context(context)
    , duty(read_duty(scene))
    , surfaces(surfaces_of(scene, section))
    , step(section, duty)
    , report(scene, section, duty, surfaces, context)
  {}

  std::string ProfileEvolution::place() const
  {
    return "after " + section.text_of_way(now.share);
  }

  double ProfileEvolution::first_share(const DutyStates &states) const
  {
    if (section.equal_steps > 0)
      return 1. / section.equal_steps;
    const double depth =
      surfaces.largest_depth(step.worn_at_once(surfaces, states, 1.));
    if (!(depth > 0.))
      return 1.;
    return std::min({1.,
                     first_depth * section.tolerance / depth,
                     section.largest_step / depth});
  }

  void ProfileEvolution::take_step(DutyStates &states, double &share)
  {
    for (;;)
      {
        throw_if_interrupted();
        std::string why;
        try
          {
            WearStep::Found found   = step.find(surfaces, states, share);
            const bool      will_do = section.equal_steps > 0 ||
                                 (found.error <= too_far * section.tolerance &&
                                  found.depth <= 1.5 * section.largest_step);
            if (will_do)
              {
                RunningSurfaces next         = surfaces.worn(found.amounts);
                DutyStates      states_there = step.stand_on(next);
                surfaces                     = std::move(next);
                states                       = std::move(states_there);
                const double there           = now.share + share;
                now                          = {now.step + 1,
                       there > 1. - 1e-12 ? 1. : there,
                                                found.error,
                                                found.depth};
                return;
              }
            why = "it would be off by " + millimetres(found.error, 3);
          }
        catch (const ConvergenceError &error)
          {
            why = error.what();
          }
        catch (const InputError &error)
          {
            why = error.what();
          }
        share /= 2;
        if (section.equal_steps > 0 || share < least_share)
          throw ConvergenceError("The evolution of profiles ends " + place() +
                                 ", because no further step succeeds: " + why);
        context.log.detail("A shorter step is tried, because " + why);
      }
  }

  std::string ProfileEvolution::limit_reached() const
  {
    const std::vector<WornSide> lost = report.worn(surfaces);
    for (const WornSide &side : lost)
      {
        for (const BodyWear &body : side.bodies)
          if (section.largest_depth && body.depth >= *section.largest_depth)
            return "Evolution/Largest depth is reached " + place();
        if (!side.flange)
          {
            if (section.wears_wheel() &&
                (section.least_thickness || section.largest_height ||
                 section.least_qr))
              return "the wheel has no flange to be measured " + place();
            continue;
          }
        if (section.least_thickness &&
            side.flange->thickness <= *section.least_thickness)
          return "Evolution/Least flange thickness is reached " + place();
        if (section.largest_height &&
            side.flange->height >= *section.largest_height)
          return "Evolution/Largest flange height is reached " + place();
        if (section.least_qr && side.flange->qr <= *section.least_qr)
          return "Evolution/Least qR is reached " + place();
      }
    return "";
  }

  std::string ProfileEvolution::march(DutyStates &states)
  {
    std::string limit = limit_reached();
    while (now.share < 1. && limit.empty())
      {
        if (now.share + remainder * next_share >= 1.)
          next_share = 1. - now.share;
        take_step(states, next_share);
        report.add(now, surfaces, states);
        context.log.message(
          "Step " + std::to_string(now.step) + ", " + place() + ": it wears " +
          millimetres(now.depth, 3) + ", off by " + millimetres(now.error, 2) +
          " before extrapolation.");
        if (section.equal_steps == 0)
          next_share *=
            std::clamp(safety * std::min(std::sqrt(section.tolerance /
                                                   std::max(now.error, 1e-12)),
                                         section.largest_step /
                                           std::max(now.depth, 1e-12)),
                       least_growth,
                       most_growth);
        save();
        limit = limit_reached();
      }
    return limit.empty() ? "the whole way, " + place() : limit;
  }

  void ProfileEvolution::save() const
  {
    EvolutionState state;
    state.duty       = duty_text();
    state.now        = now;
    state.next_share = next_share;
    report.save(state);
    context.folder.write_atomically(evolution_state_file, text_of(state));
  }

  void ProfileEvolution::restore()
  {
    const EvolutionState state =
      read_evolution_state(context.folder.get_path() / evolution_state_file);
    if (state.duty != duty_text() || !surfaces.has_curves(state.curves.front()))
      throw InputError("Cannot resume the evolution in \"" +
                       context.folder.get_path().string() +
                       "\": Evolution/File of rows or a file of profiles has "
                       "changed since. Start it without --resume.");
    report.restore(state);
    now        = state.now;
    next_share = state.next_share;
    surfaces   = report.last_surfaces();
  }

  std::string ProfileEvolution::duty_text() const
  {
    return section.file_of_rows.empty()
             ? ""
             : read_bytes(scene.inputs->prm_folder / section.file_of_rows);
  }

  void ProfileEvolution::run()
  {
    PhaseTimer::Scope phase(context.timer, Phase::contact_solve);
    if (!Ranks::agree(duty_text()))
      throw InputError("Evolution/File of rows = " + section.file_of_rows +
                       ": the ranks read different files; put it where all "
                       "of them see one.");
    if (context.resume)
      restore();
    DutyStates states = step.stand_on(surfaces);
    if (!context.resume)
      {
        report.add(now, surfaces, states);
        next_share = first_share(states);
        save();
      }
    try
      {
        report.finish(march(states));
      }
    catch (const ConvergenceError &)
      {
        report.finish("as no step beyond was found, " + place());
        throw;
      }
    context.report.set_finding("states",
                               std::to_string(step.n_states()) + ", threads " +
                                 std::to_string(step.n_threads()));
  }

  namespace
  {
    void check_evolution(const SceneParameters &scene)
    {
      const EvolutionParameters &section = scene.own<EvolutionParameters>();
      section.check_way();
      const WheelsetParameters &wheelset = scene.own<WheelsetParameters>();
      if (section.both_directions &&
          (!wheelset.left_wheel_profile.empty() ||
           !wheelset.left_rail_profile.empty() || wheelset.left_wheel_radius))
        throw InputError(
          "Evolution/Both directions = true: both sides wear alike; leave "
          "profiles and radius of the left side empty (section Wheelset), or "
          "set it to false.");
      if (wheelset.cases().size() > 1)
        throw InputError("Wheelset/Curve radius has several values: give those "
                         "of a duty as rows of Evolution/File of rows.");
      if (section.wear_law().needs_speed(scene.wear) && !scene.contact.speed)
        throw InputError("Evolution/Law = archard asks for Contact/Speed or "
                         "Wear/Archard coefficient.");
    }
  } // namespace

  AnalysisKind profile_evolution_kind()
  {
    AnalysisKind kind = kind_of<ProfileEvolution>(
      "profile evolution",
      "how profiles of wheels and rails wear under a duty, see section "
      "Evolution");
    kind.sections = {"Wheelset", "Evolution"};
    kind.own_section.emplace(EvolutionParameters());
    kind.finds_place    = true;
    kind.wears_profiles = true;
    kind.rules          = rules_of_wheelsets();
    kind.rules.push_back(&check_evolution);
    kind.check_situation = [](const Situation &scene) { read_duty(scene); };
    kind.resumption      = [](const Situation &scene) {
      return RunFolder::Resumption{entries_free_on_resume(*scene.inputs),
                                   evolution_state_file,
                                   {},
                                   {}};
    };
    return kind;
  }
} // namespace RollingContact
