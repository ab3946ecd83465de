#include <deal.II/base/exceptions.h>

#include <rolling_contact/analyses/accuracy_study.h>
#include <rolling_contact/analyses/creep_curve.h>
#include <rolling_contact/analyses/quasi_static.h>
#include <rolling_contact/analyses/scene_reader.h>
#include <rolling_contact/analyses/time_study.h>
#include <rolling_contact/analyses/transient.h>
#include <rolling_contact/base/command_line.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/memory.h>
#include <rolling_contact/base/platform.h>
#include <rolling_contact/elasticity/factorisation.h>
#include <rolling_contact/output/checkpoint.h>

#include <iostream>
#include <sstream>

namespace RollingContact
{
  namespace
  {
    RunReport
    describe_program(const CommandLine &command_line)
    {
      RunReport report;
      report.version      = ROLLING_CONTACT_VERSION;
      report.git_revision = ROLLING_CONTACT_GIT_REVISION;
      report.libraries    = library_versions();
      report.libraries.emplace_back("deal.II", DEAL_II_PACKAGE_VERSION);
      report.command_line = command_line.words;
      return report;
    }



    /**
     * "1 factorisations, 146 columns condensed, 2 static solves".
     */
    BuiltObject
    work_done()
    {
      const Factorisation::Work work = Factorisation::work_done();
      BuiltObject               object;
      object.object =
        std::to_string(work.n_factorisations) + " factorisations, " +
        std::to_string(work.n_condensed_columns) + " columns condensed, " +
        std::to_string(work.n_solves) + " static solves";
      return object;
    }



    template <int dim>
    void
    run_analysis(SceneParameters &scene, RunContext &context)
    {
      if (scene.analysis == "creep curve")
        CreepCurve<dim>(scene, context).run();
      else if (scene.analysis == "accuracy study")
        {
          if (scene.study.varies_time_step())
            TimeStudy<dim>(scene, context).run();
          else
            AccuracyStudy<dim>(scene, context).run();
        }
      else if (scene.analysis == "transient")
        Transient<dim>(scene, context).run();
      else
        QuasiStatic<dim>(scene, context).run();
    }



    void
    warn_about_blas(Log &log)
    {
      const BlasLibrary blas = loaded_blas();
      if (blas.is_reference)
        log.warning("The slow " + blas.name +
                    " is loaded; libopenblas0-pthread factorises about eleven "
                    "times faster.");
    }



    void
    summarise_run(RunContext &context)
    {
      context.log.detail(context.report.objects_summary());
      context.log.detail(context.timer.summary());
      const auto total = PhaseTimer::total(context.timer.rows());
      context.log.message(human_seconds(total.wall_seconds) + " (" +
                          human_seconds(total.cpu_seconds) + " CPU), " +
                          human_bytes(peak_memory()) + "; files in " +
                          context.folder.get_path().string());
      context.log.message(context.report.error_line(context.timer));
    }



    /**
     * Start anew, or continue what a transient run left.
     */
    void
    open_folder(const SceneParameters &scene,
                const CommandLine     &command_line,
                RunFolder             &folder)
    {
      if (!command_line.resume)
        folder.open();
      else if (scene.analysis == "transient")
        folder.reopen(
          {TimeParameters::free_on_resume(), checkpoint_name, history_name});
      else
        throw InputError("--resume with Analysis = " + scene.analysis +
                         ": only a transient run can be resumed.");
    }



    /**
     * Run a scene in its folder; run.json tells how it ended, however it ends.
     */
    void
    run_scene(SceneParameters   &scene,
              const SceneText   &text,
              const CommandLine &command_line)
    {
      PhaseTimer timer;
      RunFolder  folder(command_line.output_folder.empty()
                         ? RunFolder::default_path(command_line.prm_file)
                         : std::filesystem::path(command_line.output_folder),
                       text.original,
                       text.used);
      open_folder(scene, command_line, folder);
      Log          log(scene.output.verbosity());
      ResultsTable results(folder);
      RunReport    report = describe_program(command_line);
      RunContext   context{
        folder, results, report, timer, log, command_line.resume};
      const auto finish = [&](const RunStatus status) {
        report.warnings = log.warnings();
        report.objects.push_back(work_done());
        results.flush();
        report.write(folder, status, timer);
      };
      report.write(folder, RunStatus::running, timer);
      warn_about_blas(log);
      try
        {
          if (scene.dimension == 2)
            run_analysis<2>(scene, context);
          else
            run_analysis<3>(scene, context);
        }
      catch (const ConvergenceError &)
        {
          finish(RunStatus::not_converged);
          throw;
        }
      catch (const Interrupted &)
        {
          finish(RunStatus::interrupted);
          throw;
        }
      catch (...)
        {
          finish(RunStatus::failed);
          throw;
        }
      finish(RunStatus::done);
      summarise_run(context);
    }



    void
    run(const int argc, const char *const *argv)
    {
      const CommandLine command_line(argc, argv);
      if (command_line.show_help)
        std::cout << CommandLine::help();
      else if (command_line.show_version)
        std::cout << "rolling-contact " << ROLLING_CONTACT_VERSION << " ("
                  << ROLLING_CONTACT_GIT_REVISION << ")\n";
      else if (command_line.print_parameters)
        std::cout << documented_parameters();
      else
        {
          SceneParameters scene;
          const SceneText text = read_scene(command_line, scene);
          if (command_line.validate_only)
            std::cout << command_line.prm_file << ": valid\n";
          else
            run_scene(scene, text, command_line);
        }
    }



    int
    exit_code(const ExitCode code, const std::string &message)
    {
      std::cerr << wrapped("rolling-contact: " + message) << std::endl;
      return static_cast<int>(code);
    }
  } // namespace
} // namespace RollingContact



int
main(int argc, char *argv[])
{
  using namespace RollingContact;
  try
    {
      use_one_solver_thread();
      install_interrupt_handlers();
      dealii::MultithreadInfo::set_thread_limit(1);
      run(argc, argv);
      return static_cast<int>(ExitCode::converged);
    }
  catch (const InputError &error)
    {
      return exit_code(ExitCode::input_error, error.what());
    }
  catch (const ConvergenceError &error)
    {
      return exit_code(ExitCode::not_converged, error.what());
    }
  catch (const Interrupted &error)
    {
      return exit_code(ExitCode::not_converged, error.what());
    }
  catch (const dealii::ExceptionBase &error)
    {
      std::ostringstream reason;
      error.print_info(reason);
      return exit_code(ExitCode::internal_error,
                       "internal error: " + reason.str());
    }
  catch (const std::exception &error)
    {
      return exit_code(ExitCode::internal_error,
                       std::string("internal error: ") + error.what());
    }
}
