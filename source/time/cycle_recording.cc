#include <deal.II/lac/vector.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/contact/node_lines.h>
#include <rolling_contact/results/interface_fields.h>
#include <rolling_contact/run/figure.h>
#include <rolling_contact/time/cycle_recording.h>
#include <rolling_contact/time/march.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    const unsigned int n_phases = 24;

    /**
     * What the nodes of a line along x do, step by step.
     */
    class LineRecord
    {
    public:
      /** The line nearest to the middle of the load, of all that touch. */
      LineRecord(const ContactProblem &problem, const ContactState &state);

      /** The state at the end of a step, @p time after the record began, s. */
      void add(const double          time,
               const ContactProblem &problem,
               const ContactState   &state);

      /** Only nodes that touch at any time. */
      void write(const double period, RunFolder &folder) const;
      void draw(RunContext &context) const;

    private:
      struct Step
      {
        double                 time;
        std::vector<NodeState> states;
        std::vector<double>    pressure, traction_x, traction_y;
      };

      /** Places in the line. */
      std::vector<std::size_t> touching() const;

      std::vector<unsigned int> nodes;
      std::vector<double>       x;
      double                    y = 0.;
      std::vector<Step>         steps;
    };

    LineRecord::LineRecord(const ContactProblem &problem,
                           const ContactState   &state)
    {
      const ContactOperators &operators = problem.operators;
      const auto             &at        = operators.positions();
      double                  load = 0., moment = 0.;
      for (unsigned int i = 0; i < at.size(); ++i)
        {
          const double part = operators.areas()[i] * state.pressure[i];
          load += part;
          moment += part * at[i][1];
        }
      const double middle = load > 0. ? moment / load : 0.;
      for (const auto &line : node_lines(operators, 0))
        if (nodes.empty() ||
            std::abs(at[line[0]][1] - middle) < std::abs(y - middle))
          {
            nodes = line;
            y     = at[line[0]][1];
          }
      for (const unsigned int node : nodes)
        x.push_back(at[node][0]);
    }

    void LineRecord::add(const double          time,
                         const ContactProblem &problem,
                         const ContactState   &state)
    {
      Step               step{time, {}, {}, {}, {}};
      const unsigned int n_tangential = problem.n_tangential();
      const auto         states =
        n_tangential > 0
                  ? node_states(tangential_problem(problem, state), state)
                  : std::vector<NodeState>(problem.n_nodes(), NodeState::slip);
      for (const unsigned int node : nodes)
        {
          const bool touches = state.pressure[node] > 0.;
          step.states.push_back(touches ? states[node] : NodeState::open);
          step.pressure.push_back(state.pressure[node]);
          step.traction_x.push_back(n_tangential > 0 ? state.traction(0, node)
                                                     : 0.);
          step.traction_y.push_back(n_tangential > 1 ? state.traction(1, node)
                                                     : 0.);
        }
      steps.push_back(step);
    }

    std::vector<std::size_t> LineRecord::touching() const
    {
      std::vector<std::size_t> places;
      for (std::size_t k = 0; k < nodes.size(); ++k)
        if (std::any_of(steps.begin(), steps.end(), [&](const Step &step) {
              return step.states[k] != NodeState::open;
            }))
          places.push_back(k);
      return places;
    }

    void LineRecord::write(const double period, RunFolder &folder) const
    {
      HistoryTable                   table(folder,
                         "cycle_patch.csv",
                         {"time_s",
                                            "phase",
                                            "x_m",
                                            "y_m",
                                            "state",
                                            "pressure_Pa",
                                            "traction_x_Pa",
                                            "traction_y_Pa"},
                         false);
      const std::vector<std::size_t> in_contact = touching();
      for (const Step &step : steps)
        for (const std::size_t k : in_contact)
          table.add_row({step.time,
                         step.time / period,
                         x[k],
                         y,
                         static_cast<double>(step.states[k]),
                         step.pressure[k],
                         step.traction_x[k],
                         step.traction_y[k]});
      table.publish();
    }

    /** Both ends of cells about ascending places, a hair apart. */
    std::vector<double> ends_of_cells(const std::vector<double> &places)
    {
      std::vector<double> ends;
      for (std::size_t k = 0; k < places.size(); ++k)
        {
          const double before = k > 0 ? places[k] - places[k - 1]
                                      : places[k + 1] - places[k],
                       after = k + 1 < places.size() ? places[k + 1] - places[k]
                                                     : before;
          ends.push_back(places[k] - 0.4999 * before);
          ends.push_back(places[k] + 0.4999 * after);
        }
      return ends;
    }

    void LineRecord::draw(RunContext &context) const
    {
      const auto in_contact = touching();
      if (in_contact.empty() || steps.size() < 2)
        return;
      // with what is open next to them
      const std::size_t first =
                          std::max<std::size_t>(in_contact.front(), 1) - 1,
                        end = std::min(in_contact.back() + 2, nodes.size());
      std::vector<double> times, places, values;
      for (const Step &step : steps)
        times.push_back(1e3 * step.time);
      for (std::size_t k = first; k < end; ++k)
        {
          places.push_back(1e3 * x[k]);
          for (unsigned int side = 0; side < 2; ++side)
            for (const Step &step : steps)
              values.insert(values.end(),
                            2,
                            static_cast<double>(step.states[k]));
        }
      if (places.size() < 2)
        return;
      Figure figure("Stick and slip in the middle of the patch, one cycle",
                    "time (ms)",
                    "x (mm)");
      figure.add_map("0 open, 1 slip, 2 stick",
                     ends_of_cells(times),
                     ends_of_cells(places),
                     values);
      figure.draw(context, "cycle_patch");
    }

    /**
     * The interface at equal phases of a cycle.
     */
    template <int dim>
    class Phases
    {
    public:
      Phases(const Situation &scene, const double period, RunContext &context)
        : scene(scene)
        , period(period)
        , context(context)
      {}

      /** Write the next phase if the time has come for it. Units: s. */
      void add(const double time, const SteadyState<dim> &contact)
      {
        if (!scene.inputs->output.interface_fields ||
            blocks.size() >= n_phases ||
            time < blocks.size() * period / n_phases)
          return;
        const std::string file =
          "cycle-" + zero_padded(blocks.size() + 1, 2) + ".vtu";
        write_interface(scene, contact, context.folder, file);
        blocks.push_back({time, 0, "interface", file});
        write_pvd(blocks, context.folder, "cycle.pvd");
      }

    private:
      const Situation      &scene;
      const double          period;
      RunContext           &context;
      std::vector<PvdBlock> blocks;
    };

    /** March from @p time through a period and record the steps; s. */
    template <int dim>
    void record_steps(const double         time,
                      const TimeSteps     &steps,
                      ContactStepper<dim> &stepper,
                      LineRecord          &line,
                      Phases<dim>         &phases)
    {
      TransientProgress progress; // of the record alone
      const auto        add = [&](const StepOutcome &) {
        const SteadyState<dim> &contact = stepper.current();
        const double            end     = progress.step * steps.length;
        line.add(end, contact.problem, contact.state);
        phases.add(end, contact);
      };
      march<dim>({steps, time}, stepper, progress, {add});
    }
  } // namespace

  template <int dim>
  void record_cycle(const Situation     &scene,
                    const double         time,
                    const double         h,
                    const double         period,
                    ContactStepper<dim> &stepper,
                    RunContext          &context)
  {
    PhaseTimer::Scope phase(context.timer, Phase::fields);
    LineRecord        line(stepper.current().problem, stepper.current().state);
    Phases<dim>       phases(scene, period, context);
    const auto        n = static_cast<std::uint64_t>(std::ceil(period / h));
    const auto        give_up = [&](const std::exception &error) {
      context.log.warning(
        std::string("The cycle is not recorded in pictures of the patch: ") +
        error.what());
    };
    try
      {
        record_steps<dim>(time, {h, n}, stepper, line, phases);
      }
    catch (const ConvergenceError &error)
      {
        return give_up(error);
      }
    catch (const InputError &error) // a surface record that ends, say
      {
        return give_up(error);
      }
    line.write(period, context.folder);
    if (scene.inputs->output.plot)
      line.draw(context);
  }

  template void record_cycle(const Situation &,
                             const double,
                             const double,
                             const double,
                             ContactStepper<2> &,
                             RunContext &);
  template void record_cycle(const Situation &,
                             const double,
                             const double,
                             const double,
                             ContactStepper<3> &,
                             RunContext &);
} // namespace RollingContact
