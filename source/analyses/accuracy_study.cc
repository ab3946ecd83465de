#include <rolling_contact/analyses/accuracy_study.h>
#include <rolling_contact/analyses/line_reference.h>
#include <rolling_contact/analyses/result_row.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/output/svg_plot.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace RollingContact
{
  bool
  AccuracyStudy::Key::operator<(const Key &other) const
  {
    return std::tie(slip_operator, creepage, elements) <
           std::tie(other.slip_operator, other.creepage, other.elements);
  }



  void
  AccuracyStudy::run()
  {
    const PairConstants constants = pair_constants(scene);
    patch                         = estimate_patch(scene);
    saturation = scene.contact.friction_coefficient * patch.half_width_x /
                 constants.relative_radius;
    if (saturation <= 0.)
      throw InputError("Analysis = accuracy study needs contact and friction: "
                       "check Contact/Approach, Contact/Normal load and "
                       "Contact/Friction coefficient.");
    const StudyParameters &study = scene.study;
    solve_mesh(study.reference_elements, {"calibrated"});
    for (const unsigned int elements : study.elements)
      solve_mesh(elements, study.slip_operators);
    summarise();
  }



  void
  AccuracyStudy::solve_mesh(const unsigned int              elements,
                            const std::vector<std::string> &slip_operators)
  {
    const unsigned int n_offsets = scene.study.n_offsets;
    for (unsigned int k = 0; k < n_offsets; ++k)
      {
        throw_if_interrupted();
        SteadyState<2> steady;
        steady.elements_across = elements;
        steady.grading =
          make_grading<2>(scene, patch, elements, double(k) / n_offsets);
        {
          PhaseTimer::Scope phase(context.timer, "mesh and assembly");
          steady.pair = std::make_unique<RollingPair<2>>(scene, steady.grading);
        }
        solve_states(steady, elements, slip_operators);
      }
    context.log.message(std::to_string(elements) + " elements: " +
                        std::to_string(n_offsets * slip_operators.size() *
                                       scene.study.creepages.size()) +
                        " states solved");
  }



  void
  AccuracyStudy::solve_states(SteadyState<2>                 &steady,
                              const unsigned int              elements,
                              const std::vector<std::string> &slip_operators)
  {
    for (const std::string &slip_operator : slip_operators)
      {
        steady.slip_operator = slip_operator;
        {
          PhaseTimer::Scope phase(context.timer,
                                  "factorisation and condensation");
          const auto        kind =
            ContactParameters::kind_of_slip_operator(slip_operator);
          steady.problem =
            steady.problem.n_nodes == 0
              ? steady.pair->contact_problem(kind)
              : steady.pair->contact_problem(kind, std::move(steady.problem.W));
        }
        for (const double creepage : scene.study.creepages)
          {
            PhaseTimer::Scope phase(context.timer, "contact solve");
            steady.creepage_x = creepage * saturation;
            steady.problem.set_creepages(steady.creepage_x, 0., 0.);
            steady.state = initial_state(steady.problem, patch);
            steady.solver =
              make_contact_solver(scene.solver.solver, scene.solver.controls)
                ->solve(steady.problem, steady.state);
            steady.result = resultants(steady.problem, steady.state);
            const LineErrors errors =
              line_errors(scene, steady, line_reference(scene, steady));
            Sample sample;
            sample.force =
              steady.result.force_x /
              (scene.contact.friction_coefficient * steady.result.normal_force);
            sample.traction_l2    = errors.traction_l2;
            sample.pressure_l2    = errors.pressure_l2;
            sample.sawtooth       = errors.sawtooth;
            sample.stick_boundary = std::abs(errors.stick_boundary);
            sample.normal_force   = errors.normal_force.value_or(0.);
            samples[{slip_operator, creepage, elements}].push_back(sample);
            add_result_row(scene, steady, context);
            if (!steady.solver.converged)
              throw ConvergenceError(
                "Accuracy study, " + slip_operator + ", " +
                std::to_string(elements) + " elements, creepage " +
                significant(creepage, 3) +
                " of saturation: " + steady.solver.reason + ".");
          }
      }
  }



  double
  AccuracyStudy::reference_force(const double creepage) const
  {
    const auto &finest =
      samples.at({"calibrated", creepage, scene.study.reference_elements});
    double sum = 0.;
    for (const Sample &sample : finest)
      sum += sample.force;
    return sum / finest.size();
  }



  void
  AccuracyStudy::summarise()
  {
    ResultsTable             table(context.folder, "summary.csv");
    std::map<Key, double>    largest, mean;
    std::vector<std::string> columns{"slip_operator",
                                     "creepage_over_saturation",
                                     "elements",
                                     "force_error_max",
                                     "force_error_mean",
                                     "order_of_mean",
                                     "traction_l2",
                                     "sawtooth",
                                     "stick_boundary"};
    for (const auto &entry : samples)
      {
        const Key   &key       = entry.first;
        const double reference = reference_force(key.creepage);
        double       sum = 0., worst = 0., load = 0.;
        Sample       extreme;
        for (const Sample &sample : entry.second)
          {
            // the error of the magnitude: positive if the force is too large
            const double error =
              std::copysign(1., reference) * (sample.force - reference);
            sum += error;
            worst = std::max(worst, std::abs(error));
            load += sample.normal_force;
            extreme.traction_l2 += sample.traction_l2;
            extreme.pressure_l2 += sample.pressure_l2;
            extreme.sawtooth = std::max(extreme.sawtooth, sample.sawtooth);
            extreme.stick_boundary =
              std::max(extreme.stick_boundary, sample.stick_boundary);
          }
        const double n = entry.second.size();
        largest[key]   = worst;
        mean[key]      = sum / n;
        table.set("slip_operator", key.slip_operator);
        table.set("creepage_over_saturation", key.creepage);
        table.set("elements", key.elements);
        table.set("offsets", entry.second.size());
        table.set("reference_force/muN", reference);
        table.set("force_error_max", worst);
        table.set("force_error_mean", sum / n);
        const auto coarser =
          mean.find({key.slip_operator, key.creepage, key.elements / 2});
        if (coarser != mean.end() &&
            key.elements != scene.study.reference_elements)
          table.set("order_of_mean",
                    std::log2(std::abs(coarser->second / (sum / n))));
        table.set("normal_force_error", load / n);
        table.set("pressure_l2", extreme.pressure_l2 / n);
        table.set("traction_l2", extreme.traction_l2 / n);
        table.set("sawtooth", extreme.sawtooth);
        table.set("stick_boundary", extreme.stick_boundary);
        table.end_row();
      }
    context.log.message("Force errors over mu N against the mean of " +
                        std::to_string(scene.study.reference_elements) +
                        " elements; traction over mu p0 against Carter, stick "
                        "boundary in elements:");
    context.log.message(table.screen_table(columns));
    plot(largest);
  }



  void
  AccuracyStudy::plot(const std::map<Key, double> &largest) const
  {
    SvgPlot figure("Force error, largest over " +
                     std::to_string(scene.study.n_offsets) + " mesh positions",
                   "elements across the patch",
                   "error of T / (\u03bcN)");
    figure.set_scales(AxisScale::logarithmic, AxisScale::logarithmic);
    for (const std::string &slip_operator : scene.study.slip_operators)
      for (const double creepage : scene.study.creepages)
        {
          std::vector<double> x, y;
          for (const auto &entry : largest)
            if (entry.first.slip_operator == slip_operator &&
                entry.first.creepage == creepage &&
                entry.first.elements < scene.study.reference_elements)
              {
                x.push_back(entry.first.elements);
                y.push_back(entry.second);
              }
          figure.add_curve(slip_operator + ", " + significant(creepage, 2),
                           x,
                           y,
                           slip_operator == scene.study.slip_operators[0]
                             ? CurveStyle::line_and_points
                             : CurveStyle::dashed);
        }
    figure.write(context.folder, "force_error.svg");
  }
} // namespace RollingContact
