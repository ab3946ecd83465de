#include <deal.II/base/parameter_handler.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/input/number_list.h>
#include <rolling_contact/input/prm_declarations.h>
#include <rolling_contact/profiles/nominal_profiles.h>
#include <rolling_contact/scene/profile_parameters.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    using Mirror = ProfileParameters::Mirror;

    const std::vector<NamedValue<Mirror>> named_mirrors{{"none", Mirror::none},
                                                        {"y", Mirror::y},
                                                        {"z", Mirror::z},
                                                        {"y and z",
                                                         Mirror::y_and_z}};

    const double flange_back_to_tape_circle = 0.07; // m

    void
    check_range(const std::string &entry,
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



  void
  ProfileParameters::declare(ParameterHandler &prm)
  {
    prm.enter_subsection("Profiles");
    declare_sections(prm);
    declare_track(prm);
    declare_wheelset(prm);
    declare_bodies(prm);
    prm.leave_subsection();
    prm.enter_subsection("Contact table");
    declare_table(prm);
    prm.leave_subsection();
  }



  void
  ProfileParameters::declare_sections(ParameterHandler &prm)
  {
    const std::string file =
      ", or the name of a file beside the .prm file: two columns y and z, "
      "SIMPACK .prr or .prw, MiniProf .ban or .whl.";
    prm.add_parameter("Wheel profile",
                      wheel_profile,
                      "`S1002` (EN 13715)" + file +
                        " Its radius at the tape circle, y = 0, is "
                        "Wheel/Radius. Both profiles empty: the surfaces are "
                        "those of Wheel and Rail, in a contact table S1002 on "
                        "60E1.");
    prm.add_parameter("Rail profile",
                      rail_profile,
                      "`60E1` (EN 13674-1), `60E1 Manchester` (the variant of "
                      "the Manchester benchmarks)" +
                        file);
    declare_choice(
      prm,
      "Contact surface",
      surface_kind,
      std::vector<NamedValue<Profiles::SurfaceKind>>{
        {"plane", Profiles::SurfaceKind::plane},
        {"curved", Profiles::SurfaceKind::curved}},
      "`plane`: pressure acts along the normal of the first contact; `curved`: "
      "along the rail's normal at each node, on the length of its section, so "
      "that conformal contacts, and tread and flange at once, have an answer.");
    prm.add_parameter("Smoothing length",
                      smoothing_length,
                      "Waves of this length in the points of a file are "
                      "halved by a smoothing spline; 0: none. Units: m.",
                      Patterns::Double(0.));
    prm.add_parameter("File unit",
                      file_unit,
                      "One unit of a file of two columns or of MiniProf. "
                      "Units: m.",
                      Patterns::Double(0.));
    for (const auto &[body, mirror] :
         {std::pair<std::string, Mirror *>("Wheel", &wheel_mirror),
          std::pair<std::string, Mirror *>("Rail", &rail_mirror)})
      declare_choice(prm,
                     body + " mirror",
                     *mirror,
                     named_mirrors,
                     "Coordinates of the file to turn round, so that y is "
                     "towards the field side of the right-hand side and z "
                     "down.");
  }



  void
  ProfileParameters::declare_track(ParameterHandler &prm)
  {
    prm.add_parameter("Rail inclination",
                      inclination,
                      "Towards the middle of the track, as 1/40, 1/20, or 0 "
                      "for a file that is inclined already. Units: 1.");
    prm.add_parameter("Gauge",
                      gauge,
                      "Distance of the gauge faces. Units: m.",
                      Patterns::Double(0.));
    prm.add_parameter("Gauge height",
                      gauge_height,
                      "Depth of the gauge faces below the top of the rails. "
                      "Units: m.",
                      Patterns::Double(0.));
    prm.add_parameter("Flange back distance",
                      flange_back_distance,
                      "Distance of the backs of the flanges; the tape circles "
                      "are 0.07 m from them. Units: m.",
                      Patterns::Double(0.));
    prm.add_parameter("Yaw",
                      yaw,
                      "Turn of the wheelset about the vertical, right-handed "
                      "about z down. Units: rad.",
                      Patterns::Double());
  }



  namespace
  {
    /**
     * Declare a number that may be `automatic`, the default.
     */
    void
    declare_automatic(ParameterHandler      &prm,
                      const std::string     &entry,
                      std::optional<double> &value,
                      const std::string     &unit,
                      const std::string     &help)
    {
      prm.declare_entry(entry, "automatic", Patterns::Anything(), help);
      prm.add_action(entry, [&value, entry, unit](const std::string &text) {
        value = text == "automatic" ? std::nullopt : number(text);
        if (!value && text != "automatic")
          throw InputError("Profiles/" + entry + " = " + text +
                           ": give a number in " + unit + ", or `automatic`.");
      });
    }
  } // namespace



  void
  ProfileParameters::declare_wheelset(ParameterHandler &prm)
  {
    declare_choice(prm,
                   "Side",
                   is_left,
                   std::vector<NamedValue<bool>>{{"right", false},
                                                 {"left", true}},
                   "Which wheel of the wheelset the bodies are.");
    prm.add_parameter("Lateral shift",
                      shift,
                      "Of the wheelset to the right, but in a contact table, "
                      "which has its own. Units: m.",
                      Patterns::Double());
    declare_automatic(prm,
                      "Roll",
                      roll,
                      "rad",
                      "Turn of the wheelset about the direction of travel, "
                      "right-handed; `automatic`: both wheels touch. Units: "
                      "rad.");
    declare_choice(
      prm,
      "Creepages",
      creepage_source,
      std::vector<NamedValue<CreepageSource>>{{"given", CreepageSource::given},
                                              {"from kinematics",
                                               CreepageSource::kinematics}},
      "`given`: those of section Contact, or of an analysis with its own; "
      "`from kinematics`: what a wheelset in this place that moves along the "
      "track with Contact/Speed has at the first contact, and the rolling "
      "radius that changes over the patch as the profile does.");
    declare_automatic(prm,
                      "Pitch rate",
                      pitch_rate,
                      "rad/s",
                      "Angular velocity of the axle for creepages from "
                      "kinematics, negative when it rolls forwards; "
                      "`automatic`: no longitudinal creepage. Units: rad/s.");
  }



  void
  ProfileParameters::declare_table(ParameterHandler &prm)
  {
    declare_number_list(prm,
                        "Contact table/Lateral shift",
                        shifts,
                        "-0.008 : 0.008 : 81",
                        "Of the wheelset to the right: " +
                          std::string(number_list_form) + ". Units: m.");
    prm.add_parameter("Conicity amplitude",
                      conicity_amplitude,
                      "Amplitude of the wheelset's lateral motion of the "
                      "conicity in the summary. Units: m.",
                      Patterns::Double(0.));
  }



  double
  ProfileParameters::slope_of_inclination() const
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



  double
  ProfileParameters::tape_circle() const
  {
    return flange_back_distance / 2 + flange_back_to_tape_circle;
  }



  void
  ProfileParameters::check(const double                 wheel_radius,
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
    check_range("Lateral shift", shift, -0.05, 0.05, "m");
    check_range("Roll", roll.value_or(0.), -0.2, 0.2, "rad");
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
    wheel(prm_folder);
    rail(prm_folder);
  }



  void
  ProfileParameters::find_frame(const double                 wheel_radius,
                                const std::filesystem::path &prm_folder)
  {
    const auto pair = std::make_shared<const Profiles::WheelOnRail>(
      wheel(prm_folder), rail(prm_folder), wheel_radius, tape_circle());
    const double resting =
      roll ? *roll : Profiles::resting_roll(*pair, shift, yaw);
    frame = std::make_shared<const Profiles::ContactFrame>(
      pair,
      Profiles::WheelsetPosition{shift, resting, yaw},
      is_left,
      surface_kind);
  }
} // namespace RollingContact
