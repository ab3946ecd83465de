#include <deal.II/lac/vector.h>

#include <rolling_contact/base/ranks.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/results/body_fields.h>
#include <rolling_contact/results/interface_fields.h>
#include <rolling_contact/results/result_row.h>
#include <rolling_contact/results/uniqueness_warning.h>
#include <rolling_contact/run/pvd.h>
#include <rolling_contact/time/history_plot.h>
#include <rolling_contact/time/limit_cycle.h>
#include <rolling_contact/time/run_spectra.h>
#include <rolling_contact/time/transient_output.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    std::string numbered(const std::string &name, const std::uint64_t step)
    {
      return name + "-" + zero_padded(step, 7);
    }
  } // namespace

  template <int dim>
  TransientOutput<dim>::TransientOutput(const Situation           &scene,
                                        RunContext                &context,
                                        const Checkpoint          &checkpoint,
                                        const ContactStepper<dim> &stepper)
    : scene(scene)
    , context(context)
    , rows(scene)
    , body_fields(checkpoint.body_fields)
    , interface_fields(checkpoint.interface_fields)
  {
    if (scene.inputs->looks_for_cycles())
      watch.emplace(scene, step_of_history(scene));
    if (context.resume)
      history.emplace(context.folder,
                      history_name,
                      rows.names(),
                      checkpoint.history);
    else
      history.emplace(context.folder, history_name, rows.names());
    if (scene.inputs->sound.estimate)
      sound.emplace(scene, stepper, checkpoint, context);
    if (watch && context.resume) // all ranks, and the root has cut it
      watch->restore(*history);
  }

  template <int dim>
  void TransientOutput<dim>::add_row(const ContactStepper<dim> &stepper,
                                     const StepOutcome         &outcome,
                                     const TransientProgress   &progress)
  {
    const std::vector<double> row = rows.row(stepper, outcome, progress);
    if (watch)
      watch->add_row(rows.names(), row);
    history->add_row(row);
    if (sound)
      sound->add_row(stepper, progress.time);
  }

  template <int dim>
  void TransientOutput<dim>::write_fields(const ContactStepper<dim> &stepper,
                                          const TransientProgress   &progress,
                                          const bool                 last)
  {
    const unsigned int interval = scene.inputs->time.field_interval;
    const bool due = last || (interval > 0 && progress.step % interval == 0);
    const auto written = [&](const std::vector<PvdBlock> &blocks) {
      return !blocks.empty() && blocks.back().time == progress.time;
    };
    if (!due || written(interface_fields) || written(body_fields))
      return;
    PhaseTimer::Scope       phase(context.timer, Phase::fields);
    const SteadyState<dim> &contact = stepper.current();
    if (scene.inputs->output.interface_fields)
      {
        const std::string file = numbered("interface", progress.step) + ".vtu";
        write_interface(scene, contact, context.folder, file);
        interface_fields.push_back({progress.time, 0, "interface", file});
        write_pvd(interface_fields, context.folder, "interface.pvd");
      }
    if (!scene.inputs->output.body_fields)
      return;
    const auto blocks = write_bodies<dim>(
      contact,
      [&](const Side side) {
        return stepper.bodies().displacement(side,
                                             contact.problem,
                                             contact.state);
      },
      [&](const std::string &body) { return numbered(body, progress.step); },
      progress.time,
      context.folder);
    body_fields.insert(body_fields.end(), blocks.begin(), blocks.end());
    write_pvd(body_fields, context.folder, "bodies.pvd");
  }

  template <int dim>
  void
  TransientOutput<dim>::write_checkpoint(const ContactStepper<dim> &stepper,
                                         const TransientProgress   &progress,
                                         const PrmEntries          &files)
  {
    PhaseTimer::Scope phase(context.timer, Phase::checkpoints);
    Checkpoint        checkpoint;
    Ranks::on_root([&]() { checkpoint.history = history->flush(); });
    if (sound)
      checkpoint.modal_velocities = sound->flush();
    checkpoint.tables           = files;
    checkpoint.progress         = progress;
    checkpoint.body_fields      = body_fields;
    checkpoint.interface_fields = interface_fields;
    stepper.save(checkpoint);
    RollingContact::write_checkpoint(checkpoint, context.folder);
  }

  template <int dim>
  void TransientOutput<dim>::finish(const ContactStepper<dim> &stepper,
                                    const TransientProgress   &progress)
  {
    Ranks::on_root([&]() { history->publish(); });
    context.results.set("time_s", progress.time);
    context.results.set("rolled_m", progress.rolled_distance);
    if (const auto velocity = stepper.bodies().wheel_velocity())
      context.results.set("wheel_velocity_m/s", *velocity);
    if (watch)
      measure_cycle(stepper);
    if (sound)
      sound->finish(found_period);
    add_result_row(scene, stepper.current(), context);
    if (!Ranks::is_root()) // who has the history
      return;
    note_largest_load();
    if (scene.inputs->output.plot)
      plot_history(scene, *history, context);
    if (scene.inputs->wants_spectra())
      write_spectra(scene, *history, stepper.eigenvalues(), context);
  }

  template <int dim>
  void TransientOutput<dim>::measure_cycle(const ContactStepper<dim> &stepper)
  {
    const LimitCycle cycle(*watch, stepper.excited());
    cycle.add_columns(context.results);
    cycle.note(context);
    cycle.write_harmonics(context);
    if (scene.inputs->output.plot)
      cycle.draw(context);
    if (cycle.is_periodic())
      found_period = cycle.period();
  }

  template <int dim>
  void TransientOutput<dim>::note_largest_load() const
  {
    const auto  rows = history->columns({"force_time_s", "normal_force_N"});
    const auto &load = rows.at("normal_force_N");
    if (load.empty())
      return;
    const auto [least, largest] = std::minmax_element(load.begin(), load.end());
    // a load that is constant but for rounding has no peak
    const double rounding = 1e-6;
    if (*largest - *least <= rounding * *largest)
      return;
    context.report.set_finding(
      "peak",
      "N = " + significant(*largest, 6) + " N at t = " +
        significant(rows.at("force_time_s")[largest - load.begin()], 6) + " s");
  }

  template class TransientOutput<2>;
  template class TransientOutput<3>;
} // namespace RollingContact
