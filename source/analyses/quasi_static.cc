#include <rolling_contact/analyses/quasi_static.h>
#include <rolling_contact/analyses/solve_to_target.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/contact/contact_problem_file.h>
#include <rolling_contact/results/bodies_report.h>
#include <rolling_contact/results/body_fields.h>
#include <rolling_contact/results/cover_columns.h>
#include <rolling_contact/results/interface_fields.h>
#include <rolling_contact/results/line_contact.h>
#include <rolling_contact/results/lines_across.h>
#include <rolling_contact/results/patch_output.h>
#include <rolling_contact/results/profile_columns.h>
#include <rolling_contact/results/profile_plot.h>
#include <rolling_contact/results/result_row.h>
#include <rolling_contact/results/state_damage.h>
#include <rolling_contact/results/state_report.h>
#include <rolling_contact/run/pvd.h>

namespace RollingContact
{
  template <int dim>
  void QuasiStatic<dim>::run()
  {
    if (!bodies_touch(scene))
      {
        report_no_contact();
        return;
      }
    StateDemands demands;
    demands.pair.displacements = scene.inputs->output.body_fields;
    demands.pair.bulk_errors   = true;
    const SteadyState<dim> steady =
      solve_to_target<dim>(scene,
                           demands,
                           TargetDemands(),
                           context,
                           [&](const SteadyState<dim> &level) {
                             add_result_row(scene, level, context);
                           });
    describe_bodies(steady, context);
    context.report.objects.push_back(
      {"body fields (one backward solve each)",
       scene.inputs->output.body_fields,
       0,
       0.,
       scene.inputs->output.body_fields ? "" : "Output/Body fields"});
    write_fields(steady);
    summarise(steady);
    if (!steady.solver.converged)
      throw ConvergenceError(
        "The contact solver did not converge: " +
        shortfall(steady.solver, scene.solver.controls.tolerance) +
        "; its history is in residuals.csv." +
        (scene.solver.solver == "automatic"
           ? ""
           : " Try Contact/Solver = automatic."));
  }

  template <int dim>
  void QuasiStatic<dim>::report_no_contact()
  {
    add_open_row(scene, context.results);
    context.log.message("The bodies do not touch: all forces are zero.");
  }

  template <int dim>
  void QuasiStatic<dim>::write_residuals(const SteadyState<dim> &steady) const
  {
    std::string history = "iteration,residual_normal,residual_tangential\n";
    for (std::size_t k = 0; k < steady.solver.history.size(); ++k)
      history += std::to_string(k + 1) + "," +
                 scientific(steady.solver.history[k].normal, 9) + "," +
                 scientific(steady.solver.history[k].tangential, 9) + "\n";
    context.folder.write_atomically("residuals.csv", history);
  }

  template <int dim>
  void QuasiStatic<dim>::write_fields(const SteadyState<dim> &steady)
  {
    PhaseTimer::Scope phase(context.timer, Phase::fields);
    RunFolder        &folder = context.folder;
    if (!steady.solver.converged)
      write_residuals(steady);
    if (scene.inputs->output.interface_fields)
      {
        write_interface(scene, steady, folder, "interface.vtu");
        write_pvd({{0., 0, "interface", "interface.vtu"}},
                  folder,
                  "interface.pvd");
        write_nodes(scene, steady, context);
      }
    if (scene.inputs->output.contact_problem &&
        !steady.problem.loads.friction_law)
      folder.write_atomically(
        "contact_problem.h5",
        contact_problem_bytes(steady.pair->trace(),
                              scene.contact.contact_matrices,
                              steady.problem,
                              steady.state,
                              folder.get_path() / "contact_problem.h5"));
    if (scene.inputs->output.body_fields)
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
      if (scene.inputs->output.plot && steady.result.normal_force > 0.)
        plot_line_tractions(scene, steady, context);
    if constexpr (dim == 3)
      {
        write_lines_across(scene, steady, context);
        if (scene.inputs->output.plot)
          {
            plot_patch(scene, steady, context);
            plot_profiles(scene, steady, context);
            plot_shakedown_map(scene, steady, context);
          }
      }
  }

  template <int dim>
  void QuasiStatic<dim>::summarise(const SteadyState<dim> &steady)
  {
    const std::string work = "Solver: " + work_of_solver(steady.solver) + ".";
    steady.solver.used_fallback ? context.log.message(work)
                                : context.log.detail(work);
    StateReview<dim> review(scene, context);
    review.add(steady);
    review.warn(steady);
    note_state(steady, context.report);
    note_hot_friction(scene, steady, context.report);
    note_profiles(scene, steady, context.report);
    if constexpr (dim == 3)
      {
        note_line_contact(scene, steady, context.report);
        note_damage(scene, steady, context.report);
      }
    else
      note_cover(scene, steady, context.report);
    warn_of_missed_target(scene, context);
  }

  template class QuasiStatic<2>;
  template class QuasiStatic<3>;

  AnalysisKind quasi_static_kind()
  {
    AnalysisKind kind =
      kind_of<QuasiStatic>("quasi-static", "one steady rolling state");
    kind.has_one_state = true;
    return kind;
  }
} // namespace RollingContact
