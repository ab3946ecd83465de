#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/results/result_error.h>
#include <rolling_contact/results/result_row.h>
#include <rolling_contact/run/figure.h>
#include <rolling_contact/scene/scene_parameters.h>
#include <rolling_contact/wheelset/wheelset_report.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    const char *const sides[] = {"right", "left"};

    /// from which a wheelset is told to be in danger
    const double least_load = 0.1, largest_yaw = 0.025;

    const double fastest = 200.; ///< m/s, of hunting

    /// m and rad: below this radius a rail is not straight under a flange
    const double narrow_curve = 60., steep = 0.8;

    double lateral_ratio(const WheelState &wheel)
    {
      return wheel.forces.force_y / -wheel.forces.force_z;
    }

    std::string named(const CurveCase &acting)
    {
      if (acting.curvature == 0.)
        return "straight track";
      return "R = " + significant(std::abs(1 / acting.curvature), 6) +
             " m to the " + (acting.curvature > 0. ? "right" : "left");
    }

    std::string with_bound(const double                 value,
                           const std::optional<double> &bound,
                           const std::string           &unit)
    {
      return significant(value, 5) +
             (bound ? " \u00b1 " + significant(*bound, 2) : std::string()) +
             " " + unit;
    }

    std::string told(const WheelState &wheel)
    {
      return "load " + significant(1e-3 * wheel.load, 4) +
             " kN, to the right " +
             significant(1e-3 * wheel.forces.force_y, 4) + " kN, T gamma " +
             significant(wheel.creep_work, 4) + " N, " +
             significant(100 * wheel.tangential_force / wheel.friction_force,
                         3) +
             " % of friction, " + significant(1e-6 * wheel.max_pressure, 4) +
             " MPa, " + std::to_string(wheel.n_patches) +
             (wheel.n_patches == 1 ? " patch" : " patches");
    }

    /**
     * By which lateral force over load a flange climbs, of Nadal.
     */
    double climbing_ratio(const double angle, const double friction)
    {
      const double slope = std::tan(std::abs(angle));
      return (slope - friction) / (1 + friction * slope);
    }
  } // namespace

  WheelsetReport::WheelsetReport(const Situation          &scene,
                                 const WheelsetParameters &wheelset,
                                 RunContext               &context)
    : scene(scene)
    , wheelset(wheelset)
    , context(context)
    , table(context.folder, "wheelset.csv")
  {}

  void WheelsetReport::add(const std::vector<FoundEquilibrium> &found)
  {
    all.emplace_back();
    for (const FoundEquilibrium &wheelset : found)
      {
        all.back().push_back(wheelset.state);
        tell(wheelset);
        add_row(scene, wheelset);
        for (unsigned int wheel = 0; wheel < 2; ++wheel)
          add_wheel(wheelset, wheel);
      }
  }

  void WheelsetReport::add_row(const PairSpec         &at,
                               const FoundEquilibrium &found)
  {
    const WheelsetState &state     = found.state;
    const double         curvature = state.acting.curvature;
    table.set_if(curvature != 0., "curve_radius_m", 1 / curvature);
    table.set("curvature_1/m", curvature);
    if (wheelset.is_bogie)
      {
        table.set("wheelset", found.name);
        table.set("frame_shift_m", found.frame[0]);
        table.set("frame_yaw_rad", found.frame[1]);
      }
    table.set("lateral_shift_m", state.place.shift);
    table.set("yaw_rad", state.place.yaw);
    table.set("roll_rad", found.roll);
    table.set("axle_excess", state.place.excess);
    table.set("pitch_rate_rad/s",
              state.place.pitch_rate(at.contact.rolling_speed(),
                                     at.wheel.radius));
    if (wheelset.rail_stiffness)
      for (unsigned int k = 0; k < 2; ++k)
        table.set(std::string(sides[k]) + "_rail_shift_m",
                  state.place.rails[k]);
    for (const auto &[column, k] : {std::pair("bound_lateral_shift_m", 0),
                                    std::pair("bound_yaw_rad", 1),
                                    std::pair("bound_axle_excess", 2)})
      table.set_if(found.bounds.has_value(),
                   column,
                   found.bounds ? (*found.bounds)[k] : 0.);
    table.set("lateral_force_N", state.lateral_force);
    table.set("yaw_moment_Nm", state.yaw_moment);
    table.set("axle_torque_Nm", state.acting.axle_torque);
    table.set("drag_N", found.drag());
    table.set("creep_work_J/m", found.creep_work());
    table.set("energy_error", found.energy_error(at.wheel.radius));
    table.set("residual", found.residual());
    for (unsigned int k = 0; k < 2; ++k)
      {
        const WheelState &wheel = state.wheels[k];
        const std::string side  = sides[k];
        table.set(side + "_load_N", wheel.load);
        table.set(side + "_force_x_N", wheel.forces.force_x);
        table.set(side + "_force_y_N", wheel.forces.force_y);
        table.set(side + "_force_y/load", lateral_ratio(wheel));
        table.set(side + "_creep_work_J/m", wheel.creep_work);
        table.set(side + "_utilised_friction",
                  wheel.tangential_force / wheel.friction_force);
        table.set(side + "_max_pressure_Pa", wheel.max_pressure);
        table.set(side + "_patches", wheel.n_patches);
        table.set(side + "_angle_rad", wheel.angle);
        table.set(side + "_steepest_angle_rad", wheel.steepest);
      }
    table.set_if(found.another.has_value(),
                 "another_lateral_shift_m",
                 found.another ? found.another->place.shift : 0.);
    table.set_if(found.another.has_value(),
                 "another_yaw_rad",
                 found.another ? found.another->place.yaw : 0.);
    add_hunting(found);
    table.set("steps", found.n_steps);
    table.set("states", found.n_states);
    table.set("sets_of_bodies", found.n_bodies);
    table.end_row();
    table.flush();
  }

  /**
   * The least damped motion at the speed of the scene, and the speed from which
   * one grows.
   */
  void WheelsetReport::add_hunting(const FoundEquilibrium &found)
  {
    if (!found.hunting)
      return;
    const double speed    = scene.contact.rolling_speed();
    const auto   all      = found.hunting->eigenvalues(speed);
    const auto   critical = found.hunting->critical_speed(fastest);
    const double growth   = all.front().real(),
                 frequency =
                   std::abs(all.front().imag()) / (2 * std::acos(-1.));
    table.set("hunting_growth_1/s", growth);
    table.set("hunting_frequency_Hz", frequency);
    table.set_if(frequency > 0.,
                 "hunting_wavelength_m",
                 frequency > 0. ? speed / frequency : 0.);
    table.set_if(critical.has_value(),
                 "critical_speed_m/s",
                 critical.value_or(0.));
    context.report.set_finding(
      "hunts",
      std::string(Hunting::grows(all) ? "grows by " : "decays by ") +
        significant(std::abs(growth), 4) + " 1/s at " +
        significant(frequency, 4) + " Hz and " + significant(speed, 4) +
        " m/s; " +
        (!critical        ? "no motion grows below " + significant(fastest, 3)
         : *critical > 0. ? "from " + significant(*critical, 4)
                          : "already from " + significant(fastest / 400, 2)) +
        (!critical ? " m/s" : " m/s on one grows"));
  }

  void WheelsetReport::add_wheel(const FoundEquilibrium &found,
                                 const unsigned int      wheel)
  {
    const double curvature = found.state.acting.curvature;
    if (!found.name.empty())
      context.results.set("wheelset", found.name);
    context.results.set("side", std::string(sides[wheel]));
    context.results.set_if(curvature != 0., "curve_radius_m", 1 / curvature);
    context.results.set("lateral_shift_m", found.state.place.shift);
    context.results.set("yaw_rad", found.state.place.yaw);
    add_result_row(*found.scenes[wheel], found.steady[wheel], context);
    note_error(*found.scenes[wheel], found.steady[wheel], context.report);
  }

  void WheelsetReport::note(const FoundEquilibrium &found)
  {
    const WheelsetState &state = found.state;
    const auto           bound = [&](const unsigned int k, const double scale) {
      return found.bounds ? std::optional<double>(scale * (*found.bounds)[k])
                                    : std::nullopt;
    };
    const std::string name = named(state.acting);
    const std::string text =
      "shift " + with_bound(1e3 * state.place.shift, bound(0, 1e3), "mm") +
      ", yaw " + with_bound(1e3 * state.place.yaw, bound(1, 1e3), "mrad") +
      ", the axle turns by " +
      with_bound(1e3 * state.place.excess, bound(2, 1e3), "\u2030") +
      " more than V/r0";
    const std::string which =
      found.name.empty() ? name : name + ", " + found.name + " wheelset";
    context.log.message(
      which + ": " + text + "; residual " + significant(found.residual(), 2) +
      " of the axle load, " + std::to_string(found.n_states) + " states on " +
      std::to_string(found.n_bodies) + " sets of bodies so far.");
    const std::string label = wheelset.cases().size() > 1
                                ? "no. " + std::to_string(all.size())
                                : "curve";
    if (found.name.empty())
      {
        context.report.set_finding(label, name + ": " + text);
        for (unsigned int k = 0; k < 2; ++k)
          context.report.set_finding(sides[k],
                                     "wheel, " + told(state.wheels[k]));
      }
    else
      {
        context.report.set_finding(label,
                                   name +
                                     ": frame of the bogie at a shift of " +
                                     millimetres(found.frame[0], 4) + ", yaw " +
                                     significant(1e3 * found.frame[1], 4) +
                                     " mrad");
        context.report.set_finding(
          found.name == "leading" ? "lead" : "trail",
          "wheelset, " + text + "; right-hand wheel, " + told(state.wheels[0]) +
            "; left-hand wheel, " + told(state.wheels[1]));
      }
    if (found.another)
      context.report.set_finding(
        "another",
        "equilibrium has a shift of " +
          millimetres(found.another->place.shift, 4) + " and a yaw of " +
          significant(1e3 * found.another->place.yaw, 4) + " mrad");
  }

  void WheelsetReport::warn(const FoundEquilibrium &found)
  {
    const WheelsetState &state   = found.state;
    const auto           warning = [&](const std::string &text) {
      context.log.warning((found.name.empty()
                                       ? "Wheelset, "
                                       : "The " + found.name + " wheelset, ") +
                          named(state.acting) + ": " + text);
    };
    const double friction  = scene.contact.friction_coefficient;
    unsigned int n_sliding = 0;
    for (unsigned int k = 0; k < 2; ++k)
      {
        const WheelState &wheel = state.wheels[k];
        const std::string name = std::string("the ") + sides[k] + "-hand wheel";
        if (wheel.load < least_load * wheelset.axle_load)
          warning(name + " carries " + significant(wheel.load, 3) +
                  " N, less than a tenth of the axle load.");
        const double ratio = std::abs(lateral_ratio(wheel)),
                     limit = climbing_ratio(wheel.steepest, friction);
        if (std::abs(wheel.steepest) > steep && ratio > limit)
          warning(name + " has Y/Q = " + significant(ratio, 3) +
                  ", more than " + significant(limit, 3) +
                  " by Nadal's formula for its angle of contact: its flange "
                  "may climb the rail.");
        n_sliding += wheel.n_stick == 0;
        if (std::abs(state.acting.curvature) > 1 / narrow_curve &&
            std::abs(wheel.steepest) > steep)
          warning(name +
                  "'s flange touches a rail that is taken as straight: its "
                  "curvature changes the relative one along the track by some "
                  "percent.");
      }
    if (n_sliding == 2)
      warning("all nodes of both wheels slide; how far the wheelset goes does "
              "not follow from friction any more, and its place answers to "
              "small forces.");
    if (std::abs(state.place.yaw) > largest_yaw)
      warning("a yaw of " + significant(1e3 * state.place.yaw, 3) +
              " mrad is beyond 25 mrad, to which contacts were verified.");
  }

  void WheelsetReport::finish()
  {
    context.log.message(table.screen_table({"curve_radius_m",
                                            "wheelset",
                                            "lateral_shift_m",
                                            "yaw_rad",
                                            "right_force_y/load",
                                            "left_force_y/load",
                                            "right_creep_work_J/m",
                                            "left_creep_work_J/m"}));
    warn_of_unknown_errors(context);
    if (scene.inputs->output.plot && all.size() > 1)
      plot();
  }

  void WheelsetReport::plot() const
  {
    const std::string x_label = "curvature of the track (1/km)";
    Figure            figure("Wheelset in curves", x_label, "shift (mm)"),
      yaw("", x_label, "yaw (mrad)"), forces("", x_label, "Y/Q"),
      work("", x_label, "T\u03b3 (N)");
    std::vector<double> x;
    for (const auto &found : all)
      x.push_back(1e3 * found[0].acting.curvature);
    for (unsigned int i = 0; i < all[0].size(); ++i)
      {
        const std::string name = wheelset.name_of(i);
        const auto        draw =
          [&](Figure &panel, const std::string &label, const auto &of) {
            std::vector<double> y;
            for (const auto &found : all)
              y.push_back(of(found[i]));
            panel.add_curve(label, x, y, CurveStyle::line_and_points);
          };
        draw(figure, name, [](const auto &state) {
          return 1e3 * state.place.shift;
        });
        draw(yaw, name, [](const auto &state) {
          return 1e3 * state.place.yaw;
        });
        for (unsigned int k = 0; k < 2; ++k)
          {
            const std::string label =
              (name.empty() ? "" : name + ", ") + sides[k] + "-hand wheel";
            draw(forces, label, [k](const auto &state) {
              return lateral_ratio(state.wheels[k]);
            });
            draw(work, label, [k](const auto &state) {
              return state.wheels[k].creep_work;
            });
          }
      }
    for (const Figure *panel : {&yaw, &forces, &work})
      figure.add_panel(*panel);
    figure.draw(context, "wheelset");
  }
} // namespace RollingContact
