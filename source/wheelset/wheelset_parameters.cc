#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/scene/analysis_traits.h>
#include <rolling_contact/scene/entries.h>
#include <rolling_contact/wheelset/found_place.h>
#include <rolling_contact/wheelset/wheelset_parameters.h>

#include <cmath>

namespace RollingContact
{
  namespace
  {
    const double distance_of_rails = 1.5; // m, that cants are measured over

    void refuse(const std::string &entry,
                const double       value,
                const std::string &what)
    {
      throw InputError("Wheelset/" + entry + " = " + text_of(value) + ": " +
                       what);
    }

    void refuse_with(const std::string &given, const std::string &other)
    {
      throw InputError("Wheelset/" + given + " and " + other +
                       ": a given shift or yaw takes the place of a balance, "
                       "so that both together have no meaning; give one of "
                       "them.");
    }
  } // namespace

  CurveCase CurveCase::between(const CurveCase &from,
                               const CurveCase &to,
                               const double     share)
  {
    const auto mean = [&](const double a, const double b) {
      return share == 1. ? b : a + share * (b - a);
    };
    return {mean(from.curvature, to.curvature),
            mean(from.lateral_force, to.lateral_force),
            mean(from.frame_yaw, to.frame_yaw),
            mean(from.axle_torque, to.axle_torque)};
  }

  void WheelsetParameters::declare(Entries &entries)
  {
    EntrySection &section = entries.section("Wheelset");
    section.read_by(
      {&place_is_found,
       "Analysis = wheelset and profile evolution read that section, and "
       "stability and stability map with Stability/Wheel"});
    section.renews = Renews::loads;
    section.varies = asks<AnalysisTraits>([](const auto &analysis) {
      return analysis.wears_profiles ||
             (analysis.has_many_states && analysis.takes_found_place);
    });
    entries
      .choice("Vehicle",
              is_bogie,
              std::vector<NamedValue<bool>>{{"wheelset", false},
                                            {"bogie", true}})
      .help = "`wheelset`: one wheelset. `bogie`: two equal wheelsets in a "
              "frame. Lateral force and cant deficiency then act on the "
              "frame; axle load, load transfer and axle torque are those of "
              "each wheelset.";
    declare_balance(entries);
    declare_left_side(entries);
    const Reader hunting_ones{asks<AnalysisTraits>([](const auto &analysis) {
                                return analysis.finds_place;
                              }),
                              "Analysis = wheelset reads it"};
    declare_hunting(entries, hunting_ones);
    declare_bogie(entries,
                  {has_bogie(),
                   "a wheelset with Wheelset/Vehicle = bogie has a frame"});
    entries.add("Search for others", searches)
      .read_by(hunting_ones)
      .read_by({[](const auto &scene) { return !has_bogie()(scene); },
                "other equilibria are looked for with a single wheelset only"})
      .help =
      "Whether other equilibria of the last curve are looked for, over all "
      "shifts at which both wheels are on the rails.";
  }

  void WheelsetParameters::declare_balance(Entries &entries)
  {
    entries.list("Curve radius", curve_radii, "", "m").help =
      "Radii of curves at the middle of the track, solved one after the "
      "other, positive where the curve is to the right: " +
      Entries::form_of_lists() + "; empty: straight track.";
    entries.add("Axle load", axle_load, "N").help =
      "Load that both wheels of a wheelset carry together.";
    entries.add("Cant deficiency", cant_deficiency, "m").help =
      "Cant that is missing at this speed, for rails 1.5 m apart; negative: "
      "too much cant.";
    entries.add("Lateral force", lateral_force, "N").help =
      "Force of the suspension on a wheelset, or of the car body on a bogie, "
      "to the right, besides that of the cant deficiency.";
    entries.add("Load transfer", load_transfer, "N").help =
      "Load that goes from the left wheel to the right one, besides that of "
      "the lateral force at the height of the axle.";
    entries.add("Yaw stiffness", yaw_stiffness, "N m/rad").at_least(0.).help =
      "Stiffness of the suspension between wheelset and frame about the "
      "vertical; 0: a free wheelset.";
    entries.add("Frame yaw", frame_yaw, "rad").help =
      "Yaw of the frame against the radial direction, right-handed about z, "
      "which points down. For a bogie it is the yaw of the car body above it.";
    entries.add("Half wheelbase", ahead_of_frame, "m").help =
      "Distance of the wheelset ahead of the middle of its frame, negative "
      "for a trailing one. In a curve it adds -distance/R to the yaw of the "
      "frame. For a bogie: half the distance of its wheelsets, above 0.";
    entries.add("Axle torque", axle_torque, "N m").help =
      "Torque that drives the wheelset forwards; negative: it brakes.";
    entries.add("Rail lateral stiffness", rail_stiffness, "N/m").help =
      "Stiffness of each rail where a wheel presses it sideways, some 2e7 for "
      "a usual track. Rail heads do not turn. Empty: rails do not give way.";
    entries.add("Lateral shift", shift, "m").help =
      "Lateral shift to the right, in place of the lateral force, which is "
      "found for it.";
    entries.add("Yaw", yaw, "rad").help =
      "Yaw against the radial direction, in place of the suspension, whose "
      "moment is found for it.";
  }

  void WheelsetParameters::declare_hunting(Entries      &entries,
                                           const Reader &reader)
  {
    entries.add("Mass", hunting.mass, "kg").at_least(0.).read_by(reader).help =
      "Mass of the wheelset, for the eigenvalues of its small motions about "
      "the equilibrium and the speed from which it hunts; 0: neither is "
      "computed.";
    entries.add("Yaw inertia", hunting.yaw_inertia, "kg m^2")
      .at_least(0.)
      .read_by(reader)
      .help = "Moment of inertia of the wheelset about the vertical, for "
              "hunting.";
    entries.add("Axle inertia", hunting.axle_inertia, "kg m^2")
      .at_least(0.)
      .read_by(reader)
      .help = "Moment of inertia of the wheelset about the axle, for hunting.";
    entries.add("Lateral stiffness", hunting.lateral_stiffness, "N/m")
      .at_least(0.)
      .read_by(reader)
      .help = "Lateral stiffness of the suspension between wheelset and "
              "frame. A single wheelset needs it for hunting about the "
              "equilibrium, a bogie always.";
    entries.add("Lateral damping", hunting.lateral_damping, "N s/m")
      .at_least(0.)
      .read_by(reader)
      .help = "Lateral damping of the suspension, for hunting.";
    entries.add("Yaw damping", hunting.yaw_damping, "N m s/rad")
      .at_least(0.)
      .read_by(reader)
      .help = "Yaw damping of the suspension, for hunting.";
  }

  void WheelsetParameters::declare_bogie(Entries &entries, const Reader &reader)
  {
    const auto add = [&](const std::string &name,
                         double            &value,
                         const std::string &unit) -> Entry & {
      return entries.add(name, value, unit).at_least(0.).read_by(reader);
    };
    add("Secondary yaw stiffness", frame.yaw_stiffness, "N m/rad").help =
      "Stiffness between car body and frame of a bogie about the vertical.";
    add("Frame mass", frame.mass, "kg").help =
      "Mass of the frame of a bogie, for hunting.";
    add("Frame yaw inertia", frame.yaw_inertia, "kg m^2").help =
      "Moment of inertia of the frame of a bogie about the vertical, for "
      "hunting.";
    add("Secondary lateral stiffness", frame.lateral_stiffness, "N/m").help =
      "Lateral stiffness between frame and car body, which does not move, for "
      "hunting.";
    add("Secondary lateral damping", frame.lateral_damping, "N s/m").help =
      "Lateral damping between frame and car body, for hunting.";
    add("Secondary yaw damping", frame.yaw_damping, "N m s/rad").help =
      "Yaw damping between frame and car body, for hunting.";
  }

  void WheelsetParameters::declare_left_side(Entries &entries)
  {
    entries.add("Left wheel profile", left_wheel_profile).help =
      "Profile of the left wheel, as Profiles/Wheel profile, drawn as that of "
      "a right-hand wheel; empty: the same as the right one.";
    entries.add("Left rail profile", left_rail_profile).help =
      "Profile of the left rail, as Profiles/Rail profile, drawn as that of a "
      "right-hand rail; empty: the same as the right one.";
    entries.add("Left wheel radius", left_wheel_radius, "m").help =
      "Radius of the left wheel at the tape circle; empty: Wheel/Radius.";
  }

  void WheelsetParameters::check() const
  {
    for (const double radius : curve_radii)
      check_curve_radius("Wheelset/Curve radius", radius);
    for (const double radius : curve_radii)
      if (radius * curve_radii.front() < 0.)
        refuse("Curve radius",
               radius,
               "all curves of one run must go to the same side; take another "
               "run for the others.");
    if (!(axle_load > 0.))
      refuse("Axle load", axle_load, "give a load above 0, in N.");
    if (!(std::abs(cant_deficiency) <= 0.5))
      refuse("Cant deficiency", cant_deficiency, "give metres, up to 0.5.");
    if (cant_deficiency != 0. && curve_radii.empty())
      refuse("Cant deficiency",
             cant_deficiency,
             "it is that of a curve; give Wheelset/Curve radius, or a Lateral "
             "force on straight track.");
    if (!(std::abs(ahead_of_frame) <= 10.))
      refuse("Half wheelbase", ahead_of_frame, "give metres, up to 10.");
    if (!(std::abs(frame_yaw) <= 0.1))
      refuse("Frame yaw", frame_yaw, "give rad, up to 0.1.");
    if (rail_stiffness && !(*rail_stiffness >= 1e5))
      refuse("Rail lateral stiffness",
             *rail_stiffness,
             "give 1e5 N/m or more, or leave it empty for rigid rails.");
    if (rail_stiffness && hunting.mass > 0.)
      refuse("Rail lateral stiffness",
             *rail_stiffness,
             "how rails answer to motions of a wheelset that hunts is not "
             "known; leave it empty with Wheelset/Mass.");
    if (shift && !(std::abs(*shift) <= 0.05))
      refuse("Lateral shift", *shift, "give metres, up to 0.05.");
    if (yaw && !(std::abs(*yaw) <= 0.1))
      refuse("Yaw", *yaw, "give rad, up to 0.1.");
    if (hunting.mass > 0. &&
        !(hunting.yaw_inertia > 0. && hunting.axle_inertia > 0.))
      refuse("Mass",
             hunting.mass,
             "a wheelset that hunts has moments of inertia; give Wheelset/Yaw "
             "inertia and Axle inertia.");
    if (hunting.mass > 0. && (shift || yaw))
      refuse_with("Mass", "a given Lateral shift or Yaw");
    if (left_wheel_radius &&
        !(*left_wheel_radius >= 0.05 && *left_wheel_radius <= 5.))
      refuse("Left wheel radius", *left_wheel_radius, "give 0.05 to 5 m.");
    if (shift && lateral_force != 0.)
      refuse_with("Lateral shift", "Wheelset/Lateral force");
    if (shift && cant_deficiency != 0.)
      refuse_with("Lateral shift", "Wheelset/Cant deficiency");
    if (yaw && yaw_stiffness > 0.)
      refuse_with("Yaw", "Wheelset/Yaw stiffness");
    if (is_bogie)
      check_bogie();
    else if (frame.mass > 0. || frame.yaw_stiffness > 0.)
      throw InputError("Wheelset/Frame mass and Secondary yaw stiffness are "
                       "those of a bogie; set Wheelset/Vehicle = bogie.");
  }

  void WheelsetParameters::check_bogie() const
  {
    if (!(ahead_of_frame >= 0.3))
      refuse("Half wheelbase",
             ahead_of_frame,
             "that of a bogie is half the distance of its wheelsets; give 0.3 "
             "to 10 m.");
    if (!(hunting.lateral_stiffness > 0.))
      refuse("Lateral stiffness",
             hunting.lateral_stiffness,
             "the wheelsets of a bogie carry its frame by springs; give N/m "
             "above 0.");
    if (shift || yaw)
      refuse_with("Vehicle = bogie", "a given Lateral shift or Yaw");
    if (hunting.mass > 0. && !(frame.mass > 0. && frame.yaw_inertia > 0.))
      refuse("Mass",
             hunting.mass,
             "the frame of a bogie that hunts has mass and moment of inertia; "
             "give Wheelset/Frame mass and Frame yaw inertia.");
  }

  WheelsetParameters WheelsetParameters::mirrored() const
  {
    WheelsetParameters other = *this;
    for (double &radius : other.curve_radii)
      radius = -radius;
    other.lateral_force = -lateral_force;
    other.load_transfer = -load_transfer;
    other.frame_yaw     = -frame_yaw;
    for (std::optional<double> *given : {&other.shift, &other.yaw})
      if (*given)
        **given = -**given;
    return other;
  }

  ProfileParameters
  WheelsetParameters::left_profiles(const ProfileParameters &right) const
  {
    ProfileParameters left = right;
    if (!left_wheel_profile.empty())
      left.wheel_profile = left_wheel_profile;
    if (!left_rail_profile.empty())
      left.rail_profile = left_rail_profile;
    return left;
  }

  std::vector<CurveCase> WheelsetParameters::cases() const
  {
    std::vector<double> curvatures;
    for (const double radius : curve_radii)
      curvatures.push_back(1 / radius);
    if (curvatures.empty())
      curvatures.push_back(0.);
    std::vector<CurveCase> cases;
    for (const double curvature : curvatures)
      {
        const double side = curvature > 0. ? 1. : curvature < 0. ? -1. : 0.;
        cases.push_back(
          {curvature,
           lateral_force - side * n_wheelsets() * axle_load * cant_deficiency /
                             distance_of_rails,
           is_bogie ? frame_yaw : frame_yaw - ahead_of_frame * curvature,
           axle_torque});
      }
    return cases;
  }

  bool WheelsetParameters::goes_to_the_left() const
  {
    const CurveCase first = cases().front();
    return first.curvature < 0. ||
           (first.curvature == 0. && first.lateral_force < 0.);
  }
} // namespace RollingContact
