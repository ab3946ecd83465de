#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/scene/entries.h>
#include <rolling_contact/wheelset/fmu_parameters.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    struct AxisEntry
    {
      const char *name, *values, *unit, *help;
    };

    const char slips[] =
      "-0.04, -0.015, -0.007, -0.003, 0, 0.003, 0.007, 0.015, 0.04";

    /** In the order of Fmu::Axis. */
    const AxisEntry axis_entries[Fmu::n_axes] = {
      {"Lateral shift",
       "-0.006 : 0.006 : 13",
       "m",
       "Lateral shift of the wheelset to the right, against the rail of the "
       "right-hand wheel"},
      {"Yaw", "0", "rad", "Yaw of the wheelset against the radial direction"},
      {"Curvature",
       "0",
       "1/m",
       "Curvature of the track with the yaw rate over the speed, positive to "
       "the right"},
      {"Load",
       "",
       "N",
       "Vertical load of the wheel; empty: Contact/Vertical load"},
      {"Slip along",
       slips,
       "1",
       "Slip forwards, less that of a wheel that rolls on the radius where a "
       "rigid one touches, over the friction coefficient"},
      {"Slip across",
       slips,
       "1",
       "Slip to the right at the tape circle, over the friction coefficient"},
      {"Friction coefficient",
       "",
       "1",
       "Friction coefficient of both wheels; empty: Contact/Friction "
       "coefficient"}};

    [[noreturn]] void refuse_scene(const std::string &entry,
                                   const std::string &what)
    {
      throw InputError(entry + ": Analysis = fmu " + what);
    }

    void check_states(const Situation &scene)
    {
      if (scene.mesh.target_error || scene.mesh.adaptive_levels > 0)
        refuse_scene("Mesh/Target error or Adaptive levels",
                     "has one mesh for many states; leave the target empty and "
                     "set the levels to 0.");
      if (scene.body_solver == BodySolver::distributed)
        refuse_scene("Body solver = distributed",
                     "keeps bodies, which is not possible on several ranks; "
                     "take direct or automatic.");
      if (!scene.inputs->table.axes().empty() ||
          !scene.inputs->table.file_of_rows.empty())
        refuse_scene("Table/Axis 1 or File of rows",
                     "has the axes of section FMU; leave them empty.");
      scene.inputs->table.part(); // throws where it is none
    }
  } // namespace

  void FmuParameters::declare(Entries &entries)
  {
    entries.section("FMU").read_by_analyses("fmu");
    entries
      .choice("Kind",
              kind,
              std::vector<NamedValue<FmuKind>>{{"table", FmuKind::table},
                                               {"states", FmuKind::states},
                                               {"both", FmuKind::both}})
      .help = "`table`: the units hold a table of forces, which is computed "
              "now, and run anywhere. `states`: they have this program solve "
              "each state when it is asked for; it must be on the machine that "
              "they run on, and no table is computed. `both`: units of both "
              "kinds.";
    for (std::size_t d = 0; d < Fmu::n_axes; ++d)
      {
        const AxisEntry &axis = axis_entries[d];
        entries.list(axis.name, axes[d], axis.values, axis.unit).help =
          std::string(axis.help) + (d == 0 ? ": one value or three and more, " +
                                               Entries::form_of_lists() + '.'
                                           : ".");
      }
    entries.add("Points", n_points, "1").between(0, 100000).help =
      "Number of states at random places between those of the table that are "
      "solved as a check. One half gives how wide the bound of the forces "
      "must be; the other half tells how often the bound holds.";
  }

  void FmuParameters::check() const
  {
    for (std::size_t d = 0; d < Fmu::n_axes; ++d)
      {
        const std::string entry = std::string("FMU/") + axis_entries[d].name;
        if (axes[d].size() == 2)
          throw InputError(entry + " has two values: give one, or at least "
                                   "three, which show how large the error of "
                                   "interpolation is.");
        for (std::size_t k = 0; k < axes[d].size(); ++k)
          {
            if (k > 0 && !(axes[d][k] > axes[d][k - 1]))
              throw InputError(entry + ": " + text_of(axes[d][k]) +
                               " follows " + text_of(axes[d][k - 1]) +
                               "; values must ascend.");
            if ((d == Fmu::load_axis || d == Fmu::friction_axis) &&
                !(axes[d][k] > 0.))
              throw InputError(entry + " contains " + text_of(axes[d][k]) +
                               ": give numbers above 0.");
            if (d == Fmu::turn_axis && !(std::abs(axes[d][k]) <= 0.1))
              throw InputError(entry + " contains " + text_of(axes[d][k]) +
                               ": give 1/m from -0.1 to 0.1.");
          }
      }
  }

  std::array<std::vector<double>, Fmu::n_axes>
  FmuParameters::all_axes(const PairSpec &scene) const
  {
    auto all = axes;
    for (std::vector<double> &axis : all)
      for (double &value : axis) // without the rounding of a range
        if (std::abs(value) <
            1e-14 * std::max(std::abs(axis.front()), std::abs(axis.back())))
          value = 0.;
    if (all[Fmu::load_axis].empty())
      all[Fmu::load_axis] = {scene.contact.vertical_load.value_or(0.)};
    if (all[Fmu::friction_axis].empty())
      all[Fmu::friction_axis] = {scene.contact.friction_coefficient};
    return all;
  }

  void check_fmu(const Situation &scene)
  {
    const ProfileParameters &profiles = scene.profiles;
    if (scene.dimension != 3 || !profiles.in_use())
      refuse_scene("Profiles/Wheel profile and Rail profile",
                   "needs wheels with profiles in 3D; give both and Dimension "
                   "= 3.");
    if (!profiles.gives_creepages() ||
        profiles.surface_kind != Profiles::SurfaceKind::curved)
      refuse_scene("Profiles/Creepages and Contact surface",
                   "needs `from kinematics` and `curved`, because its states "
                   "are given by the motion of the wheelset.");
    if (scene.follows_profiles())
      refuse_scene("Profiles/Body sections, Wheel/Shape, Rail/Shape",
                   "keeps bodies from place to place; take a disc and a "
                   "block.");
    if (profiles.roll || profiles.is_left)
      refuse_scene("Profiles/Roll and Side",
                   "finds the roll at which both wheels touch and solves the "
                   "right-hand one; take automatic and right.");
    if (!(scene.contact.vertical_load.value_or(0.) > 0.))
      refuse_scene("Contact/Vertical load",
                   "needs a load in N; give one above 0.");
    if (!(scene.contact.friction_coefficient > 0.) ||
        scene.contact.friction_law != "constant")
      refuse_scene("Contact/Friction coefficient and Friction law",
                   "needs a coefficient above 0 that is constant.");
    if (!(scene.contact.rolling_speed() > 0.))
      refuse_scene("Contact/Speed",
                   "needs a wheelset that rolls forwards; "
                   "give a speed above 0.");
    check_states(scene);
  }
} // namespace RollingContact
