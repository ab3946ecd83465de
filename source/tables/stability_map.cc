#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/scene/shared_rules.h>
#include <rolling_contact/tables/chain_solver.h>
#include <rolling_contact/tables/kept_bodies.h>
#include <rolling_contact/tables/stability_map.h>
#include <rolling_contact/tables/stability_map_plot.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /// vibrations that a row lists, those that grow first
    const std::size_t n_listed = 12;

    /// relative difference of growths that is one of rounding, as of a state
    /// and its mirror image
    const double same_growth = 1e-6;

    double frequency_of(const std::complex<double> s)
    {
      return s.imag() / (2 * pi);
    }

    ComplexValues::const_iterator fastest_of(const ComplexValues &vibrations)
    {
      return std::max_element(vibrations.begin(),
                              vibrations.end(),
                              [](const auto &a, const auto &b) {
                                return a.real() < b.real();
                              });
    }

    /** The solved row with the largest growth above 0, of equal ones that of
     * the first state; n_rows if there is none. */
    std::size_t worst_row(const ResultsTable &results)
    {
      std::size_t worst = results.n_rows(), first = 0;
      double      largest = 0.;
      for (std::size_t row = 0; row < results.n_rows(); ++row)
        {
          const double here =
            results.number(row, "largest_growth_1/s").value_or(0.);
          const std::size_t state = state_of_row(results, row);
          if (!(here > 0.))
            continue;
          if (here > largest * (1 + same_growth) ||
              (here > largest * (1 - same_growth) && state < first))
            {
              worst   = row;
              largest = std::max(largest, here);
              first   = state;
            }
        }
      return worst;
    }

    /** "; along Contact/Friction coefficient growth begins between 0.2 and
     * 0.25, by a straight line at 0.231", with each change of the verdict along
     * a single axis. */
    std::string thresholds_along_axis(const TablePlan    &plan,
                                      const ResultsTable &results)
    {
      if (plan.axes.size() != 1)
        return "";
      const TableAxis                   &axis = plan.axes[0];
      std::vector<std::optional<double>> growth(axis.values.size());
      for (std::size_t row = 0; row < results.n_rows(); ++row)
        growth[state_of_row(results, row)] =
          results.number(row, "largest_growth_1/s");
      std::string text;
      for (std::size_t k = 1; k < growth.size(); ++k)
        if (growth[k - 1] && growth[k] &&
            (*growth[k - 1] > 0.) != (*growth[k] > 0.))
          {
            const double one = axis.values[k - 1], other = axis.values[k],
                         share = *growth[k - 1] / (*growth[k - 1] - *growth[k]);
            text += std::string(text.empty() ? "" : ", ") +
                    (*growth[k] > 0. ? "begins" : "ends") + " between " +
                    significant(one, 4) + " and " + significant(other, 4) +
                    ", by a straight line at " +
                    significant(one + share * (other - one), 3);
          }
      return text.empty() ? "" : "; along " + axis.entry + " growth " + text;
    }
  } // namespace

  template <int dim>
  std::string StabilityMap<dim>::sets(const std::size_t n) const
  {
    return n > 1 && places.may_share()
             ? std::to_string(n) + " places or patches of the same bodies"
             : Table<dim>::sets(n);
  }

  template <int dim>
  StateDemands StabilityMap<dim>::demands() const
  {
    StateDemands demands = Table<dim>::demands();
    demands.pair.modes   = true;
    demands.zone         = 1.5;
    demands.margin       = 3.;
    return demands;
  }

  template <int dim>
  void StabilityMap<dim>::take_bodies(const Situation        &scene,
                                      const SteadyState<dim> &base)
  {
    rolling.reset();
    const BodyPair<dim> &now = base.pair->bodies();
    if (!touching || touching->body(Side::wheel) != now.body(Side::wheel) ||
        touching->body(Side::rail) != now.body(Side::rail))
      {
        bodies.reset();
        touching = now;
        bodies =
          std::make_unique<ModalBodies<dim>>(scene,
                                             scene.inputs->modes,
                                             now,
                                             scene.inputs->modes.cut_off(),
                                             context);
      }
    PhaseTimer::Scope phase(context.timer, Phase::modes);
    rolling =
      std::make_unique<RollingModes<dim>>(*bodies,
                                          *base.pair,
                                          base.problem.operators.W().dense());
  }

  template <int dim>
  void StabilityMap<dim>::add_columns(const Situation        &scene,
                                      const SteadyState<dim> &steady,
                                      ResultsTable           &row) const
  {
    const Vibrations vibrations(
      scene,
      rolling->reduced(RollingConditions(scene, scene.inputs->stability)),
      steady.problem,
      steady.state);
    const ComplexValues listed = vibrations.least_damped(n_listed);
    row.set("n_unstable", vibrations.n_unstable());
    if (listed.empty())
      for (const char *column : {"largest_growth_1/s",
                                 "fastest_Hz",
                                 "least_damping_ratio",
                                 "least_damped_Hz"})
        row.leave_empty(column);
    else
      {
        const auto fastest = *fastest_of(listed);
        row.set("largest_growth_1/s", fastest.real());
        row.set("fastest_Hz", frequency_of(fastest));
        if (!plan.titles.empty())
          {
            const std::string mode = mode_of(vibrations, fastest);
            row.set("fastest_mode", mode, mode);
          }
        row.set("least_damping_ratio", -listed[0].real() / std::abs(listed[0]));
        row.set("least_damped_Hz", frequency_of(listed[0]));
      }
    row.set("n_contact_unstable", vibrations.real_growth().size());
    row.set("n_border", vibrations.contact().n_border());
    // stability.csv names what grows
    const bool names_all = !scene.inputs->analysis.has_many_states;
    std::vector<ListedVibration> all;
    for (std::size_t k = 0; k < std::max(std::min(n_listed, listed.size()),
                                         vibrations.n_unstable());
         ++k)
      all.push_back({frequency_of(listed[k]),
                     listed[k].real(),
                     names_all && listed[k].real() > 0.
                       ? mode_of(vibrations, listed[k])
                       : ""});
    row.set("vibrations", text_of(all), all);
  }

  template <int dim>
  std::string StabilityMap<dim>::mode_of(const Vibrations          &vibrations,
                                         const std::complex<double> s) const
  {
    const Finding finding = vibrations.template find<dim>({s}, nullptr).front();
    return rolling->nearest_name(finding.mode.participation());
  }

  template <int dim>
  void StabilityMap<dim>::leave_bodies(const LoadBand         &band,
                                       const Situation        &scene,
                                       const SteadyState<dim> &base)
  {
    if (!places.keeps_bodies() && !this->is_shared())
      prove_worst(band, scene, base);
    rolling.reset();
    if (places.keeps_bodies())
      return;
    bodies.reset();
    touching.reset();
  }

  template <int dim>
  void StabilityMap<dim>::prove_worst(const LoadBand         &band,
                                      const Situation        &scene,
                                      const SteadyState<dim> &base)
  {
    const ResultsTable &results = context.results;
    const std::size_t   row     = worst_row(results);
    if (!scene.inputs->stability.correct || row == results.n_rows())
      return;
    const std::size_t state = state_of_row(results, row);
    if (std::find(band.states.begin(), band.states.end(), state) ==
          band.states.end() ||
        (proof && proof->state == state))
      return;
    SceneEntries entries(scene);
    plan.set(state, entries);
    const Situation &worst  = entries.situation();
    SteadyState<dim> steady = base;
    solve_on_kept_bodies(worst, steady);
    if (!steady.solver.converged)
      return;
    PhaseTimer::Scope       phase(context.timer, Phase::eigenvalues);
    const RollingConditions conditions(worst, worst.inputs->stability);
    const Vibrations        vibrations(worst,
                                rolling->reduced(conditions),
                                steady.problem,
                                steady.state);
    const ComplexValues     growing = vibrations.least_damped(0);
    const auto              fastest = fastest_of(growing);
    if (fastest == growing.end() || !(fastest->real() > 0.))
      return;
    const WholeBodies<dim> whole(*rolling, conditions);
    const Finding          finding = vibrations.find({*fastest}, &whole)[0];
    proof                          = Proof{state,
                  finding,
                  rolling->nearest_name(finding.mode.participation())};
  }

  template <int dim>
  void StabilityMap<dim>::prove_in_the_end()
  {
    const std::size_t row = worst_row(context.results);
    if (!this->scene.inputs->stability.correct ||
        row == context.results.n_rows())
      return;
    const std::size_t state = state_of_row(context.results, row);
    for (const LoadBand &band : this->bands)
      if (std::find(band.states.begin(), band.states.end(), state) !=
          band.states.end())
        {
          context.log.detail("Bodies once more for " + plan.name(state) + '.');
          const Log::Again       again(context.log);
          SceneEntries           entries(this->scene);
          const Situation        largest   = band.scene(plan, entries);
          const auto             make_pair = this->pair_maker(band);
          const SteadyState<dim> base      = solve_steady_state<dim>(
            largest, this->demands_of(band), context, make_pair);
          take_bodies(largest, base);
          prove_worst(band, largest, base);
          rolling.reset();
        }
  }

  template <int dim>
  void StabilityMap<dim>::draw()
  {
    plot_stability_map(plan, context);
  }

  template <int dim>
  void StabilityMap<dim>::summarise()
  {
    if (places.keeps_bodies() || this->is_shared())
      prove_in_the_end();
    const ResultsTable &results    = context.results;
    std::size_t         n_unstable = 0, n_solved = 0, n_contact = 0;
    for (std::size_t row = 0; row < results.n_rows(); ++row)
      {
        const auto n = results.number(row, "n_unstable");
        if (!n)
          continue;
        ++n_solved;
        n_unstable += *n != 0.;
        n_contact += results.number(row, "n_contact_unstable") != 0.;
      }
    const std::size_t row     = worst_row(results);
    std::string       verdict = "none of " + std::to_string(n_solved) +
                          " states has a vibration that grows";
    if (row < results.n_rows())
      {
        const std::size_t  state  = state_of_row(results, row);
        const bool         proved = proof && proof->state == state;
        const std::string *named =
                            results.value<std::string>(row, "fastest_mode"),
                          *mode =
                            named == nullptr && proved ? &proof->mode : named;
        verdict =
          std::to_string(n_unstable) + " of " + std::to_string(n_solved) +
          " states have vibrations that grow; the fastest at " +
          significant(results.number(row, "fastest_Hz").value(), 5) + " Hz" +
          (mode && !mode->empty() ? ", mode " + *mode + "," : "") + " by " +
          significant(results.number(row, "largest_growth_1/s").value(), 3) +
          " 1/s where " + plan.name(state);
        if (proved)
          verdict += ", " + significant(proof->finding.growth(), 3) +
                     " 1/s by the whole bodies";
      }
    context.report.set_finding("squeal",
                               verdict + thresholds_along_axis(plan, results));
    if (proof)
      context.report.errors.push_back(
        {"growth of the fastest vibration",
         std::abs(proof->finding.growth() / proof->finding.mode.growth() - 1),
         "itself",
         "that of the whole bodies, state " + std::to_string(proof->state),
         false,
         ""});
    if (n_contact > 0)
      context.log.warning(
        std::to_string(n_contact) +
        (n_contact == 1 ? " state is" : " states are") +
        " unstable without any vibration (column n_contact_unstable of "
        "results.csv), which is no squeal: bodies jam or part, or friction "
        "falls faster with the speed than its memory allows (Contact/Friction "
        "memory).");
  }

  template class StabilityMap<2>;
  template class StabilityMap<3>;

  AnalysisKind stability_map_kind()
  {
    AnalysisKind kind = kind_of<StabilityMap>(
      "stability map",
      "which states of a grid squeal, see sections Table and Stability");
    kind.sections        = {"Table", "Modes", "Stability"};
    kind.has_many_states = true;
    kind.linearises      = true;
    kind.has_dampers     = true;
    kind.rules           = {&check_table, &check_linearised_state};
    kind.resumption      = &table_resumption;
    return kind;
  }
} // namespace RollingContact
