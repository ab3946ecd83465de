#include <deal.II/base/exceptions.h>
#include <deal.II/base/multithread_info.h>

#include <rolling_contact_revision.h>

#include <rolling_contact/algebra/factorisation.h>
#include <rolling_contact/base/collective_failure.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/memory.h>
#include <rolling_contact/base/platform.h>
#include <rolling_contact/base/ranks.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/program/analysis_table.h>
#include <rolling_contact/program/command_line.h>
#include <rolling_contact/program/scene_reader.h>
#include <rolling_contact/run/run_context.h>
#include <rolling_contact/run/written_names.h>
#include <rolling_contact/wheelset/fmu_server.h>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <sstream>

namespace RollingContact
{
  namespace
  {
    RunReport describe_program(const CommandLine &command_line)
    {
      RunReport report;
      report.version      = ROLLING_CONTACT_VERSION;
      report.git_revision = ROLLING_CONTACT_GIT_REVISION;
      report.libraries    = library_versions();
      report.libraries.emplace_back("deal.II", DEAL_II_PACKAGE_VERSION);
      report.n_ranks      = Ranks::count();
      report.command_line = command_line.words;
      return report;
    }

    /**
     * "1 factorisations, 146 columns condensed, 2 static solves".
     */
    BuiltItem work_done()
    {
      const Factorisation::Work work = Factorisation::work_done();
      BuiltItem                 object;
      object.object =
        std::to_string(work.n_factorisations) + " factorisations, " +
        std::to_string(work.n_condensed_columns) + " columns condensed, " +
        std::to_string(work.n_solves) + " static solves";
      return object;
    }

    void warn_about_blas(Log &log)
    {
      const BlasLibrary blas = loaded_blas();
      if (blas.is_reference)
        log.warning("The slow " + blas.name +
                    " is loaded; libopenblas0-pthread factorises about eleven "
                    "times faster.");
    }

    void summarise_run(RunContext &context)
    {
      context.log.detail(context.report.objects_summary());
      context.log.detail(context.timer.summary());
      context.log.message(
        context.report.summary(context.timer,
                               context.folder.get_path().string()));
    }

    /** How a run ends with an exception. */
    struct Failure
    {
      ExitCode    code;
      RunStatus   status;
      std::string message;
    };

    /** Exit code and message for the exception that is being handled. */
    Failure current_failure()
    {
      const auto internal = [](const std::string &reason) {
        return Failure{ExitCode::internal_error,
                       RunStatus::failed,
                       "internal error: " + reason};
      };
      try
        {
          throw;
        }
      catch (const InputError &error)
        {
          return {ExitCode::input_error, RunStatus::failed, error.what()};
        }
      catch (const ConvergenceError &error)
        {
          return {ExitCode::not_converged,
                  RunStatus::not_converged,
                  error.what()};
        }
      catch (const Interrupted &error)
        {
          return {ExitCode::not_converged,
                  RunStatus::interrupted,
                  error.what()};
        }
      catch (const std::bad_alloc &)
        {
          return {ExitCode::input_error,
                  RunStatus::failed,
                  "There is not enough memory: " +
                    human_bytes(static_cast<double>(peak_memory())) +
                    " were in use, " +
                    human_bytes(static_cast<double>(available_memory())) +
                    " are left, within any limit (ulimit -v). Take fewer "
                    "Mesh/Elements across patch or a larger Mesh/Growth."};
        }
      catch (const dealii::ExceptionBase &error)
        {
          std::ostringstream reason;
          error.print_info(reason);
          return internal(reason.str());
        }
      catch (const std::exception &error)
        {
          return internal(error.what());
        }
      catch (...)
        {
          return internal("unknown exception");
        }
    }

    /**
     * Start anew, or continue what a run left.
     */
    void open_folder(const Situation   &scene,
                     const CommandLine &command_line,
                     RunFolder         &folder)
    {
      if (!command_line.resume)
        folder.open();
      else if (analysis_kind(scene.inputs->analysis.name).resumption)
        folder.reopen(
          analysis_kind(scene.inputs->analysis.name).resumption(scene));
      else
        throw InputError(
          "--resume with Analysis = " + scene.inputs->analysis.name +
          ": only a transient run, a table, a stability map and "
          "limit cycles can be resumed.");
    }

    bool can_be_resumed(const Situation &scene, const RunFolder &folder)
    {
      const auto &resumption =
        analysis_kind(scene.inputs->analysis.name).resumption;
      return resumption &&
             has_checkpoint(folder.get_path(), resumption(scene).checkpoint);
    }

    /**
     * Run a scene in its folder; run.json tells how it ended, however it ends.
     */
    void run_scene(const SceneInput &input, const CommandLine &command_line)
    {
      const Situation &scene = input.scene;
      PhaseTimer       timer;
      timer.charge_start();
      RunFolder folder(command_line.output_folder.empty()
                         ? RunFolder::default_path(command_line.prm_file)
                         : std::filesystem::path(command_line.output_folder),
                       input.original,
                       input.used);
      open_folder(scene, command_line, folder);
      Log          log(scene.inputs->output.verbosity);
      ResultsTable results(folder);
      RunReport    report = describe_program(command_line);
      RunContext   context{
        folder, results, report, timer, log, command_line.resume};
      const auto write = [&](const RunStatus status) {
        report.warnings = log.warnings();
        report.objects.push_back(work_done());
        report.write(folder, status, timer);
      };
      // what cannot be written must not hide why the run failed
      const auto finish_failed = [&](const RunStatus status) {
        for (const std::function<void()> &action :
             {std::function<void()>([&]() { results.flush(); }),
              std::function<void()>([&]() { write(status); })})
          try
            {
              action();
            }
          catch (const std::exception &error)
            {
              log.error(error.what());
            }
      };
      report.write(folder, RunStatus::running, timer);
      warn_about_blas(log);
      for (const std::string &warning : input.warnings)
        log.warning(warning);
      try
        {
          reserve_blas_memory(scene.body_threads);
          const AnalysisKind &kind = analysis_kind(scene.inputs->analysis.name);
          (scene.dimension == 2 ? kind.in_2d : kind.in_3d)(scene, context)
            ->run();
          if (report.n_ranks > 1)
            report.rank_totals = totals_of_ranks(timer);
          results.flush();
        }
      catch (...)
        {
          const Failure failure = current_failure();
          Ranks::all_ranks_failed(failure.code);
          report.failure = failure.message;
          finish_failed(failure.status);
          if (failure.status == RunStatus::interrupted &&
              can_be_resumed(scene, folder))
            log.message("The same command with --resume goes on from here.");
          throw;
        }
      write(RunStatus::done);
      summarise_run(context);
    }

    /**
     * Throws InputError, on all ranks, if their parameters differ or the
     * analysis is for one rank.
     */
    void check_for_ranks(const SceneInput &input)
    {
      if (Ranks::count() == 1)
        return;
      if (!Ranks::agree(input.used))
        throw InputError("The ranks read different parameters: start them with "
                         "one command line and a file that all of them see.");
      const AnalysisTraits &analysis = input.scene.inputs->analysis;
      if (!analysis.on_ranks)
        throw InputError(
          "Analysis = " + analysis.name + " runs on one rank, not on " +
          std::to_string(Ranks::count()) + ": start it without mpirun.");
    }

    void run(const int argc, const char *const *argv)
    {
      const CommandLine command_line(argc, argv);
      const auto        say = [](const std::string &text) {
        if (Ranks::is_root())
          std::cout << text << std::flush;
      };
      if (command_line.show_help)
        say(CommandLine::help());
      else if (command_line.show_version)
        say("rolling-contact " ROLLING_CONTACT_VERSION
            " (" ROLLING_CONTACT_GIT_REVISION ")\n");
      else if (command_line.print_parameters)
        say(documented_parameters());
      else if (command_line.print_json)
        say(parameters_as_json());
      else
        {
          const SceneInput input = read_scene(command_line);
          check_for_ranks(input);
          if (command_line.serves_fmu)
            serve_fmu(input.scene);
          else if (command_line.validate_only)
            {
              Log log(Verbosity::normal);
              for (const std::string &warning : input.warnings)
                log.warning(warning);
              say(command_line.prm_file + ": valid\n");
            }
          else
            run_scene(input, command_line);
        }
    }
  } // namespace
} // namespace RollingContact

int main(int argc, char *argv[])
{
  using namespace RollingContact;
  int code = static_cast<int>(ExitCode::converged);
  try
    {
      Ranks::abort_all_ranks_on_terminate();
      install_interrupt_handlers(); // before MPI starts threads
      // In a process that was not launched MPI_Init_thread and MPI_Finalize
      // take 0.35 s, 0.05 s of it CPU, as does deal.II's MPI_InitFinalize;
      // --version without them takes 0.2 s.
      if (Ranks::launched())
        Ranks::start();
      use_one_solver_thread();
      dealii::MultithreadInfo::set_thread_limit(1);
      run(argc, argv);
    }
  catch (...)
    {
      const Failure failure = current_failure();
      code = Ranks::end_failed_run(failure.code, failure.message);
    }
  Ranks::finish();
  if (address_space_left() < room_for_threads)
    {
      std::cout << std::flush;
      std::_Exit(code);
    }
  return code;
}
