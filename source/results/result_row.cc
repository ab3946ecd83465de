#include <rolling_contact/contact/invariants.h>
#include <rolling_contact/contact/patch_area.h>
#include <rolling_contact/contact/uniqueness.h>
#include <rolling_contact/pair/friction_heat.h>
#include <rolling_contact/results/cover_columns.h>
#include <rolling_contact/results/error_bounds.h>
#include <rolling_contact/results/line_contact.h>
#include <rolling_contact/results/nodal_values.h>
#include <rolling_contact/results/profile_columns.h>
#include <rolling_contact/results/reference_2d.h>
#include <rolling_contact/results/reference_3d.h>
#include <rolling_contact/results/result_row.h>
#include <rolling_contact/results/rough_state.h>
#include <rolling_contact/results/state_damage.h>

#include <algorithm>

namespace RollingContact
{
  namespace
  {
    void set_creepage_columns(const Creepages &creepages, ResultsTable &table)
    {
      table.set("creepage_x", creepages.x);
      table.set("creepage_y", creepages.y);
      table.set("spin_1/m", creepages.spin);
    }

    /**
     * Forces and sizes; none of a state that was not solved.
     */
    void set_resultant_columns(const Resultants &result,
                               const PatchAreas &areas,
                               const bool        solved,
                               ResultsTable     &table)
    {
      const auto set = [&](const std::string &column, const auto value) {
        table.set_if(solved, column, value);
      };
      set("normal_force_N", result.normal_force);
      set("force_x_N", result.force_x);
      set("force_y_N", result.force_y);
      set("spin_moment_Nm", result.spin_moment);
      set("traction_coefficient", result.traction_coefficient);
      set("max_pressure_Pa", result.max_pressure);
      set("contact_area_m2", areas.contact);
      set("stick_area_m2", areas.stick);
      set("centre_x_m", result.centre_x);
      set("centre_y_m", result.centre_y);
      set("half_width_x_m", result.half_width_x);
      set("half_width_y_m", result.half_width_y);
      set("nodes_in_contact", result.n_touching);
      set("creep_work_J/m", result.creep_work);
      set("dissipation_J/m", result.dissipation);
      set("energy_error", result.energy_error());
    }

    /**
     * Where creepages were found for forces, how far the errors of these put
     * them off.
     */
    template <int dim>
    void set_creepage_bounds(const PairSpec         &scene,
                             const SteadyState<dim> &steady,
                             const ErrorBounds      &bounds,
                             ResultsTable           &table)
    {
      const AskedForces &forces = steady.problem.loads.forces;
      if (!forces.any())
        return;
      table.set("force_rounds", steady.solver.force_rounds);
      const std::vector<double> margins =
        creepage_bounds(scene, steady, bounds);
      std::size_t n = 0;
      for (const auto &[column, asked] :
           {std::pair("bound_creepage_x", forces.x.has_value()),
            std::pair("bound_creepage_y", forces.y.has_value()),
            std::pair("bound_spin_1/m", forces.moment.has_value())})
        if (asked)
          {
            const bool known = n < margins.size();
            table.set_if(known, column, known ? margins[n++] : 0.);
          }
    }

    /**
     * Bounds of the errors of a steady state; empty where none is known.
     */
    template <int dim>
    void set_bound_columns(const PairSpec         &scene,
                           const SteadyState<dim> &steady,
                           ResultsTable           &table)
    {
      const bool        judged = steady.solver.converged && !steady.restored;
      const ErrorBounds bounds =
        judged ? error_bounds(scene, steady) : ErrorBounds();
      if (steady.problem.n_tangential() > 0)
        table.set("bound_force/muN", bounds.force);
      if (steady.problem.n_tangential() > 1)
        table.set("bound_moment/muNa", bounds.moment);
      table.set("bound_max_pressure", bounds.max_pressure);
      if (!steady.problem.loads.normal_load)
        table.set("bound_normal_force", bounds.normal_force);
      if (steady.problem.n_tangential() > 0)
        table.set("bound_dissipation", bounds.dissipation);
      set_creepage_bounds(scene, steady, bounds, table);
    }

    /**
     * Where the heat of friction goes, and how hot it makes the patch in the
     * mean and at most.
     */
    template <int dim>
    void set_heat_columns(const PairSpec         &scene,
                          const SteadyState<dim> &steady,
                          ResultsTable           &table)
    {
      const auto flash = patch_temperature(scene, steady.problem, steady.state);
      if (!flash)
        return;
      const HeatFlows flows =
        heat_flows(scene,
                   steady.problem,
                   steady.state,
                   steady.result.dissipation *
                     std::abs(scene.contact.rolling_speed()));
      table.set("flash_temperature_K", flash->largest);
      table.set("mean_flash_temperature_K", flash->mean);
      table.set("surface_temperature_K",
                contact_temperature(scene) + flash->largest);
      table.set("heat_to_wheel_W", flows.wheel);
      table.set("heat_to_rail_W", flows.rail);
    }

    void set_solver_columns(const SolverReport &solver, ResultsTable &table)
    {
      table.set("residual_normal", solver.residual.normal);
      table.set("residual_tangential", solver.residual.tangential);
      table.set("iterations", solver.iterations);
      table.set("normal_solves", solver.normal_solves);
      table.set("tangential_solves", solver.tangential_solves);
      table.set("passes", solver.passes);
      table.set("corrections", solver.corrections);
      table.set("solver",
                solver.solver,
                SolvedBy{solver.used_fallback || !solver.edges_settled});
      table.set("converged", solver.converged);
    }

    /**
     * Where friction follows the slip or its own heat.
     */
    template <int dim>
    void set_falling_friction_columns(const SteadyState<dim> &steady,
                                      ResultsTable           &table)
    {
      if (steady.solver.friction_rounds > 0)
        table.set("friction_rounds", steady.solver.friction_rounds);
      if (steady.problem.loads.friction_law && !steady.restored &&
          steady.problem.n_tangential() > 0)
        table.set("several_solutions_ratio",
                  uniqueness(steady.problem, steady.state).ratio);
    }

    void set_invariant_columns(const Invariants &invariants,
                               ResultsTable     &table)
    {
      for (const auto &invariant : invariants.named())
        table.set("invariant_" + invariant.first, invariant.second);
    }

    void set_reference_columns(const PairSpec       &scene,
                               const SteadyState<2> &steady,
                               ResultsTable         &table)
    {
      if (steady.result.normal_force <= 0. || !scene.has_plain_surfaces())
        return;
      const Reference2D reference = reference_2d(scene, steady);
      const Errors2D    errors    = errors_2d(scene, steady, reference);
      table.set("reference_half_width_x_m", reference.hertz.half_width);
      table.set("reference_max_pressure_Pa", reference.hertz.max_pressure);
      table.set("error_pressure_l2", errors.pressure_l2);
      if (errors.normal_force)
        {
          table.set("reference_normal_force_N", *reference.normal_force);
          table.set("error_normal_force", *errors.normal_force);
        }
      if (!reference.carter || !reference.carter_is_exact)
        return;
      table.set("reference_force_x/muN", reference.carter->force_ratio());
      table.set("error_force_x/muN", errors.force);
      table.set("error_traction_l2", errors.traction_l2);
      table.set("error_sawtooth", errors.sawtooth);
      table.set("error_stick_boundary_elements", errors.stick_boundary);
    }

    void set_ellipse_columns(const PairSpec       &scene,
                             const SteadyState<3> &steady,
                             ResultsTable         &table)
    {
      if (steady.result.normal_force <= 0. || !scene.has_plain_surfaces())
        return;
      const Reference3D reference =
        reference_3d(scene,
                     steady.result.normal_force,
                     steady.problem.loads.creepages);
      table.set("reference_half_width_x_m", reference.hertz.half_width_x);
      table.set("reference_half_width_y_m", reference.hertz.half_width_y);
      table.set("reference_max_pressure_Pa", reference.hertz.max_pressure);
      table.set("reference_approach_m", reference.hertz.approach);
      if (steady.problem.n_tangential() == 0)
        return;
      for (const NamedForce &theory : reference.forces)
        {
          table.set(theory.column + "_force_x_N", theory.x);
          table.set(theory.column + "_force_y_N", theory.y);
          if (theory.spin_moment)
            table.set(theory.column + "_spin_moment_Nm", *theory.spin_moment);
        }
    }

    /**
     * Change and extrapolation over refinement levels, where there are any.
     */
    template <int dim>
    void set_level_columns(const SteadyState<dim> &steady, ResultsTable &table)
    {
      if (!steady.change || !steady.limit)
        return;
      const auto &limit = steady.limit->limit.values;
      table.set("change", *steady.change);
      table.set("estimated_error", steady.limit->value_error);
      table.set("extrapolated_normal_force_N",
                limit[LevelValues::normal_force]);
      table.set("extrapolated_force_x_N", limit[LevelValues::force_x]);
      table.set("extrapolated_force_y_N", limit[LevelValues::force_y]);
      table.set("extrapolated_approach_m", limit[LevelValues::approach]);
      table.set("extrapolation_error", steady.limit->limit_error);
    }
  } // namespace

  SolvedBy solved_by(const std::string &name)
  {
    const auto has = [&](const char *part) {
      return name.find(part) != std::string::npos;
    };
    return {has(", fallback") || has(", edges")};
  }

  template <int dim>
  void add_result_row(const PairSpec         &scene,
                      const SteadyState<dim> &steady,
                      RunContext             &context)
  {
    ResultsTable &table = context.results;
    table.set("level", steady.level);
    table.set("dofs", steady.pair->bodies().n_unknowns());
    table.set("contact_nodes", steady.problem.n_nodes());
    table.set("elements_across", steady.grading.elements_across());
    table.set("patch_offset", steady.grading.offset);
    table.set("slip_operator",
              name_of(steady.problem.operators.slip_operator().kind()));
    set_creepage_columns(steady.problem.loads.creepages, table);
    const bool solved = steady.solver.converged;
    table.set_if(solved || !steady.problem.loads.normal_load,
                 "approach_m",
                 steady.state.approach);
    if (steady.contact_stiffness)
      table.set("contact_stiffness_N/m", *steady.contact_stiffness);
    set_resultant_columns(steady.result,
                          solved ? patch_areas(steady.problem, steady.state)
                                 : PatchAreas(),
                          solved,
                          table);
    set_roughness_columns(steady, table);
    if (steady.problem.operators.time_scaling().rate == 0.)
      set_bound_columns(scene, steady, table);
    if (solved)
      set_heat_columns(scene, steady, table);
    set_solver_columns(steady.solver, table);
    set_falling_friction_columns(steady, table);
    const Invariants found =
      steady.restored ? Invariants() : invariants(steady.problem, steady.state);
    if (!steady.restored && solved)
      set_invariant_columns(found, table);
    if (solved)
      {
        if constexpr (dim == 2)
          {
            set_reference_columns(scene, steady, table);
            set_cover_columns(scene, steady, table);
          }
        else
          {
            set_ellipse_columns(scene, steady, table);
            set_line_contact_columns(scene, steady, table);
          }
        set_profile_columns(scene, steady, table);
        if constexpr (dim == 3)
          set_damage_columns(scene, steady, table);
        set_level_columns(steady, table);
      }
    table.set("wall_s", steady.wall_s);
    table.end_row();
    if (solved)
      check_invariants(found, scene.solver.controls.tolerance, "The state: ");
  }

  void add_open_row(const PairSpec &scene, ResultsTable &table)
  {
    table.set("level", 0);
    set_creepage_columns(scene.contact.creepages, table);
    table.set("approach_m", scene.contact.approach.value_or(0.));
    set_resultant_columns(Resultants(), PatchAreas(), true, table);
    table.set("solver", "none", SolvedBy());
    table.set("converged", true);
    table.end_row();
  }

  template void
  add_result_row(const PairSpec &, const SteadyState<2> &, RunContext &);
  template void
  add_result_row(const PairSpec &, const SteadyState<3> &, RunContext &);
} // namespace RollingContact
