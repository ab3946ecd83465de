#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/input/number_list.h>
#include <rolling_contact/scene/entries.h>
#include <rolling_contact/scene/profile_parameters.h>
#include <rolling_contact/scene/scene_parameters.h>
#include <rolling_contact/surfaces/nominal_profiles.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace RollingContact
{
  namespace
  {
    using Mirror = ProfileParameters::Mirror;

    const std::vector<NamedValue<Mirror>> named_mirrors{{"none", Mirror::none},
                                                        {"y", Mirror::y},
                                                        {"z", Mirror::z},
                                                        {"y and z",
                                                         Mirror::y_and_z}};

    const Reader wheelsets_in_a_place{
      asks<AnalysisTraits>(
        [](const auto &analysis) { return analysis.has_bodies; }),
      "a contact table has both sides, its own shifts, no creepages and no "
      "bodies"};
    const Reader places_that_are_given{
      &place_is_given,
      "place and motion of a wheelset are found, see section Wheelset"};
    const Reader wheel_files{asks<ProfileParameters>([](const auto &profiles) {
                               return profiles.wheel_is_file();
                             }),
                             "Profiles/Wheel profile is no file"};
    const Reader profile_files{
      asks<ProfileParameters>(
        [](const auto &profiles) { return profiles.has_files(); }),
      "neither Profiles/Wheel profile nor Rail profile is a file"};

    const double flange_back_to_tape_circle = 0.07; // m

    void check_range(const std::string &entry,
                     const double       value,
                     const double       least,
                     const double       most,
                     const std::string &unit)
    {
      if (!(value >= least && value <= most))
        throw InputError("Profiles/" + entry + " = " + text_of(value) +
                         ": give it in " + unit + ", from " + text_of(least) +
                         " to " + text_of(most) + ".");
    }
  } // namespace

  void ProfileParameters::declare(Entries &entries)
  {
    EntrySection &section = entries.section("Profiles");
    section.read_by({asks<AnalysisTraits, ProfileParameters>(
                       [](const auto &analysis, const auto &profiles) {
                         return !analysis.has_bodies || profiles.in_use();
                       }),
                     "bodies with a Profiles/Wheel profile and Rail profile "
                     "read that section"});
    section.read_by({asks<AnalysisTraits, ProfileParameters>(
                       [](const auto &analysis, const auto &profiles) {
                         return analysis.has_bodies ||
                                !profiles.has_radius_difference();
                       }),
                     "a scene without Contact table/Rolling radius difference "
                     "reads that section"});
    section.varies = in_all_scenes;
    declare_sections(entries);
    declare_track(entries);
    declare_wheelset(entries);
    declare_table(entries);
  }

  void ProfileParameters::declare_table(Entries &entries)
  {
    const auto by_file = asks<ProfileParameters>(
      [](const auto &profiles) { return profiles.has_radius_difference(); });
    entries.section("Contact table").read_by_analyses("contact table");
    entries.list("Lateral shift", shifts, "-0.008 : 0.008 : 81", "m")
      .read_by({[by_file](const auto &scene) { return !by_file(scene); },
                "the shifts are those of Contact table/Rolling radius "
                "difference"})
      .help = "Lateral shift of the wheelset to the right: " +
              std::string(number_list_form) + ".";
    entries.add("Conicity amplitude", conicity_amplitude, "m")
      .at_least(0.)
      .help =
      "Amplitude of the wheelset's lateral motion for which the summary gives "
      "the conicity.";
    entries.add("Rolling radius difference", difference_file).help =
      "Name of a file beside the .prm file that takes the place of profiles. "
      "It has two columns: the shift of the wheelset to the right, ascending, "
      "and the right rolling radius less the left one. Empty: the difference "
      "is that of the profiles.";
    entries.add("File unit", difference_unit, "m")
      .at_least(0.)
      .read_by({by_file, "Contact table/Rolling radius difference is empty"})
      .help = "Length of one unit of both columns of the file of Rolling "
              "radius difference.";
  }

  void ProfileParameters::declare_sections(Entries &entries)
  {
    const std::string file =
      ", or the name of a file beside the .prm file: two columns y and z, "
      "SIMPACK .prr or .prw, MiniProf .ban or .whl.";
    entries.add("Wheel profile", wheel_profile).help =
      "`S1002` (EN 13715)" + file +
      " Its radius at the tape circle, y = 0, is Wheel/Radius. If both "
      "profiles are empty, the surfaces are those of Wheel and Rail; a "
      "contact table takes S1002 on 60E1.";
    entries.add("Rail profile", rail_profile).help =
      "`60E1`, `60E2`, `54E1`, `54E3`, `49E1` (EN 13674-1), `60E1 Manchester` "
      "(the variant of the Manchester benchmarks)" +
      file;
    entries
      .choice("Contact surface",
              surface_kind,
              std::vector<NamedValue<Profiles::SurfaceKind>>{
                {"plane", Profiles::SurfaceKind::plane},
                {"loaded plane", Profiles::SurfaceKind::loaded_plane},
                {"curved", Profiles::SurfaceKind::curved}})
      .read_by(wheelsets_in_a_place)
      .help =
      "The normals that pressure acts along. `plane`: that of the first "
      "contact; `loaded plane`: the mean normal of the patch under load, by "
      "half-spaces; `curved`: a normal of each node, between those of rail "
      "and wheel, over the length of the rail's section. Take `curved` for "
      "conformal contacts, for tread and flange at once, and for bodies that "
      "move across under a lateral force.";
    entries.add("Smoothing length", smoothing_length, "m")
      .at_least(0.)
      .read_by(profile_files)
      .help =
      "Wavelength that a smoothing spline halves in the points of a file; 0: "
      "no smoothing.";
    entries.add("File unit", file_unit, "m")
      .at_least(0.)
      .read_by(profile_files)
      .help = "Length of one unit of a file of two columns or of MiniProf.";
    for (const auto &[body, mirror] :
         {std::pair<std::string, Mirror *>("Wheel", &wheel_mirror),
          std::pair<std::string, Mirror *>("Rail", &rail_mirror)})
      entries.choice(body + " mirror", *mirror, named_mirrors)
        .read_by(profile_files)
        .help =
        "Coordinates of the file whose sign changes, so that y points to the "
        "field side of the right-hand side and z down.";
    entries.add("Wheel profile shift", wheel_profile_shift, "m")
      .read_by(wheel_files)
      .help =
      "Length added to y of a wheel's file after mirroring, so that its tape "
      "circle is at y = 0. A rail needs none, because its gauge face is its "
      "place.";
  }

  void ProfileParameters::declare_track(Entries &entries)
  {
    Entry &slope = entries.add("Rail inclination", inclination, "1");
    slope.kind   = Entry::Kind::numbers;
    slope.help =
      "Inclination of the rails towards the middle of the track, as 1/40 or "
      "1/20; 0 for a file that is inclined already.";
    entries.add("Gauge", gauge, "m").at_least(0.).help =
      "Distance between the gauge faces.";
    entries.add("Gauge height", gauge_height, "m").at_least(0.).help =
      "Depth of the gauge faces below the top of the rails.";
    entries.add("Flange back distance", flange_back_distance, "m")
      .at_least(0.)
      .help =
      "Distance between the backs of the flanges. The tape circles are 0.07 m "
      "outside of them.";
    entries.add("Yaw", yaw, "rad")
      .renewing(Renews::place)
      .read_by(places_that_are_given)
      .help =
      "Yaw of the wheelset: its turn about the vertical, right-handed about "
      "z, which points down.";
    entries
      .choice("Body sections",
              true_sections,
              std::vector<NamedValue<bool>>{{"plain", false}, {"true", true}})
      .read_by(wheelsets_in_a_place)
      .help =
      "Bodies under the profiles, if they are elastic. `plain`: the disc and "
      "the block of sections Wheel and Rail. `true`: a wheel with flange, "
      "rim, web and hub, held at its bore (Wheel/Hub radius), and a rail with "
      "head, web and foot of a 60E1, Rail/Block length long, held at its sole.";
    entries.add("Web bow", web_bow, "m")
      .read_by(wheelsets_in_a_place)
      .read_by({[](const SceneParameters &scene) {
                  return !scene.analysis.has_bodies ||
                         (scene.profiles.true_sections && !scene.wheel.rigid);
                },
                "Profiles/Body sections = true reads it, for an elastic "
                "wheel"})
      .help =
      "Distance by which the middle of the web is bowed towards the field "
      "side, for a wheel of Body sections = true.";
  }

  void ProfileParameters::declare_wheelset(Entries &entries)
  {
    entries
      .choice("Side",
              is_left,
              std::vector<NamedValue<bool>>{{"right", false}, {"left", true}})
      .read_by(wheelsets_in_a_place)
      .read_by(places_that_are_given)
      .help = "Side of the wheelset whose wheel and rail are computed.";
    entries.add("Lateral shift", shift, "m")
      .read_by(wheelsets_in_a_place)
      .read_by(places_that_are_given)
      .renewing(Renews::place)
      .help =
      "Lateral shift of the wheelset to the right. A contact table has its "
      "own.";
    entries.add_automatic("Roll", roll, "rad")
      .read_by(wheelsets_in_a_place)
      .read_by(places_that_are_given)
      .renewing(Renews::place)
      .help = "Roll of the wheelset: its turn about the direction of travel, "
              "right-handed. `automatic`: both wheels touch.";
    entries
      .choice("Creepages",
              creepage_source,
              std::vector<NamedValue<CreepageSource>>{
                {"given", CreepageSource::given},
                {"from kinematics", CreepageSource::kinematics}})
      .read_by(wheelsets_in_a_place)
      .read_by(places_that_are_given)
      .help =
      "`given`: the creepages of section Contact, or of an analysis that has "
      "its own. `from kinematics`: those at the first contact of a wheelset "
      "in this place that moves along the track with Contact/Speed. They "
      "change over the patch as the rolling radius of the profile does.";
    entries.add_automatic("Pitch rate", pitch_rate, "rad/s")
      .renewing(Renews::loads)
      .read_by(wheelsets_in_a_place)
      .read_by(places_that_are_given)
      .read_by({asks<AnalysisTraits, ProfileParameters>(
                  [](const auto &analysis, const auto &profiles) {
                    return !analysis.has_bodies || profiles.gives_creepages();
                  }),
                "Profiles/Creepages = from kinematics reads it"})
      .help =
      "Angular velocity of the axle, for creepages from kinematics; negative "
      "when the wheelset rolls forwards. `automatic`: such that there is no "
      "longitudinal creepage.";
    const Reader motion{asks<AnalysisTraits, ProfileParameters>(
                          [](const auto &analysis, const auto &profiles) {
                            return analysis.has_bodies &&
                                   profiles.gives_creepages();
                          }),
                        "Profiles/Creepages = from kinematics reads it"};
    entries.add("Curve radius", curve_radius, "m")
      .renewing(Renews::loads)
      .read_by(places_that_are_given)
      .read_by(motion)
      .help = "Curve radius of the track's middle, positive where the curve "
              "is to the right; empty: straight track.";
    entries.add("Lateral velocity", lateral_velocity, "m/s")
      .renewing(Renews::loads)
      .read_by(places_that_are_given)
      .read_by(motion)
      .help = "Velocity of the wheelset over the track, to the right.";
  }

  double ProfileParameters::slope_of_inclination() const
  {
    const std::size_t           stroke = inclination.find('/');
    const std::optional<double> value =
      stroke == std::string::npos ? number(inclination) : std::nullopt;
    if (value && std::abs(*value) <= 0.2)
      return *value;
    if (stroke != std::string::npos)
      {
        const auto above = number(inclination.substr(0, stroke)),
                   below = number(inclination.substr(stroke + 1));
        if (above && below && std::abs(*above) <= 0.2 * std::abs(*below))
          return *above / *below;
      }
    throw InputError("Profiles/Rail inclination = " + inclination +
                     ": give a slope up to 0.2, as 1/40, 0.025 or 0.");
  }

  double ProfileParameters::tape_circle() const
  {
    return flange_back_distance / 2 + flange_back_to_tape_circle;
  }

  void ProfileParameters::check(const double                 wheel_radius,
                                const std::filesystem::path &prm_folder) const
  {
    if (!(wheel_radius >= 0.05 && wheel_radius <= 5.))
      throw InputError("Wheel/Radius = " + text_of(wheel_radius) +
                       ": a wheel with a profile has a radius of 0.05 to 5 m "
                       "at its tape circle.");
    check_range("Gauge", gauge, 0.3, 3., "m");
    check_range("Gauge height", gauge_height, 0.001, 0.04, "m");
    check_range("Flange back distance", flange_back_distance, 0.25, 2.95, "m");
    check_range("Yaw", yaw, -0.1, 0.1, "rad");
    check_range("File unit", file_unit, 1e-6, 1., "m");
    check_range("Smoothing length", smoothing_length, 0., 0.05, "m");
    check_range("Web bow", web_bow, -0.04, 0.04, "m");
    check_curve_radius("Profiles/Curve radius", curve_radius.value_or(1e9));
    check_range("Lateral shift", shift, -0.05, 0.05, "m");
    check_range("Roll", roll.value_or(0.), -0.2, 0.2, "rad");
    check_range("Wheel profile shift", wheel_profile_shift, -0.2, 0.2, "m");
    check_table();
    wheel(prm_folder);
    rail(prm_folder);
  }

  void ProfileParameters::check_table() const
  {
    for (std::size_t k = 1; k < shifts.size(); ++k)
      if (!(shifts[k] > shifts[k - 1]))
        throw InputError("Contact table/Lateral shift: " + text_of(shifts[k]) +
                         " follows " + text_of(shifts[k - 1]) +
                         "; shifts must ascend.");
    for (const double shift : shifts)
      if (!(std::abs(shift) <= 0.05))
        throw InputError("Contact table/Lateral shift contains " +
                         text_of(shift) + ": give metres, from -0.05 to 0.05.");
    if (!(conicity_amplitude > 0. && conicity_amplitude <= 0.05))
      throw InputError(
        "Contact table/Conicity amplitude = " + text_of(conicity_amplitude) +
        ": give metres, above 0 and at most 0.05.");
    if (!(difference_unit >= 1e-6 && difference_unit <= 1.))
      throw InputError("Contact table/File unit = " + text_of(difference_unit) +
                       ": give it in m, from 1e-06 to 1; 1e-3 for mm.");
  }

  void check_curve_radius(const std::string &entry, const double radius)
  {
    if (!(std::abs(radius) >= 10.))
      throw InputError(entry + " = " + text_of(radius) +
                       ": give metres, at least 10 to either side, positive "
                       "where the curve is to the right; leave it empty for "
                       "straight track.");
  }

  std::shared_ptr<const Profiles::ContactFrame>
  ProfileParameters::find_frame(const double                 wheel_radius,
                                const std::filesystem::path &prm_folder) const
  {
    const auto pair = std::make_shared<const Profiles::WheelOnRail>(
      wheel(prm_folder), rail(prm_folder), wheel_radius, tape_circle());
    const double resting =
      roll ? *roll : Profiles::resting_roll(*pair, *pair, shift, yaw);
    return std::make_shared<const Profiles::ContactFrame>(
      pair,
      Profiles::WheelsetPosition{shift, resting, yaw},
      is_left,
      surface_kind == Profiles::SurfaceKind::curved
        ? surface_kind
        : Profiles::SurfaceKind::plane);
  }

  bool ProfileParameters::have_frame_of(const ProfileParameters &other) const
  {
    const auto all = [](const ProfileParameters &p) {
      return std::tie(p.wheel_profile,
                      p.rail_profile,
                      p.inclination,
                      p.gauge,
                      p.gauge_height,
                      p.flange_back_distance,
                      p.yaw,
                      p.smoothing_length,
                      p.file_unit,
                      p.wheel_mirror,
                      p.rail_mirror,
                      p.wheel_profile_shift,
                      p.surface_kind,
                      p.is_left,
                      p.shift,
                      p.roll);
    };
    return all(*this) == all(other);
  }
} // namespace RollingContact
