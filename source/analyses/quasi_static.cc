#include <deal.II/lac/vector.h>

#include <rolling_contact/analyses/ellipse_reference.h>
#include <rolling_contact/analyses/line_reference.h>
#include <rolling_contact/analyses/quasi_static.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/output/body_fields.h>
#include <rolling_contact/output/interface_fields.h>
#include <rolling_contact/output/pvd.h>
#include <rolling_contact/output/svg_plot.h>

#include <cmath>

namespace RollingContact
{
  namespace
  {
    void
    set_resultant_columns(const Resultants &result, ResultsTable &table)
    {
      table.set("normal_force_N", result.normal_force);
      table.set("force_x_N", result.force_x);
      table.set("force_y_N", result.force_y);
      table.set("spin_moment_Nm", result.spin_moment);
      table.set("traction_coefficient", result.traction_coefficient);
      table.set("max_pressure_Pa", result.max_pressure);
      table.set("contact_area_m2", result.contact_area);
      table.set("stick_area_m2", result.stick_area);
      table.set("half_width_x_m", result.half_width_x);
      table.set("half_width_y_m", result.half_width_y);
      table.set("nodes_in_contact", result.n_touching);
      table.set("creep_work_J/m", result.creep_work);
      table.set("dissipation_J/m", result.dissipation);
      table.set("energy_error", result.energy_error());
    }



    void
    set_solver_columns(const SolverReport &solver, ResultsTable &table)
    {
      table.set("residual_normal", solver.residual.normal);
      table.set("residual_tangential", solver.residual.tangential);
      table.set("iterations", solver.iterations);
      table.set("normal_solves", solver.normal_solves);
      table.set("tangential_solves", solver.tangential_solves);
      table.set("passes", solver.passes);
      table.set("solver", solver.solver);
      table.set("converged", solver.converged);
    }



    void
    set_reference_columns(const SceneParameters &scene,
                          const SteadyState<2>  &steady,
                          ResultsTable          &table)
    {
      if (steady.result.normal_force <= 0.)
        return;
      const LineReference reference = line_reference(scene, steady);
      const LineErrors    errors    = line_errors(scene, steady, reference);
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



    void
    set_ellipse_columns(const SceneParameters &scene,
                        const SteadyState<3>  &steady,
                        ResultsTable          &table)
    {
      if (steady.result.normal_force <= 0.)
        return;
      const EllipseReference reference =
        ellipse_reference(scene,
                          steady.result.normal_force,
                          {steady.creepage_x, steady.creepage_y, steady.spin});
      table.set("reference_half_width_x_m", reference.hertz.half_width_x);
      table.set("reference_half_width_y_m", reference.hertz.half_width_y);
      table.set("reference_max_pressure_Pa", reference.hertz.max_pressure);
      table.set("reference_approach_m", reference.hertz.approach);
      if (steady.problem.n_tangential == 0)
        return;
      table.set("kalker_force_x_N", reference.linear.x);
      table.set("kalker_force_y_N", reference.linear.y);
      table.set("kalker_spin_moment_Nm", reference.linear.spin_moment);
      table.set("shen_force_x_N", reference.saturated.x);
      table.set("shen_force_y_N", reference.saturated.y);
    }
  } // namespace



  template <int dim>
  void
  add_result_row(const SceneParameters  &scene,
                 const SteadyState<dim> &steady,
                 RunContext             &context)
  {
    ResultsTable &table      = context.results;
    std::size_t   n_unknowns = 0;
    for (const Side side : {Side::wheel, Side::rail})
      if (steady.pair->body(side) != nullptr &&
          !(side == Side::rail && steady.pair->twins()))
        n_unknowns += steady.pair->body(side)->n_unknowns();
    table.set("level", 0);
    table.set("dofs", n_unknowns);
    table.set("contact_nodes", steady.problem.n_nodes);
    table.set("elements_across", steady.elements_across);
    table.set("patch_offset", steady.grading.offset);
    table.set("slip_operator", steady.slip_operator);
    table.set("creepage_x", steady.creepage_x);
    table.set("creepage_y", steady.creepage_y);
    table.set("spin_1/m", steady.spin);
    table.set("approach_m", steady.state.approach);
    set_resultant_columns(steady.result, table);
    set_solver_columns(steady.solver, table);
    if constexpr (dim == 2)
      set_reference_columns(scene, steady, table);
    else
      set_ellipse_columns(scene, steady, table);
    table.set("wall_s", steady.wall_s);
    table.end_row();
  }



  namespace
  {
    std::string
    name_of(const Side side)
    {
      return side == Side::wheel ? "wheel" : "rail";
    }



    /**
     * p/p0 and q/(mu p0) along the patch, with Hertz and Carter.
     */
    void
    plot_line_tractions(const SceneParameters &scene,
                        const SteadyState<2>  &steady,
                        RunFolder             &folder)
    {
      const LineReference reference = line_reference(scene, steady);
      const double        a         = reference.hertz.half_width,
                   p0               = reference.hertz.max_pressure,
                   bound            = scene.contact.friction_coefficient * p0;
      const bool     friction       = steady.problem.n_tangential > 0;
      const unsigned n_fine         = 1000;
      const double   extent         = 1.15;

      std::vector<double> x, pressure, traction, lower_bound;
      for (unsigned int i = 0; i < steady.problem.n_nodes; ++i)
        {
          const double at = steady.problem.positions[i][0] / a;
          if (std::abs(at) > extent)
            continue;
          x.push_back(at);
          pressure.push_back(steady.state.pressure[i] / p0);
          traction.push_back(friction ? steady.state.traction[i] / bound : 0.);
          lower_bound.push_back(
            std::copysign(pressure.back(), steady.result.force_x));
        }
      std::vector<double> fine_x, hertz, carter;
      for (unsigned int k = 0; k <= n_fine; ++k)
        {
          fine_x.push_back(extent * (2. * k / n_fine - 1));
          hertz.push_back(reference.hertz.pressure(fine_x.back() * a) / p0);
          if (reference.carter)
            carter.push_back(reference.carter->traction(fine_x.back() * a) /
                             bound);
        }

      SvgPlot plot(friction
                     ? "T / (\u03bcN) = " +
                         significant(steady.result.force_x /
                                       (scene.contact.friction_coefficient *
                                        steady.result.normal_force),
                                     4) +
                         " at creepage " + significant(steady.creepage_x, 4)
                     : "Frictionless contact",
                   "x / a, material flows " +
                     std::string(scene.contact.flow() > 0 ? "to the right"
                                                          : "to the left"),
                   "p / p\u2080,   q / (\u03bcp\u2080)");
      if (reference.carter)
        {
          const auto stick = reference.carter->stick_interval();
          if (stick.second > stick.first)
            plot.add_band("stick (Carter)", stick.first / a, stick.second / a);
        }
      plot.add_curve("Hertz", fine_x, hertz, CurveStyle::reference);
      if (reference.carter)
        plot.add_curve("Carter", fine_x, carter, CurveStyle::reference);
      plot.add_curve("pressure p", x, pressure, CurveStyle::points);
      if (friction)
        {
          plot.add_curve("traction q on the wheel",
                         x,
                         traction,
                         CurveStyle::points);
          plot.add_curve("bound \u03bcp", x, lower_bound, CurveStyle::line);
        }
      plot.write(folder, "tractions.svg");
    }
  } // namespace



  template <int dim>
  void
  QuasiStatic<dim>::run()
  {
    if (estimate_patch(scene).half_width_x <= 0.)
      {
        report_no_contact();
        return;
      }
    const SteadyState<dim> steady = solve_steady_state<dim>(scene, context);
    describe_bodies(steady, context);
    context.report.objects.push_back(
      {"body fields (one backward solve each)",
       scene.output.body_fields,
       0,
       0.,
       scene.output.body_fields ? "" : "Output/Body fields"});
    add_result_row(scene, steady, context);
    write_fields(steady);
    summarise(steady);
    if (!steady.solver.converged)
      throw ConvergenceError(
        "The contact solver did not converge: " + steady.solver.reason +
        ". Natural residual " + scientific(steady.solver.residual.worst(), 3) +
        ", required " + scientific(scene.solver.controls.tolerance, 3) +
        "; its history is in residuals.csv. Try Contact/Solver = automatic.");
  }



  template <int dim>
  void
  QuasiStatic<dim>::report_no_contact()
  {
    ResultsTable &table = context.results;
    table.set("level", 0);
    table.set("creepage_x", scene.contact.creepage_x);
    table.set("creepage_y", scene.contact.creepage_y);
    table.set("spin_1/m", scene.contact.spin);
    table.set("approach_m", scene.contact.approach().value_or(0.));
    set_resultant_columns(Resultants(), table);
    table.set("solver", std::string("none"));
    table.set("converged", true);
    table.end_row();
    context.log.message("The bodies do not touch: all forces are zero.");
  }



  template <int dim>
  void
  describe_bodies(const SteadyState<dim> &steady, RunContext &context)
  {
    auto &objects = context.report.objects;
    for (const Side side : {Side::wheel, Side::rail})
      {
        const ElasticBody<dim> *body = steady.pair->body(side);
        BuiltObject             object;
        object.object = name_of(side) + ": mesh, stiffness, factor";
        object.built =
          body != nullptr && !(side == Side::rail && steady.pair->twins());
        if (!object.built)
          object.reason =
            body == nullptr ? "rigid" : "mirror image of the wheel";
        else
          {
            const auto &size = body->factorisation()->size();
            object.bytes     = size.memory_consumption();
            object.seconds =
              body->assembly_seconds() + size.analysis_s + size.factor_s;
            context.log.message(
              name_of(side) + ": " + std::to_string(body->n_unknowns()) +
              " unknowns; factorisation " + human_seconds(size.factor_s) +
              ", condensation on " + std::to_string(steady.problem.n_nodes) +
              " contact nodes " + human_seconds(size.condensation_s) +
              ": together " +
              significant(1 + size.condensation_s / size.factor_s, 3) +
              " factorisations.");
          }
        objects.push_back(object);
      }
    const auto &problem = steady.problem;
    objects.push_back({"tangential compliance, B1",
                       problem.n_tangential > 0,
                       problem.W.memory_consumption(),
                       0.,
                       problem.n_tangential > 0 ? "" : "frictionless"});
    objects.push_back({"mass, damping, B2", false, 0, 0., "quasi-static"});
  }



  template <int dim>
  void
  QuasiStatic<dim>::write_fields(const SteadyState<dim> &steady)
  {
    PhaseTimer::Scope phase(context.timer, "fields and plots");
    RunFolder        &folder = context.folder;
    if (!steady.solver.converged)
      {
        std::string history = "iteration,residual_normal,residual_tangential\n";
        for (std::size_t k = 0; k < steady.solver.history.size(); ++k)
          history += std::to_string(k + 1) + "," +
                     scientific(steady.solver.history[k].normal, 9) + "," +
                     scientific(steady.solver.history[k].tangential, 9) + "\n";
        folder.write_atomically("residuals.csv", history);
      }
    if (scene.output.interface_fields)
      {
        const BodyGeometry rail = scene.rail.geometry();
        write_interface_fields<dim>(
          steady.pair->trace(),
          steady.problem,
          steady.state,
          [&](const double x, const double y) {
            return rail.surface_height(x, y);
          },
          folder,
          "interface.vtu");
        write_pvd({{0., 0, "interface", "interface.vtu"}},
                  folder,
                  "interface.pvd");
      }
    if (scene.output.body_fields)
      {
        std::vector<PvdBlock> blocks;
        for (const Side side : {Side::wheel, Side::rail})
          if (steady.pair->body(side) != nullptr)
            {
              const bool        is_wheel = side == Side::wheel;
              const std::string file     = name_of(side) + ".vtu";
              write_body_fields<dim>(
                *steady.pair->body(side),
                steady.pair->displacement(side, steady.problem, steady.state),
                {is_wheel, is_wheel ? -steady.state.approach : 0.},
                folder,
                file);
              blocks.push_back({0.,
                                static_cast<unsigned int>(blocks.size()),
                                name_of(side),
                                file});
            }
        write_pvd(blocks, folder, "bodies.pvd");
      }
    if constexpr (dim == 2)
      if (scene.output.plot && steady.result.normal_force > 0.)
        plot_line_tractions(scene, steady, folder);
  }



  template <int dim>
  void
  QuasiStatic<dim>::summarise(const SteadyState<dim> &steady)
  {
    const Resultants   &result = steady.result;
    const SolverReport &solver = steady.solver;
    Log                &log    = context.log;
    log.message(
      "solver: " + solver.solver + ", " + std::to_string(solver.normal_solves) +
      " normal and " + std::to_string(solver.tangential_solves) +
      " tangential solves in " + std::to_string(solver.passes) +
      " passes; natural residual " + scientific(solver.residual.normal, 2) +
      " normal, " + scientific(solver.residual.tangential, 2) + " tangential.");
    if (result.n_touching < 5)
      log.warning("Only " + std::to_string(result.n_touching) +
                  " nodes touch: the patch is unresolved, take more elements "
                  "(Mesh/Elements across patch).");
    if (const double span = std::abs(steady.state.approach);
        result.half_width_x > 0.1 * pair_constants(scene).relative_radius)
      log.warning(
        "The half-width is " +
        significant(result.half_width_x / pair_constants(scene).relative_radius,
                    2) +
        " of the relative radius, at an approach of " + significant(span, 3) +
        " m: beyond the small strains that linear elasticity holds "
        "for.");
    log.message("approach " + significant(steady.state.approach * 1e3, 5) +
                " mm, N = " + significant(result.normal_force, 6) +
                " N, T = (" + significant(result.force_x, 6) + ", " +
                significant(result.force_y, 6) +
                ") N, |T|/N = " + significant(result.traction_coefficient, 5));
    log.message(
      "patch: half-width " + significant(result.half_width_x * 1e3, 5) +
      " mm, peak pressure " + significant(result.max_pressure * 1e-6, 5) +
      " MPa, " + std::to_string(result.n_touching) + " nodes touch, stick on " +
      significant(result.contact_area > 0.
                    ? 100 * result.stick_area / result.contact_area
                    : 0.,
                  3) +
      " % of the area");
    if constexpr (dim == 2)
      if (result.normal_force > 0.)
        {
          const LineReference reference = line_reference(scene, steady);
          const LineErrors    errors    = line_errors(scene, steady, reference);
          if (errors.normal_force)
            log.message("load against the exact clamped discs: " +
                        significant(100 * *errors.normal_force, 3) + " %");
          if (reference.carter && reference.carter_is_exact)
            log.message("force against Carter: " + scientific(errors.force, 2) +
                        " mu N; traction L2 error " +
                        scientific(errors.traction_l2, 2) + " mu p0");
        }
  }



  template class QuasiStatic<2>;
  template class QuasiStatic<3>;
  template void
  describe_bodies(const SteadyState<2> &, RunContext &);
  template void
  describe_bodies(const SteadyState<3> &, RunContext &);
  template void
  add_result_row(const SceneParameters &, const SteadyState<3> &, RunContext &);
  template void
  add_result_row(const SceneParameters &, const SteadyState<2> &, RunContext &);
} // namespace RollingContact
