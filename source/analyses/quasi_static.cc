#include <rolling_contact/analyses/quasi_static.h>
#include <rolling_contact/assessment/linearity_check.h>
#include <rolling_contact/assessment/result_error.h>
#include <rolling_contact/assessment/uniqueness_warning.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/report/result_row.h>
#include <rolling_contact/report/state_fields.h>
#include <rolling_contact/report/state_summary.h>
#include <rolling_contact/report/traction_plot.h>
#include <rolling_contact/run/pvd.h>
#include <rolling_contact/state/adaptive_levels.h>
#include <rolling_contact/state/solved_state.h>

namespace RollingContact
{
  template <int dim>
  void
  QuasiStatic<dim>::run()
  {
    if (estimate_patch(scene).half_width_x <= 0.)
      {
        report_no_contact();
        return;
      }
    const SteadyState<dim> steady = AdaptiveLevels<dim>(scene, context)
                                      .run([&](const SteadyState<dim> &level) {
                                        add_result_row(scene, level, context);
                                      });
    describe_bodies(steady, context);
    context.report.objects.push_back(
      {"body fields (one backward solve each)",
       scene.output.body_fields,
       0,
       0.,
       scene.output.body_fields ? "" : "Output/Body fields"});
    write_fields(steady);
    summarise(steady);
    if (!steady.solver.converged)
      throw ConvergenceError(
        "The contact solver did not converge: " +
        shortfall(steady.solver, scene.solver.controls.tolerance) +
        "; its history is in residuals.csv. Try Contact/Solver = automatic.");
    note_error(scene, steady, context.report);
  }



  template <int dim>
  void
  QuasiStatic<dim>::report_no_contact()
  {
    add_open_row(scene, context.results);
    context.log.message("The bodies do not touch: all forces are zero.");
  }



  template <int dim>
  void
  describe_factors(const SteadyState<dim> &steady, RunContext &context)
  {
    auto &objects = context.report.objects;
    for (const Side side : {Side::wheel, Side::rail})
      {
        const bool is_twin = side == Side::rail && steady.pair->twins();
        BuiltItem  object;
        object.object = name_of(side) + ": mesh, stiffness, solver";
        object.built  = steady.pair->is_elastic(side) && !is_twin;
        if (!object.built)
          object.reason = is_twin ? "mirror image of the wheel" : "rigid";
        else if (const ElasticBody<dim> *body = steady.pair->body(side))
          {
            object.bytes   = body->solver_memory();
            object.seconds = body->assembly_seconds() + body->solver_seconds();
            context.log.detail(name_of(side) + ": " + body->description());
          }
        objects.push_back(object);
      }
  }



  template <int dim>
  void
  describe_surfaces(const RollingPair<dim> &pair, RunContext &context)
  {
    for (const Side side : {Side::wheel, Side::rail})
      {
        const SurfaceNote &note = pair.note_on_surface(side);
        if (!note.text.empty())
          context.log.message(note.text);
        if (!note.warning.empty())
          context.log.warning(note.warning);
      }
  }



  template <int dim>
  void
  describe_bodies(const SteadyState<dim> &steady, RunContext &context)
  {
    if (!steady.pair->reason_for_solver().empty())
      {
        const bool direct = steady.pair->body_solver() == BodySolver::direct;
        const std::string choice =
          "Body solver = automatic takes " +
          std::string(direct ? "direct" : "distributed") + ": " +
          steady.pair->reason_for_solver() + ".";
        direct ? context.log.detail(choice) : context.log.message(choice);
      }
    describe_surfaces(*steady.pair, context);
    describe_factors(steady, context);
    auto       &objects = context.report.objects;
    const auto &problem = steady.problem;
    objects.push_back(
      {"compliance W", true, problem.W.memory_consumption(), 0., ""});
    objects.push_back({"tangential compliance, B1",
                       problem.n_tangential > 0,
                       0,
                       0.,
                       problem.n_tangential > 0 ? "" : "frictionless"});
    objects.push_back({"mass, damping, B2", false, 0, 0., "quasi-static"});
    if (problem.friction_law)
      objects.push_back({dim == 2 ? "reference: Carter"
                                  : "references: Shen-Hedrick-Elkins, FASTSIM",
                         false,
                         0,
                         0.,
                         "they have constant friction"});
  }



  template <int dim>
  void
  QuasiStatic<dim>::write_residuals(const SteadyState<dim> &steady) const
  {
    std::string history = "iteration,residual_normal,residual_tangential\n";
    for (std::size_t k = 0; k < steady.solver.history.size(); ++k)
      history += std::to_string(k + 1) + "," +
                 scientific(steady.solver.history[k].normal, 9) + "," +
                 scientific(steady.solver.history[k].tangential, 9) + "\n";
    context.folder.write_atomically("residuals.csv", history);
  }



  template <int dim>
  void
  QuasiStatic<dim>::write_fields(const SteadyState<dim> &steady)
  {
    PhaseTimer::Scope phase(context.timer, Phase::fields);
    RunFolder        &folder = context.folder;
    if (!steady.solver.converged)
      write_residuals(steady);
    if (scene.output.interface_fields)
      {
        write_interface(scene, steady, folder, "interface.vtu");
        write_pvd({{0., 0, "interface", "interface.vtu"}},
                  folder,
                  "interface.pvd");
      }
    if (scene.output.body_fields)
      write_pvd(write_bodies<dim>(
                  steady,
                  [&](const Side side) {
                    return steady.pair->displacement(side,
                                                     steady.problem,
                                                     steady.state);
                  },
                  [](const std::string &body) { return body; },
                  0.,
                  folder),
                folder,
                "bodies.pvd");
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
    const std::string   work   = "Solver: " + work_of_solver(solver) + ".";
    solver.used_fallback ? log.message(work) : log.detail(work);
    warn_of_few_nodes(result.n_touching, log);
    warn_of_large_strains(strain_measures(scene, result, steady.state.approach),
                          log);
    UniquenessSummary worst;
    worst.add(uniqueness(steady.problem, steady.state), steady.problem, "");
    warn_of_non_uniqueness(scene, worst, log);
    note_state(scene, steady, context.report);
  }



  template class QuasiStatic<2>;
  template class QuasiStatic<3>;
  template void
  describe_factors(const SteadyState<2> &, RunContext &);
  template void
  describe_factors(const SteadyState<3> &, RunContext &);
  template void
  describe_surfaces(const RollingPair<2> &, RunContext &);
  template void
  describe_surfaces(const RollingPair<3> &, RunContext &);
  template void
  describe_bodies(const SteadyState<2> &, RunContext &);
  template void
  describe_bodies(const SteadyState<3> &, RunContext &);
} // namespace RollingContact
