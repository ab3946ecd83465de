#include <deal.II/lac/vector.h>

#include <rolling_contact/analyses/adaptive_levels.h>
#include <rolling_contact/analyses/error_of_result.h>
#include <rolling_contact/analyses/line_reference.h>
#include <rolling_contact/analyses/quasi_static.h>
#include <rolling_contact/analyses/result_row.h>
#include <rolling_contact/analyses/small_strain.h>
#include <rolling_contact/analyses/traction_plot.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/output/body_fields.h>
#include <rolling_contact/output/interface_fields.h>
#include <rolling_contact/output/pvd.h>

#include <cmath>

namespace RollingContact
{
  namespace
  {
    std::string
    name_of(const Side side)
    {
      return side == Side::wheel ? "wheel" : "rail";
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
        "The contact solver did not converge: " + steady.solver.reason +
        ". Natural residual " + scientific(steady.solver.residual.worst(), 3) +
        ", required " + scientific(scene.solver.controls.tolerance, 3) +
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
  }



  template <int dim>
  void
  describe_bodies(const SteadyState<dim> &steady, RunContext &context)
  {
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
    warn_of_large_strains(strain_measures(scene, result, steady.state.approach),
                          log);
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
      if (result.normal_force > 0. && scene.contact.roughness.empty())
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
  describe_factors(const SteadyState<2> &, RunContext &);
  template void
  describe_factors(const SteadyState<3> &, RunContext &);
  template void
  describe_bodies(const SteadyState<2> &, RunContext &);
  template void
  describe_bodies(const SteadyState<3> &, RunContext &);
} // namespace RollingContact
