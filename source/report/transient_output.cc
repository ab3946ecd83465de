#include <deal.II/lac/vector.h>

#include <rolling_contact/assessment/uniqueness_warning.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/parallel/ranks.h>
#include <rolling_contact/plot/svg_plot.h>
#include <rolling_contact/report/result_row.h>
#include <rolling_contact/report/state_fields.h>
#include <rolling_contact/report/transient_output.h>
#include <rolling_contact/run/pvd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace RollingContact
{
  namespace
  {
    const std::vector<std::string> columns = {"step",
                                              "time_s",
                                              "rolled_m",
                                              "approach_m",
                                              "creepage_x",
                                              "creepage_y",
                                              "spin_1/m",
                                              "speed_m/s",
                                              "normal_force_N",
                                              "force_x_N",
                                              "force_y_N",
                                              "spin_moment_Nm",
                                              "traction_coefficient",
                                              "max_pressure_Pa",
                                              "nodes_in_contact",
                                              "nodes_sticking",
                                              "impacts",
                                              "kinetic_J",
                                              "strain_J",
                                              "supplied_J",
                                              "friction_J",
                                              "damping_J",
                                              "numerical_J",
                                              "energy_balance_error",
                                              "iterations",
                                              "parts"};



    /**
     * Columns of a CSV file by their place, as many rows as there are.
     */
    std::vector<std::vector<double>>
    read_columns(const std::filesystem::path    &path,
                 const std::vector<std::size_t> &places)
    {
      std::vector<std::vector<double>> values(places.size());
      std::ifstream                    file(path);
      std::string                      line, cell;
      std::getline(file, line);
      while (std::getline(file, line))
        {
          std::istringstream  row(line);
          std::vector<double> cells;
          while (std::getline(row, cell, ','))
            cells.push_back(std::stod(cell));
          for (std::size_t k = 0; k < places.size(); ++k)
            values[k].push_back(cells.at(places[k]));
        }
      return values;
    }



    /**
     * One more where friction falls.
     */
    std::vector<std::string>
    columns_of(const SceneParameters &scene)
    {
      std::vector<std::string> names = columns;
      if (scene.contact.falling_friction())
        names.push_back("several_solutions_ratio");
      return names;
    }



    std::size_t
    place(const std::string &column)
    {
      return std::find(columns.begin(), columns.end(), column) -
             columns.begin();
    }



    std::string
    numbered(const std::string &name, const std::uint64_t step)
    {
      const std::string digits = std::to_string(step);
      return name + "-" +
             std::string(digits.size() < 7 ? 7 - digits.size() : 0, '0') +
             digits;
    }
  } // namespace



  template <int dim>
  TransientOutput<dim>::TransientOutput(const SceneParameters &scene,
                                        RunContext            &context,
                                        const Checkpoint      &record)
    : scene(scene)
    , context(context)
  {
    if (context.resume)
      history.emplace(context.folder,
                      history_name,
                      columns_of(scene),
                      record.history);
    else
      history.emplace(context.folder, history_name, columns_of(scene));
  }



  template <int dim>
  void
  TransientOutput<dim>::add_row(const ContactStepper<dim> &stepper,
                                const StepOutcome         &outcome,
                                const Checkpoint          &record)
  {
    const SteadyState<dim> &contact = stepper.current();
    const Resultants       &result  = contact.result;
    const double            scale =
      std::max({outcome.energy.kinetic + outcome.energy.strain,
                std::abs(record.supplied_energy),
                record.friction_energy});
    std::vector<double> row{double(record.step),
                            record.time,
                            record.rolled_distance,
                            contact.state.approach,
                            contact.problem.creepages.x,
                            contact.problem.creepages.y,
                            contact.problem.creepages.spin,
                            outcome.speed,
                            result.normal_force,
                            result.force_x,
                            result.force_y,
                            result.spin_moment,
                            result.traction_coefficient,
                            result.max_pressure,
                            double(result.n_touching),
                            double(outcome.n_sticking),
                            double(outcome.n_impacts),
                            outcome.energy.kinetic,
                            outcome.energy.strain,
                            record.supplied_energy,
                            record.friction_energy,
                            record.damping_energy,
                            record.numerical_energy,
                            scale > 0. ? record.energy_error / scale : 0.,
                            double(outcome.solver.iterations),
                            double(outcome.n_parts)};
    if (scene.contact.falling_friction())
      row.push_back(outcome.several.ratio);
    history->add_row(row);
  }



  template <int dim>
  void
  TransientOutput<dim>::write_fields(const ContactStepper<dim> &stepper,
                                     Checkpoint                &record,
                                     const bool                 last)
  {
    const unsigned int interval = scene.time.field_interval;
    const bool due     = last || (interval > 0 && record.step % interval == 0);
    const auto written = [&](const std::vector<PvdBlock> &blocks) {
      return !blocks.empty() && blocks.back().time == record.time;
    };
    if (!due || written(record.interface_fields) || written(record.body_fields))
      return;
    PhaseTimer::Scope       phase(context.timer, Phase::fields);
    const SteadyState<dim> &contact = stepper.current();
    if (scene.output.interface_fields)
      {
        const std::string file = numbered("interface", record.step) + ".vtu";
        write_interface(scene, contact, context.folder, file);
        record.interface_fields.push_back({record.time, 0, "interface", file});
        write_pvd(record.interface_fields, context.folder, "interface.pvd");
      }
    if (!scene.output.body_fields)
      return;
    const auto blocks = write_bodies<dim>(
      contact,
      [&](const Side side) {
        return stepper.bodies().displacement(side,
                                             contact.problem,
                                             contact.state);
      },
      [&](const std::string &body) { return numbered(body, record.step); },
      record.time,
      context.folder);
    record.body_fields.insert(record.body_fields.end(),
                              blocks.begin(),
                              blocks.end());
    write_pvd(record.body_fields, context.folder, "bodies.pvd");
  }



  template <int dim>
  void
  TransientOutput<dim>::write_checkpoint(const ContactStepper<dim> &stepper,
                                         Checkpoint                &record)
  {
    PhaseTimer::Scope phase(context.timer, Phase::checkpoints);
    Ranks::on_root([&]() { record.history = history->flush(); });
    stepper.save(record);
    RollingContact::write_checkpoint(record, context.folder);
  }



  template <int dim>
  void
  TransientOutput<dim>::finish(const ContactStepper<dim> &stepper,
                               const Checkpoint          &record)
  {
    Ranks::on_root([&]() { history->publish(); });
    context.results.set("time_s", record.time);
    context.results.set("rolled_m", record.rolled_distance);
    add_result_row(scene, stepper.current(), context);
    if (!Ranks::is_root()) // who has the history
      return;
    note_largest_load();
    if (scene.output.plot)
      plot();
  }



  template <int dim>
  void
  TransientOutput<dim>::note_largest_load() const
  {
    const auto values =
      read_columns(context.folder.get_path() / history_name,
                   {place("time_s"), place("normal_force_N")});
    const auto largest = std::max_element(values[1].begin(), values[1].end());
    if (largest == values[1].end() || *largest <= 0.)
      return;
    context.report.set_finding(
      "peak",
      "N = " + significant(*largest, 6) + " N at t = " +
        significant(values[0][largest - values[1].begin()], 6) + " s");
  }



  template <int dim>
  void
  TransientOutput<dim>::plot() const
  {
    const double mu     = scene.contact.friction_coefficient;
    const auto   values = read_columns(context.folder.get_path() / history_name,
                                     {place("time_s"),
                                        place("rolled_m"),
                                        place("normal_force_N"),
                                        place("force_x_N"),
                                        place("force_y_N")});
    const bool   rolls =
      mu > 0. && !values[1].empty() && std::abs(values[1].back()) > 0.;
    std::vector<double> abscissa, load, force_x, force_y;
    for (std::size_t i = 0; i < values[0].size(); ++i)
      {
        abscissa.push_back(1e3 * values[rolls ? 1 : 0][i]);
        load.push_back(1e-3 * values[2][i]);
        force_x.push_back(values[2][i] > 0. ? values[3][i] / (mu * values[2][i])
                                            : 0.);
        force_y.push_back(values[2][i] > 0. ? values[4][i] / (mu * values[2][i])
                                            : 0.);
      }
    SvgPlot figure(rolls ? "Forces on the wheel" : "Load",
                   rolls ? "rolled distance (mm)" : "time (ms)",
                   rolls ? "T / (" + scale_of_friction(scene) + "N)"
                         : "N (kN)");
    const auto moves = [](const std::vector<double> &force) {
      return std::any_of(force.begin(), force.end(), [](const double f) {
        return std::abs(f) > 1e-6;
      });
    };
    if (!rolls)
      figure.add_curve("", abscissa, load);
    else
      {
        figure.add_curve("longitudinal", abscissa, force_x);
        if (dim == 3 && moves(force_y))
          figure.add_curve("lateral", abscissa, force_y);
      }
    figure.write(context.folder, "history.svg");
  }



  template class TransientOutput<2>;
  template class TransientOutput<3>;
} // namespace RollingContact
