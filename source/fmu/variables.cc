#include <rolling_contact/fmu/variables.h>

#include <algorithm>

namespace RollingContact::Fmu
{
  namespace
  {
    /** References of the wheels begin here. */
    const unsigned int first_of_right = 100, first_of_left = 200;

    struct InputText
    {
      const char *name, *unit, *description;
    };

    const InputText input_texts[n_inputs] = {
      {"lateral_shift", "m", "shift of the wheelset to the right"},
      {"yaw",
       "rad",
       "yaw against the radial direction, right-handed about the vertical "
       "downwards"},
      {"lateral_velocity", "m/s", "rate of lateral_shift"},
      {"yaw_rate", "rad/s", "rate of yaw"},
      {"axle_speed",
       "rad/s",
       "angular velocity about the axle, negative where it rolls forwards"},
      {"speed", "m/s", "speed along the middle of the track"},
      {"curvature",
       "1/m",
       "curvature of the track, positive where it goes to "
       "the right"},
      {"friction", "", "friction coefficient"},
      {"right.load", "N", "vertical load of the right-hand wheel on its rail"},
      {"left.load", "N", "vertical load of the left-hand wheel on its rail"},
      {"right.rail_y", "m", "displacement of the right-hand rail to the right"},
      {"left.rail_y", "m", "displacement of the left-hand rail to the right"},
      {"right.rail_z", "m", "displacement of the right-hand rail down"},
      {"left.rail_z", "m", "displacement of the left-hand rail down"}};

    const InputText quantity_texts[n_quantities] = {
      {"force_x", "N", "force on the wheel forwards"},
      {"force_y", "N", "force on the wheel to the right"},
      {"force_z", "N", "force on the wheel down"},
      {"moment_x",
       "N.m",
       "moment on the wheel about the centre of the wheelset, forwards"},
      {"moment_y",
       "N.m",
       "moment on the wheel about the centre of the wheelset, to the right: "
       "positive where friction drives the vehicle"},
      {"moment_z",
       "N.m",
       "moment on the wheel about the centre of the "
       "wheelset, down"},
      {"normal_force", "N", "normal force, the integral of the pressure"},
      {"contact_y",
       "m",
       "centre of the pressure, from the middle of the track to the right"},
      {"contact_angle",
       "rad",
       "slope of the contact downwards to the right, where the pressure's "
       "resultant acts"},
      {"max_pressure", "Pa", "largest pressure"},
      {"t_gamma", "N", "work of friction per metre of track"},
      {"force_bound",
       "N",
       "bound of the error of the force vector, of the states of the table "
       "and between them; the largest number where no bound is known"}};

    const char bound_of_states[] =
      "bound of the error of the force vector; the largest number where no "
      "bound is known";

    const char inside_of_states[] =
      "whether the state is that of the inputs: not below the least speed";

    void add_wheel(const unsigned int     wheel,
                   const ForceKind        kind,
                   std::vector<Variable> &all)
    {
      const bool        has_table = kind == ForceKind::table;
      const std::string side      = wheel == 0 ? "right." : "left.";
      unsigned int      first     = wheel == 0 ? first_of_right : first_of_left;
      for (std::size_t q = 0; q < n_quantities; ++q)
        all.push_back({first++,
                       side + quantity_texts[q].name,
                       VariableType::real,
                       Causality::output,
                       quantity_texts[q].unit,
                       q == force_bound && !has_table
                         ? bound_of_states
                         : quantity_texts[q].description,
                       Source::quantity,
                       q,
                       wheel});
      all.push_back({first++,
                     side + "y_over_q",
                     VariableType::real,
                     Causality::output,
                     "",
                     "force_y over the load",
                     Source::force_ratio,
                     0,
                     wheel});
      all.push_back({first++,
                     side + "inside_table",
                     VariableType::boolean,
                     Causality::output,
                     "",
                     has_table
                       ? "whether the state is within all axes of the table; "
                         "if not, outputs are those of the nearest state that "
                         "is"
                       : inside_of_states,
                     Source::inside,
                     0,
                     wheel});
    }

    std::vector<Variable> make_variables(const ForceKind kind)
    {
      std::vector<Variable> all;
      all.push_back({0,
                     "time",
                     VariableType::real,
                     Causality::independent,
                     "s",
                     "time",
                     Source::time});
      for (std::size_t k = 0; k < n_inputs; ++k)
        all.push_back({static_cast<unsigned int>(1 + k),
                       input_texts[k].name,
                       VariableType::real,
                       Causality::input,
                       input_texts[k].unit,
                       input_texts[k].description,
                       Source::input,
                       k});
      const auto add = [&](const unsigned int reference,
                           const char        *name,
                           const VariableType type,
                           const Causality    causality,
                           const char        *unit,
                           const char        *description,
                           const Source       source) {
        all.push_back(
          {reference, name, type, causality, unit, description, source});
      };
      using Type = VariableType;
      add(50,
          "least_speed",
          Type::real,
          Causality::parameter,
          "m/s",
          "least speed: below it creepages are those at this speed, and "
          "inside_table is false",
          Source::least_speed);
      if (kind == ForceKind::program)
        add(51,
            "program",
            Type::text,
            Causality::parameter,
            "",
            "path of the program rolling-contact that solves the states",
            Source::program);
      add(60,
          "wheel_radius",
          Type::real,
          Causality::constant,
          "m",
          "radius at the tape circle",
          Source::radius);
      add(61,
          "tape_circle",
          Type::real,
          Causality::constant,
          "m",
          "distance of the tape circles from the middle of the wheelset",
          Source::tape_circle);
      add(70,
          "model",
          Type::text,
          Causality::constant,
          "",
          "title of the model, with its profiles",
          Source::scene);
      add(80,
          "roll",
          Type::real,
          Causality::output,
          "rad",
          "roll of the wheelset where both rigid wheels touch, right-handed "
          "about forwards",
          Source::roll);
      for (const unsigned int wheel : {0, 1})
        add_wheel(wheel, kind, all);
      return all;
    }
  } // namespace

  const std::vector<Variable> &variables(const ForceKind kind)
  {
    static const std::vector<Variable> with_table =
                                         make_variables(ForceKind::table),
                                       with_program =
                                         make_variables(ForceKind::program);
    return kind == ForceKind::table ? with_table : with_program;
  }

  const Variable *find_variable(const unsigned int reference,
                                const ForceKind    kind)
  {
    const std::vector<Variable> &all = variables(kind);
    const auto                   at =
      std::lower_bound(all.begin(),
                       all.end(),
                       reference,
                       [](const Variable &variable, const unsigned int number) {
                         return variable.reference < number;
                       });
    return at != all.end() && at->reference == reference ? &*at : nullptr;
  }

  const std::vector<Unit> &units()
  {
    static const std::vector<Unit> all{{"s", 0, 0, 1, 0},
                                       {"m", 0, 1, 0, 0},
                                       {"rad", 0, 0, 0, 1},
                                       {"m/s", 0, 1, -1, 0},
                                       {"rad/s", 0, 0, -1, 1},
                                       {"1/m", 0, -1, 0, 0},
                                       {"N", 1, 1, -2, 0},
                                       {"N.m", 1, 2, -2, 0},
                                       {"Pa", 1, -1, -2, 0}};
    return all;
  }
} // namespace RollingContact::Fmu
