#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/sessions/kept_bodies.h>
#include <rolling_contact/tables/chain_solver.h>
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



    double
    frequency_of(const std::complex<double> s)
    {
      return s.imag() / (2 * pi);
    }



    /** The solved row with the largest growth above 0, of equal ones that of
     * the first state; n_rows if there is none. */
    std::size_t
    worst_row(const ResultsTable &results)
    {
      std::size_t worst = results.n_rows(), first = 0;
      double      largest = 0.;
      for (std::size_t row = 0; row < results.n_rows(); ++row)
        {
          const std::string growth = results.text(row, "largest_growth_1/s");
          if (growth.empty() || !(std::stod(growth) > 0.))
            continue;
          const double      here  = std::stod(growth);
          const std::size_t state = std::stoul(results.text(row, "state"));
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
  } // namespace



  template <int dim>
  std::string
  StabilityMap<dim>::sets(const std::size_t n) const
  {
    return n > 1 && places.may_share()
             ? std::to_string(n) + " places or patches of the same bodies"
             : Table<dim>::sets(n);
  }



  template <int dim>
  StateDemands
  StabilityMap<dim>::demands() const
  {
    StateDemands demands       = Table<dim>::demands();
    demands.pair.displacements = true;
    demands.zone               = 1.5;
    demands.margin             = 3.;
    return demands;
  }



  template <int dim>
  void
  StabilityMap<dim>::take_bodies(const SceneParameters  &scene,
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
                                             now,
                                             scene.modes.cut_off_ratio *
                                               scene.modes.maximum_frequency,
                                             context);
      }
    PhaseTimer::Scope phase(context.timer, Phase::modes);
    rolling = std::make_unique<RollingModes<dim>>(*bodies,
                                                  *base.pair,
                                                  base.problem.operators.W());
  }



  template <int dim>
  void
  StabilityMap<dim>::add_columns(const SceneParameters  &scene,
                                 const SteadyState<dim> &steady,
                                 ResultsTable           &row) const
  {
    const Vibrations    vibrations(scene,
                                rolling->reduced(RollingConditions(scene)),
                                steady.problem,
                                steady.state);
    const ComplexVector listed = vibrations.least_damped(n_listed);
    row.set("n_unstable", vibrations.n_unstable());
    if (listed.empty())
      for (const char *column : {"largest_growth_1/s",
                                 "fastest_Hz",
                                 "least_damping_ratio",
                                 "least_damped_Hz"})
        row.leave_empty(column);
    else
      {
        const auto fastest =
          *std::max_element(listed.begin(),
                            listed.end(),
                            [](const auto &a, const auto &b) {
                              return a.real() < b.real();
                            });
        row.set("largest_growth_1/s", fastest.real());
        row.set("fastest_Hz", frequency_of(fastest));
        row.set("least_damping_ratio", -listed[0].real() / std::abs(listed[0]));
        row.set("least_damped_Hz", frequency_of(listed[0]));
      }
    row.set("n_contact_unstable", vibrations.real_growth().size());
    row.set("n_border", vibrations.contact().n_border());
    std::vector<ListedVibration> texts;
    for (std::size_t k = 0; k < std::max(std::min(n_listed, listed.size()),
                                         vibrations.n_unstable());
         ++k)
      texts.push_back({frequency_of(listed[k]), listed[k].real()});
    row.set("vibrations", text_of(texts));
  }



  template <int dim>
  void
  StabilityMap<dim>::leave_bodies(const LoadBand         &band,
                                  const SceneParameters  &scene,
                                  const SteadyState<dim> &base)
  {
    if (!places.keeps_bodies())
      prove_worst(band, scene, base);
    rolling.reset();
    if (places.keeps_bodies())
      return;
    bodies.reset();
    touching.reset();
  }



  template <int dim>
  void
  StabilityMap<dim>::prove_worst(const LoadBand         &band,
                                 const SceneParameters  &scene,
                                 const SteadyState<dim> &base)
  {
    const ResultsTable &results = context.results;
    const std::size_t   row     = worst_row(results);
    if (!scene.stability.correct || row == results.n_rows())
      return;
    const std::size_t state = std::stoul(results.text(row, "state"));
    if (std::find(band.states.begin(), band.states.end(), state) ==
          band.states.end() ||
        (proof && proof->state == state))
      return;
    SceneEntries entries(scene);
    plan.set(state, entries);
    const SceneParameters worst  = entries.scene();
    SteadyState<dim>      steady = base;
    solve_on_kept_bodies(worst, steady);
    if (!steady.solver.converged)
      return;
    PhaseTimer::Scope       phase(context.timer, Phase::eigenvalues);
    const RollingConditions conditions(worst);
    const Vibrations        vibrations(worst,
                                rolling->reduced(conditions),
                                steady.problem,
                                steady.state);
    const double frequency = std::stod(results.text(row, "fastest_Hz"));
    for (const auto &s : vibrations.least_damped(0))
      if (std::abs(frequency_of(s) - frequency) < 1e-4 * frequency)
        {
          const WholeBodies<dim> whole(*rolling, conditions);
          proof = Proof{state, vibrations.find({s}, &whole)[0]};
        }
  }



  template <int dim>
  void
  StabilityMap<dim>::prove_on_kept_bodies()
  {
    const std::size_t row = worst_row(context.results);
    if (!this->scene.stability.correct || row == context.results.n_rows())
      return;
    const std::size_t state = std::stoul(context.results.text(row, "state"));
    for (const LoadBand &band : this->bands)
      if (std::find(band.states.begin(), band.states.end(), state) !=
          band.states.end())
        {
          SceneEntries           entries(this->scene);
          const SceneParameters  largest   = band.scene(plan, entries);
          const auto             make_pair = this->pair_maker(band);
          const SteadyState<dim> base =
            solve_steady_state<dim>(largest, demands(), context, make_pair);
          take_bodies(largest, base);
          prove_worst(band, largest, base);
          rolling.reset();
        }
  }



  template <int dim>
  void
  StabilityMap<dim>::draw()
  {
    plot_stability_map(plan, context);
  }



  template <int dim>
  void
  StabilityMap<dim>::summarise()
  {
    if (places.keeps_bodies())
      prove_on_kept_bodies();
    const ResultsTable &results    = context.results;
    std::size_t         n_unstable = 0, n_solved = 0, n_contact = 0;
    for (std::size_t row = 0; row < results.n_rows(); ++row)
      {
        const std::string n = results.text(row, "n_unstable");
        if (n.empty())
          continue;
        ++n_solved;
        n_unstable += n != "0";
        n_contact += results.text(row, "n_contact_unstable") != "0";
      }
    const std::size_t row     = worst_row(results);
    std::string       verdict = "none of " + std::to_string(n_solved) +
                          " states has a vibration that grows";
    if (row < results.n_rows())
      {
        const std::size_t state = std::stoul(results.text(row, "state"));
        verdict =
          std::to_string(n_unstable) + " of " + std::to_string(n_solved) +
          " states have vibrations that grow; the fastest at " +
          significant(std::stod(results.text(row, "fastest_Hz")), 5) +
          " Hz by " +
          significant(std::stod(results.text(row, "largest_growth_1/s")), 3) +
          " 1/s where " + plan.name(state);
        if (proof && proof->state == state)
          verdict += ", " + significant(proof->finding.growth(), 3) +
                     " 1/s by the whole bodies";
      }
    context.report.set_finding("squeal", verdict);
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
} // namespace RollingContact
