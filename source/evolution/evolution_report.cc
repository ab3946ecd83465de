#include <fmt/format.h>

#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/evolution/evolution_report.h>
#include <rolling_contact/evolution/profile_film.h>
#include <rolling_contact/run/pvd.h>
#include <rolling_contact/surfaces/profile_writer.h>

#include <cmath>

namespace RollingContact
{
  namespace
  {
    const char duty_file[] = "duty.csv";

    const std::array<std::string, 2> bodies_by_name{{"wheel", "rail"}};

    /// m: of conicities, and of shifts that these are found from
    const double amplitude = 3e-3, shift_step = 0.2e-3;

    Profiles::RadiusDifference radius_difference(const BothWheelsOnRails &both)
    {
      Profiles::RadiusDifference found;
      const int                  n = std::lround(1.2 * amplitude / shift_step);
      for (int k = -n; k <= n; ++k)
        {
          const double shift = k * shift_step;
          const double roll =
            Profiles::resting_roll(*both[0], *both[1], shift, 0.);
          const Profiles::WheelsetPosition position{shift, roll, 0.};
          found.shift.push_back(shift);
          found.difference.push_back(
            both[0]->first_contact(position).rolling_radius -
            both[1]
              ->first_contact(Profiles::mirrored(position))
              .rolling_radius);
        }
      return found;
    }

    double z_at_tape_circle(const Profiles::ProfileCurve &wheel)
    {
      const Profiles::ArcLengthAtY place(wheel);
      return place.covers(0.) ? wheel.at(place(0.)).z : 0.;
    }
  } // namespace

  EvolutionReport::EvolutionReport(const Situation             &scene,
                                   const EvolutionParameters   &section,
                                   const std::vector<DutyCase> &duty,
                                   const RunningSurfaces       &before,
                                   RunContext                  &context)
    : scene(scene)
    , section(section)
    , duty(duty)
    , before(before)
    , context(context)
    , rows(context.folder, duty_file)
  {}

  std::string EvolutionReport::ending(const std::size_t side) const
  {
    return before.n_sides() == 1 ? "" : side == 0 ? "_right" : "_left";
  }

  std::vector<WornSide>
  EvolutionReport::worn(const RunningSurfaces &surfaces) const
  {
    std::vector<WornSide> found(before.n_sides());
    for (std::size_t side = 0; side < found.size(); ++side)
      {
        for (unsigned int body = 0; body < 2; ++body)
          {
            const auto  kind   = wheel_and_rail[body];
            const auto &from   = before.curve(side, body),
                       &to     = surfaces.curve(side, body);
            const auto deepest = Profiles::largest_worn_depth(from, to, kind);
            found[side].bodies[body] = {deepest.depth,
                                        from.at(deepest.s).y,
                                        Profiles::worn_area(from, to, kind)};
          }
        found[side].flange = Profiles::flange_measures(surfaces.curve(side, 0));
      }
    return found;
  }

  void EvolutionReport::set_way(const EvolutionPoint &point,
                                ResultsTable         &table) const
  {
    table.set("step", point.step);
    if (section.wears_wheel())
      table.set("distance_m", point.share * section.distance.value());
    if (section.wears_rail())
      table.set("passages", point.share * section.passages.value());
  }

  void EvolutionReport::add_side(const EvolutionPoint             &point,
                                 const std::size_t                 side,
                                 const WornSide                   &worn,
                                 const Profiles::RadiusDifference &difference)
  {
    ResultsTable &table = context.results;
    set_way(point, table);
    table.set("side",
              before.n_sides() == 1 ? "both"
              : side == 0           ? "right"
                                    : "left");
    for (unsigned int body = 0; body < 2; ++body)
      if (wears(body))
        {
          const std::string &name = bodies_by_name[body];
          const BodyWear    &lost = worn.bodies[body];
          table.set(name + "_depth_m", lost.depth);
          table.set_if(lost.depth > 0., name + "_deepest_y_m", lost.at_y);
          table.set(name + "_worn_area_m2", lost.area);
        }
    if (section.wears_wheel() && worn.flange)
      {
        table.set("flange_height_m", worn.flange->height);
        table.set("flange_thickness_m", worn.flange->thickness);
        table.set("qr_m", worn.flange->qr);
      }
    for (const auto &[column, conicity] :
         {std::pair("conicity_harmonic",
                    Profiles::harmonic_conicity(difference, amplitude)),
          std::pair("conicity_en_15302",
                    Profiles::equivalent_conicity(difference, amplitude))})
      table.set_if(!std::isnan(conicity), column, conicity);
    table.set("step_depth_m", point.depth);
    table.set("step_error_m", point.error);
    table.end_row();
  }

  void EvolutionReport::add_duty(const EvolutionPoint &point,
                                 const DutyStates     &states)
  {
    for (std::size_t j = 0; j < states.size(); ++j)
      for (std::size_t i = 0; i < states[j].summary.wheelsets.size(); ++i)
        {
          const DutySummary           &summary = states[j].summary;
          const DutySummary::Wheelset &state   = summary.wheelsets[i];
          set_way(point, rows);
          rows.set("row", duty[j].name);
          rows.set("share", duty[j].share);
          if (summary.wheelsets.size() > 1)
            rows.set("wheelset", i == 0 ? "leading" : "trailing");
          rows.set_if(state.curvature != 0.,
                      "curve_radius_m",
                      1 / state.curvature);
          rows.set("lateral_shift_m", state.shift);
          rows.set("yaw_rad", state.yaw);
          for (unsigned int k = 0; k < 2; ++k)
            for (const WearingWheel &wheel : summary.wheels)
              if (wheel.wheel == k && wheel.wheelset == i)
                {
                  const std::string side = k == 0 ? "right_" : "left_";
                  rows.set(side + "creep_work_J/m", wheel.creep_work);
                  rows.set(side + "max_pressure_Pa", wheel.max_pressure);
                  rows.set(side + "flash_temperature_K", wheel.flash.largest);
                  rows.set(side + "mean_flash_temperature_K", wheel.flash.mean);
                  rows.set_if(!std::isnan(wheel.centre_of_wear),
                              side + "centre_of_wear_y_m",
                              wheel.centre_of_wear);
                }
          rows.set("residual", state.residual);
          rows.end_row();
        }
    rows.flush();
  }

  void EvolutionReport::add(const EvolutionPoint  &point,
                            const RunningSurfaces &surfaces,
                            const DutyStates      &states)
  {
    const std::vector<WornSide> lost = worn(surfaces);
    const auto difference = radius_difference(surfaces.wheels_on_rails());
    for (std::size_t side = 0; side < lost.size(); ++side)
      add_side(point, side, lost[side], difference);
    add_duty(point, states);
    write_profiles(fmt::format("_{:03}", point.step),
                   {{".txt", ".txt"}},
                   Profiles::ProfileFormat::columns,
                   point.share,
                   surfaces);
    shown.push_back({point.share, surfaces});
    if (scene.inputs->output.interface_fields)
      add_to_film();
  }

  void EvolutionReport::add_to_film()
  {
    std::vector<PvdBlock> film;
    for (std::size_t k = 0; k < shown.size(); ++k)
      for (unsigned int side = 0; side < before.n_sides(); ++side)
        for (unsigned int body = 0; body < 2; ++body)
          if (wears(body))
            {
              const std::string name = bodies_by_name[body] + ending(side),
                                file = fmt::format("{}_{:03}.vtu", name, k);
              film.push_back(
                {way(shown[k].first), 2 * side + body, name, file});
              if (k >= n_filmed)
                write_strip(file, shown[k].second, side, body);
            }
    n_filmed = shown.size();
    write_pvd(film, context.folder, "profiles.pvd");
  }

  void EvolutionReport::write_strip(const std::string     &file,
                                    const RunningSurfaces &surfaces,
                                    const unsigned int     side,
                                    const unsigned int     body) const
  {
    const double tape_circle =
      surfaces.wheels_on_rails()[side]->tape_circle_place();
    context.folder.write_atomically(file,
                                    worn_strip(before.curve(side, body),
                                               surfaces.curve(side, body),
                                               body == 0 ? tape_circle : 0.,
                                               side == 0 ? 1. : -1.));
  }

  void EvolutionReport::save(EvolutionState &state) const
  {
    state.results = context.results.csv();
    state.rows    = rows.csv();
    for (const auto &[share, surfaces] : shown)
      {
        state.shares.push_back(share);
        state.curves.push_back(surfaces.curves());
      }
  }

  void EvolutionReport::restore(const EvolutionState &state)
  {
    const auto names = [](const std::string &name, std::size_t) {
      return std::any(name);
    };
    context.results.restore(state.results, evolution_state_file, {});
    rows.restore(state.rows, evolution_state_file, {{"row", names}});
    for (std::size_t k = 0; k < state.shares.size(); ++k)
      shown.push_back({state.shares[k], before.with(state.curves[k])});
  }

  Profiles::ProfileCurve
  EvolutionReport::section_of(const Profiles::ProfileCurve &curve,
                              const unsigned int            body) const
  {
    if (body == 0)
      return curve;
    const auto turned =
      curve.turned(std::atan(scene.profiles.slope_of_inclination()));
    const auto top = turned.at(turned.highest());
    return turned.shifted(-top.y, -top.z);
  }

  std::string EvolutionReport::title_of(const Profiles::ProfileCurve &curve,
                                        const unsigned int            body,
                                        const double                  radius,
                                        const double share) const
  {
    const std::string what =
      bodies_by_name[body] + " after " + section.text_of_way(share) + "; ";
    if (body == 0)
      return what + "radius at the tape circle " +
             significant(radius + z_at_tape_circle(curve), 7) + " m";
    const auto face =
      Profiles::y_of_gauge_face(curve, scene.profiles.gauge_height);
    return what + (face ? "gauge " + significant(2 * *face, 7) + " m"
                        : "its gauge face ends above the gauge height");
  }

  void
  EvolutionReport::write_profiles(const std::string                &name,
                                  const std::array<std::string, 2> &endings,
                                  const Profiles::ProfileFormat     format,
                                  const double                      share,
                                  const RunningSurfaces            &surfaces)
  {
    for (std::size_t side = 0; side < before.n_sides(); ++side)
      for (unsigned int body = 0; body < 2; ++body)
        if (wears(body))
          {
            const auto &curve = surfaces.curve(side, body);
            context.folder.write_atomically(
              bodies_by_name[body] + name + ending(side) + endings[body],
              Profiles::profile_text(
                section_of(curve, body),
                wheel_and_rail[body],
                format,
                title_of(curve,
                         body,
                         surfaces.wheels_on_rails()[side]->wheel_radius(),
                         share)));
          }
  }

  double EvolutionReport::way(const double share) const
  {
    return section.wears_wheel() ? share * section.distance.value() / 1e3
                                 : share * section.passages.value();
  }

  void EvolutionReport::state_error() const
  {
    double largest = 0.;
    for (std::size_t k = 0; k < context.results.n_rows(); ++k)
      {
        const double depth =
          context.results.number(k, "step_depth_m").value_or(0.);
        if (depth > 0.)
          largest =
            std::max(largest,
                     context.results.number(k, "step_error_m").value_or(0.) /
                       depth);
      }
    if (largest > 0.)
      context.report.errors.push_back(
        {"wear of a step",
         largest,
         "its depth",
         "a step compared with two halves; the result is extrapolated from "
         "both",
         true,
         "without the errors of meshes, laws and duty"});
  }

  void EvolutionReport::finish(const std::string &why_ended)
  {
    const auto &[share, surfaces] = shown.back();
    write_profiles("",
                   {{".whl", ".ban"}},
                   Profiles::ProfileFormat::miniprof,
                   share,
                   surfaces);
    write_profiles("",
                   {{".prw", ".prr"}},
                   Profiles::ProfileFormat::simpack,
                   share,
                   surfaces);
    context.log.message(context.results.screen_table({"step",
                                                      "distance_m",
                                                      "passages",
                                                      "side",
                                                      "wheel_depth_m",
                                                      "rail_depth_m",
                                                      "flange_height_m",
                                                      "flange_thickness_m",
                                                      "qr_m",
                                                      "conicity_en_15302",
                                                      "step_error_m"}));
    const auto lost = worn(surfaces);
    for (std::size_t side = 0; side < lost.size(); ++side)
      for (unsigned int body = 0; body < 2; ++body)
        if (wears(body))
          {
            const BodyWear &it   = lost[side].bodies[body];
            std::string     text = millimetres(it.depth, 4) +
                               " deep at y = " + millimetres(it.at_y, 3) +
                               ", " + significant(it.area * 1e6, 4) +
                               " mm\u00b2 of its section";
            if (body == 0 && lost[side].flange)
              text += "; Sh " + millimetres(lost[side].flange->height, 4) +
                      ", Sd " + millimetres(lost[side].flange->thickness, 4) +
                      ", qR " + millimetres(lost[side].flange->qr, 4);
            const std::string of = ending(side);
            context.report.set_finding(
              bodies_by_name[body] + (of.empty() ? of : ' ' + of.substr(1, 1)),
              text);
          }
    context.report.set_finding("end", why_ended);
    state_error();
    if (scene.inputs->output.plot && shown.size() > 1)
      {
        plot_over_way();
        plot_profiles();
      }
  }
} // namespace RollingContact
