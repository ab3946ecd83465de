#include <rolling_contact/analyses/disturbed_state.h>
#include <rolling_contact/analyses/stability.h>
#include <rolling_contact/analyses/stability_report.h>
#include <rolling_contact/analyses/stability_verdict.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/results/mode_animation.h>
#include <rolling_contact/scene/shared_rules.h>
#include <rolling_contact/stability/unstable_count.h>
#include <rolling_contact/vibration/rolling_modes.h>

#include <algorithm>
#include <optional>

namespace RollingContact
{
  namespace
  {
    const char stability_file[] = "stability.csv";

    /// stable vibrations that are listed as well, the least damped ones
    const std::size_t n_stable_listed = 5;

    /// negative damping ratio at the highest frequency from which on a
    /// vibration counts: without damping many have none but by rounding
    const double neutral = 1e-7;

    /** The vibrations that are listed, by frequency, corrected by the whole
     * bodies if that is wanted. */
    template <int dim>
    std::vector<Finding> find_vibrations(const Vibrations       &vibrations,
                                         const WholeBodies<dim> *bodies)
    {
      ComplexValues listed = vibrations.least_damped(n_stable_listed);
      std::sort(listed.begin(), listed.end(), [](const auto &a, const auto &b) {
        return a.imag() < b.imag();
      });
      return vibrations.find(listed, bodies);
    }

    /** The motion of both bodies in those vibrations that grow fastest, up to
     * so many, named by their rows. */
    template <int dim>
    void animate(const std::vector<Finding> &findings,
                 const std::size_t           n,
                 const LinearContact        &contact,
                 const RollingModes<dim>    &rolling,
                 const WholeBodies<dim>     &bodies,
                 RunFolder                  &folder)
    {
      std::vector<std::size_t> rows;
      for (std::size_t k = 0; k < findings.size(); ++k)
        if (findings[k].unstable())
          rows.push_back(k);
      std::stable_sort(rows.begin(),
                       rows.end(),
                       [&](const std::size_t a, const std::size_t b) {
                         return findings[a].growth() > findings[b].growth();
                       });
      rows.resize(std::min(rows.size(), n));
      for (const std::size_t row : rows)
        {
          const Finding &finding = findings[row];
          const auto     s =
            finding.corrected ? finding.corrected->s : finding.mode.s;
          const ComplexVector forces = contact.forces * finding.mode.unknowns;
          std::vector<MovingBody<dim>> moving;
          for (const Side side : both_sides)
            if (const auto *vibrating = rolling.bodies().body(side))
              {
                const auto          motion = bodies.motion(side, {s}, {forces});
                std::vector<double> real, imaginary;
                for (const auto &x : motion[0])
                  {
                    real.push_back(x.real());
                    imaginary.push_back(x.imag());
                  }
                const DirectBody<dim> &body = *vibrating->body;
                moving.push_back({&body,
                                  body.field(real),
                                  body.field(imaginary),
                                  side == Side::wheel,
                                  name_of(side)});
              }
          write_mode_animation(moving,
                               folder,
                               "vibration_" + std::to_string(row + 1));
        }
    }

    /** Warns of a contact that is unstable by itself. */
    void
    warn_of_contact(const Vibrations &vibrations, const bool falls, Log &log)
    {
      const std::vector<double> growth = vibrations.real_growth();
      if (growth.empty())
        return;
      const double fastest = *std::max_element(growth.begin(), growth.end());
      log.warning(
        "Without any vibration the state is unstable: " +
        std::to_string(growth.size()) +
        (growth.size() == 1 ? " real eigenvalue" : " real eigenvalues") +
        ", up to " + significant(fastest, 3) + " 1/s. This is no squeal: " +
        (falls ? "friction falls faster with the speed than its memory "
                 "allows. Take Contact/Friction response = patch mean with a "
                 "longer Friction memory, or constant."
               : "friction pulls the bodies further into each other than "
                 "their stiffness pushes them apart, so that they jam or "
                 "part. Less Contact/Friction coefficient, the other sign "
                 "of the creepage or stiffer supports change that."));
    }

    /** Counts the unstable vibrations a second time; a part of the verdict if
     * they are as many. */
    std::string counted_again(const Situation            &scene,
                              const Vibrations           &vibrations,
                              const std::vector<Finding> &findings,
                              Log                        &log)
    {
      if (!scene.inputs->stability.count)
        return "";
      CountOptions options;
      options.lowest_frequency  = scene.inputs->stability.lowest_frequency;
      options.highest_frequency = scene.inputs->modes.maximum_frequency;
      options.least_growth      = neutral * 2 * pi * options.highest_frequency;
      const int           n     = vibrations.n_unstable(options.least_growth);
      const UnstableCount found = UnstableCounter(vibrations.bodies(), options)
                                    .count(vibrations.contact());
      if (found.resolved && found.count == n)
        {
          const auto n_whole =
            std::count_if(findings.begin(),
                          findings.end(),
                          [](const Finding &it) { return it.unstable(); });
          return (n_whole == n ? ", as many"
                               : "; of the reduced bodies " +
                                   std::to_string(n) + ", as many") +
                 std::string(" as the argument principle counts");
        }
      log.warning(
        "The argument principle counts " + std::to_string(found.count) +
        " unstable vibrations (" + significant(found.turns, 4) +
        " turns), the eigenvalues are " + std::to_string(n) +
        ". A vibration that is neither stable nor unstable may lie on "
        "the contour.");
      return "";
    }
  } // namespace

  template <int dim>
  void Stability<dim>::run()
  {
    const SteadyState<dim>  steady = disturbed_state<dim>(scene, context);
    const ModalBodies<dim>  bodies(scene,
                                  scene.inputs->modes,
                                  steady.pair->bodies(),
                                  scene.inputs->modes.cut_off(),
                                  context);
    const RollingModes<dim> rolling(bodies,
                                    *steady.pair,
                                    steady.problem.operators.W().dense());
    PhaseTimer::Scope       phase(context.timer, Phase::eigenvalues);
    const RollingConditions conditions(scene, scene.inputs->stability);
    const Vibrations        vibrations(scene,
                                rolling.reduced(conditions),
                                steady.problem,
                                steady.state);
    throw_if_interrupted();
    std::optional<WholeBodies<dim>> whole;
    if (scene.inputs->stability.correct)
      whole.emplace(rolling, conditions);
    const auto findings =
      find_vibrations(vibrations, whole ? &*whole : nullptr);

    ResultsTable table(context.folder, stability_file);
    for (const Finding &finding : findings)
      add_row(finding, vibrations.contact(), rolling, table);
    table.flush();
    context.log.message(table.screen_table({"frequency_Hz",
                                            "growth_1/s",
                                            "corrected_growth_1/s",
                                            "damping_needed",
                                            "wheel_mode_name",
                                            "unstable"}));
    warn_of_contact(vibrations,
                    steady.problem.loads.friction_law != nullptr &&
                      scene.inputs->friction_response() !=
                        FrictionResponse::constant,
                    context.log);
    warn_of_fixed_edges(vibrations.contact(),
                        scene.contact.slip_operator,
                        context.log);
    if (vibrations.contact().n_border() > 0)
      context.log.detail(
        std::to_string(vibrations.contact().n_border()) +
        " nodes are about to open, to slip or to stick, where the laws have "
        "other derivatives on either side.");
    const std::string counted =
      counted_again(scene, vibrations, findings, context.log);
    context.report.set_finding("squeal", verdict(scene, findings, counted));
    std::vector<std::string> names;
    for (const Finding &finding : findings)
      names.push_back(rolling.nearest_name(finding.mode.participation()));
    std::vector<DrivingThreshold> thresholds;
    if (scene.inputs->stability.thresholds)
      thresholds =
        find_thresholds(scene, steady, rolling, vibrations, findings, context);
    tell_verdict(scene, findings, names, counted, thresholds, context);
    double backward = 0.;
    for (const Finding &finding : findings)
      if (finding.corrected)
        backward = std::max(backward, finding.corrected->backward_error);
    if (whole && !findings.empty())
      context.report.errors.push_back(
        {"vibrations that grow",
         backward,
         "the equations of the whole bodies",
         "their backward error after correction, " +
           std::to_string(whole->n_iterations()) + " solves",
         false,
         ""});
    if (scene.inputs->modes.animated > 0)
      {
        if (!whole)
          whole.emplace(rolling, conditions);
        animate(findings,
                scene.inputs->modes.animated,
                vibrations.contact(),
                rolling,
                *whole,
                context.folder);
      }
    if (scene.inputs->output.plot)
      plot_growth(vibrations.eigenvalues(),
                  findings,
                  names,
                  scene.inputs->stability.lowest_frequency,
                  scene.inputs->modes.maximum_frequency,
                  context);
  }

  template class Stability<2>;
  template class Stability<3>;

  AnalysisKind stability_kind()
  {
    AnalysisKind kind = kind_of<Stability>(
      "stability",
      "whether the steady rolling state squeals, see section Stability");
    kind.sections    = {"Modes", "Stability"};
    kind.linearises  = true;
    kind.has_dampers = true;
    kind.on_ranks    = false;
    kind.rules       = {&check_linearised_state};
    return kind;
  }
} // namespace RollingContact
