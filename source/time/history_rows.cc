#include <rolling_contact/time/history_rows.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  /**
   * What a row of history.csv tells.
   */
  struct HistoryStep
  {
    const ContactProblem    &problem;
    const ContactState      &state;
    const Resultants        &result;
    const StepOutcome       &outcome;
    const TransientProgress &progress;
  };

  namespace
  {
    double energy_balance_error(const HistoryStep &step)
    {
      const StepEnergy &energy = step.outcome.energy;
      const double      scale  = std::max({energy.kinetic + energy.strain,
                                           std::abs(step.progress.supplied_energy),
                                           step.progress.friction_energy});
      return scale > 0. ? step.progress.energy_error / scale : 0.;
    }

    /**
     * The columns of history.csv; one more with a free wheel, two with surfaces
     * that move, and one where friction falls.
     */
    std::vector<HistoryRows::Column> columns_of(const Situation &scene)
    {
      using S = const HistoryStep &;
      std::vector<HistoryRows::Column> columns{
        {"step", [](S s) -> double { return s.progress.step; }},
        {"time_s", [](S s) { return s.progress.time; }},
        {"force_time_s",
         [](S s) { return s.progress.time - s.outcome.force_lag; }},
        {"rolled_m", [](S s) { return s.progress.rolled_distance; }},
        {"approach_m", [](S s) { return s.state.approach; }},
        {"creepage_x", [](S s) { return s.problem.loads.creepages.x; }},
        {"creepage_y", [](S s) { return s.problem.loads.creepages.y; }},
        {"spin_1/m", [](S s) { return s.problem.loads.creepages.spin; }},
        {"speed_m/s", [](S s) { return s.outcome.speed; }},
        {"normal_force_N", [](S s) { return s.result.normal_force; }},
        {"force_x_N", [](S s) { return s.result.force_x; }},
        {"force_y_N", [](S s) { return s.result.force_y; }},
        {"spin_moment_Nm", [](S s) { return s.result.spin_moment; }},
        {"traction_coefficient",
         [](S s) { return s.result.traction_coefficient; }},
        {"max_pressure_Pa", [](S s) { return s.result.max_pressure; }},
        {"nodes_in_contact", [](S s) -> double { return s.result.n_touching; }},
        {"nodes_sticking", [](S s) -> double { return s.outcome.n_sticking; }},
        {"impacts", [](S s) -> double { return s.outcome.n_impacts; }},
        {"kinetic_J", [](S s) { return s.outcome.energy.kinetic; }},
        {"strain_J", [](S s) { return s.outcome.energy.strain; }},
        {"supplied_J", [](S s) { return s.progress.supplied_energy; }},
        {"friction_J", [](S s) { return s.progress.friction_energy; }},
        {"damping_J", [](S s) { return s.progress.damping_energy; }},
        {"numerical_J", [](S s) { return s.progress.numerical_energy; }},
        {"energy_balance_error", &energy_balance_error},
        {"iterations",
         [](S s) -> double { return s.outcome.solver.iterations; }},
        {"parts", [](S s) -> double { return s.outcome.n_parts; }}};
      if (scene.inputs->time.inertia)
        for (const HistoryRows::Column &column :
             {HistoryRows::Column{"velocity_x_m/s",
                                  [](S s) {
                                    return s.outcome.contact_velocity[0];
                                  }},
              HistoryRows::Column{"velocity_y_m/s",
                                  [](S s) {
                                    return s.outcome.contact_velocity[1];
                                  }},
              HistoryRows::Column{"velocity_z_m/s", [](S s) {
                                    return s.outcome.contact_velocity[2];
                                  }}})
          columns.push_back(column);
      if (scene.wheel.moves_along_z())
        columns.push_back({"wheel_velocity_m/s",
                           [](S s) { return *s.outcome.wheel_velocity; }});
      if (scene.surfaces.in_use())
        {
          columns.push_back(
            {"surface_height_m", [](S s) { return s.outcome.surface_height; }});
          columns.push_back(
            {"surface_J", [](S s) { return s.progress.surface_energy; }});
        }
      if (scene.inputs->friction_response() == FrictionResponse::patch_mean)
        columns.push_back(
          {"friction_share", [](S s) { return s.outcome.friction_share; }});
      if (scene.contact.falling_friction())
        columns.push_back({"several_solutions_ratio",
                           [](S s) { return s.outcome.several.ratio; }});
      return columns;
    }

    /**
     * The columns with the velocities of the named points, m/s, in the order of
     * StepOutcome::point_velocity.
     */
    std::vector<std::string> columns_of_points(const Situation &scene)
    {
      std::vector<std::string> columns;
      for (const Side side : both_sides)
        for (const VelocityPoint &point : scene.inputs->velocity_points(side))
          for (const char axis :
               std::string(scene.dimension == 3 ? "xyz" : "xz"))
            columns.push_back(velocity_column(point.name, axis));
      return columns;
    }
  } // namespace

  HistoryRows::HistoryRows(const Situation &scene)
    : columns(columns_of(scene))
  {
    for (const Column &column : columns)
      all_names.push_back(column.name);
    for (const std::string &column : columns_of_points(scene))
      all_names.push_back(column);
  }

  template <int dim>
  std::vector<double> HistoryRows::row(const ContactStepper<dim> &stepper,
                                       const StepOutcome         &outcome,
                                       const TransientProgress &progress) const
  {
    const SteadyState<dim> &contact = stepper.current();
    const HistoryStep       step{
      contact.problem, contact.state, contact.result, outcome, progress};
    std::vector<double> row;
    for (const Column &column : columns)
      row.push_back(column.value(step));
    row.insert(row.end(),
               outcome.point_velocity.begin(),
               outcome.point_velocity.end());
    return row;
  }

  template std::vector<double>
  HistoryRows::row(const ContactStepper<2> &,
                   const StepOutcome &,
                   const TransientProgress &) const;
  template std::vector<double>
  HistoryRows::row(const ContactStepper<3> &,
                   const StepOutcome &,
                   const TransientProgress &) const;
} // namespace RollingContact
