#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/ordered_work.h>
#include <rolling_contact/base/platform.h>
#include <rolling_contact/base/ranks.h>
#include <rolling_contact/base/stopwatch.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/results/bodies_report.h>
#include <rolling_contact/results/result_row.h>
#include <rolling_contact/run/progress.h>
#include <rolling_contact/scene/known_entries.h>
#include <rolling_contact/scene/shared_rules.h>
#include <rolling_contact/tables/chain_solver.h>
#include <rolling_contact/tables/kept_bodies.h>
#include <rolling_contact/tables/table.h>
#include <rolling_contact/tables/table_output.h>

#include <algorithm>

namespace RollingContact
{
  template <int dim>
  Table<dim>::Table(const Situation &scene, RunContext &context)
    : Table(scene,
            table_states(scene.inputs->table, scene.inputs->prm_folder),
            context)
  {}

  template <int dim>
  Table<dim>::Table(const Situation   &scene,
                    const TableStates &states,
                    RunContext        &context)
    : scene(scene)
    , n_ranks(Ranks::count())
    , rows_of_ranks(context)
    , context(rows_of_ranks.context())
    , plan(plan_table(scene, states))
    , part(scene.inputs->table.part())
    , n_threads(scene.inputs->table.threads > 0 ? scene.inputs->table.threads
                                                : Ranks::cpus_of_each())
    , has_row(plan.values.size(), false)
  {}

  template <int dim>
  void Table<dim>::run()
  {
    reserve_blas_memory(n_threads);
    take_rows();
    bands = load_bands(scene, plan, smallest_share());
    context.log.message(
      "Table of " + std::to_string(plan.values.size()) + " states on " +
      sets(bands.size()) + "; " + std::to_string(n_threads) +
      (n_threads == 1 ? " thread" : " threads") +
      (is_shared() ? " on each of " + std::to_string(n_ranks) + " ranks" : "") +
      (n_before > 0
         ? ", " + std::to_string(n_before) + " states are there already."
         : "."));
    std::vector<Chains> of_bands;
    for (const LoadBand &band : bands)
      of_bands.push_back(chains_of(band));
    if (!part.is_all())
      context.log.message("Part " + scene.inputs->table.part_text + " has " +
                          std::to_string(n_mine) + " of them.");
    solve_bands(of_bands);
    const bool is_root = Ranks::is_root();
    Ranks::apart([&]() {
      if (is_root)
        finish();
    });
  }

  template <int dim>
  typename Table<dim>::Chains Table<dim>::chains_of(const LoadBand &band)
  {
    Chains chains;
    for (std::size_t k = 0; k < band.states.size(); k += chain_length)
      {
        if (!part.has(n_chains++))
          continue;
        const std::size_t end = std::min(k + chain_length, band.states.size());
        n_mine += end - k;
        std::vector<std::size_t> chain;
        for (std::size_t i = k; i < end; ++i)
          if (!has_row[band.states[i]])
            chain.push_back(band.states[i]);
        if (!chain.empty())
          chains.push_back(chain);
      }
    return chains;
  }

  template <int dim>
  void Table<dim>::solve_band(const LoadBand  &band,
                              const Chains    &chains,
                              const BandTurns &turns)
  {
    throw_if_interrupted();
    if (!turns.any())
      return;
    if (band.touches())
      {
        solve_band_that_touches(band, chains, turns);
        return;
      }
    SceneEntries entries(scene);
    for (const auto &chain : turns.rest_of(chains))
      for (const std::size_t state : chain)
        {
          plan.set(state, entries);
          ResultsTable row, rows;
          add_open_row(entries.situation(), row);
          begin_table_row(plan, state, TableStatus::no_contact, rows);
          rows.take_row(row, 0);
          rows.end_row();
          context.results.append(rows);
        }
  }

  template <int dim>
  void Table<dim>::give_up(const Chains &unsolved, const std::string &why)
  {
    if (unsolved.empty())
      return;
    context.log.warning("The state of the table with " +
                        plan.name(unsolved[0][0]) + ": " + why);
    for (const auto &chain : unsolved)
      for (const std::size_t state : chain)
        add_unsolved_row(plan,
                         state,
                         TableStatus::not_enclosed,
                         context.results);
  }

  template <int dim>
  void Table<dim>::solve_band_that_touches(const LoadBand  &band,
                                           const Chains    &chains,
                                           const BandTurns &turns)
  {
    SceneEntries     entries(scene);
    const Situation  largest = band.scene(plan, entries);
    PairMaker<dim>   make_pair;
    SteadyState<dim> base;
    try
      {
        make_pair = pair_maker(band);
        base      = solve_steady_state<dim>(largest,
                                       demands_of(band),
                                       context,
                                       make_pair);
      }
    catch (const ConvergenceError &error)
      {
        return give_up(turns.rest_of(chains), error.what());
      }
    catch (const InputError &error)
      {
        // shared bodies may end here, and go on elsewhere
        if (!make_pair)
          throw;
        return give_up(turns.rest_of(chains), error.what());
      }
    describe(band, largest, base, band.states.size());
    Chains left = chains;
    solve_on_fitting_mesh(
      [&](const unsigned int k) {
        left = solve_chains(
          left, k == 0 ? &turns : nullptr, base, largest, k + 1 == most_meshes);
      },
      [&](const unsigned int k) {
        leave_bodies(band, largest, base);
        if (left.empty())
          return false;
        try
          {
            base = enlarged(base, band, largest, 1u << k, make_pair);
          }
        catch (const InputError &error) // no memory, or beyond the bodies
          {
            give_up(left, error.what());
            return false;
          }
        return true;
      });
  }

  template <int dim>
  SteadyState<dim> Table<dim>::enlarged(const SteadyState<dim> &base,
                                        const LoadBand         &band,
                                        const Situation        &scene,
                                        const unsigned int      n_elements,
                                        const PairMaker<dim>   &make_pair)
  {
    Grading<dim> grading = base.grading;
    enlarge_zone(scene, base, n_elements, grading);
    say_enlarged(grading, context.log);
    ++n_bodies;
    return StateFinder<dim>(scene, demands_of(band), context, make_pair)
      .solve_on(grading, [&](const ContactProblem &problem) {
        return transferred_state(base, problem);
      });
  }

  template <int dim>
  typename Table<dim>::Chains
  Table<dim>::solve_chains(const Chains           &chains,
                           const BandTurns        *turns,
                           const SteadyState<dim> &base,
                           const Situation        &scene,
                           const bool              keep_all)
  {
    if (!demands().pair.whole_bodies())
      base.pair->release_statics();
    take_bodies(scene, base);
    PhaseTimer::Scope phase(context.timer, Phase::contact_solve);
    const Stopwatch   watch;
    // ranks take about equally many; each knows of its own
    Progress                 progress(context.log,
                      is_shared() ? "state of the first rank," : "state",
                      (n_mine + n_ranks - 1) / n_ranks,
                      context.results.n_rows());
    std::vector<SolvedChain> solved(chains.size());
    Chains                   left;
    do_in_order(
      chains.size(),
      n_threads,
      [&]() {
        auto solver = std::make_shared<ChainSolver<dim>>(
          scene,
          plan,
          base,
          [&](const auto &scene, const auto &steady, ResultsTable &row) {
            if (turns)
              turns->go_on();
            add_columns(scene, steady, row);
          },
          context);
        return [&, solver](const std::size_t k) {
          if (const auto mine = turns ? turns->take() : k)
            solver->solve(chains[*mine], keep_all, solved[k]);
        };
      },
      [&](const std::size_t k) {
        context.results.append(solved[k].rows);
        if (!is_said && !solved[k].complaint.empty())
          context.log.warning(solved[k].complaint);
        is_said = is_said || !solved[k].complaint.empty();
        if (!solved[k].not_enclosed.empty())
          left.push_back(solved[k].not_enclosed);
        solved[k].rows.clear();
        progress.report(context.results.n_rows());
      });
    seconds += watch.seconds();
    return left;
  }

  template <int dim>
  void Table<dim>::describe(const LoadBand         &band,
                            const Situation        &scene,
                            const SteadyState<dim> &base,
                            const std::size_t       n_states)
  {
    if (n_bodies++ == 0)
      describe_bodies(base, context);
    const std::string &why   = base.pair->bodies().reason_against_split();
    const double       ratio = band.smallest_size / band.largest_size;
    context.log.message(
      "Bodies made for " + plan.name(band.largest) + ": " +
      std::to_string(scene.mesh.elements_across_patch) + " elements across, " +
      std::to_string(base.problem.n_nodes()) + " contact nodes, for " +
      std::to_string(n_states) + (n_states == 1 ? " state" : " states") +
      (ratio < 1.
         ? " with patches down to " + significant(ratio, 3) + " of that size."
         : ".") +
      (n_bodies == 1 || why.empty() ? ""
                                    : " Finite elements, as " + why + '.'));
  }

  template <int dim>
  void Table<dim>::finish()
  {
    ResultsTable     &results  = context.results;
    const std::size_t n_solved = results.n_rows() - n_before;
    results.sort_by("state");
    results.flush();
    const TableSummary summary = summary_of(results);
    summary.note(context.report);
    context.report.set_finding(
      "table",
      std::to_string(results.n_rows()) + " states" +
        (n_before > 0 ? ", " + std::to_string(n_before) +
                          (context.resume ? " of them from the run before"
                                          : " of them from runs of parts")
                      : "") +
        "; " + std::to_string(n_solved) + " in " + human_seconds(seconds) +
        " on " + sets(n_bodies) +
        (is_shared() ? "; " + rows_of_ranks.shares() : ""));
    if (part.is_all())
      {
        write_table_file(plan, scene, context);
        summarise();
        if (scene.inputs->output.plot)
          draw();
      }
    summary.warn(plan, context.log);
    summary.require_solved(plan);
  }

  template <int dim>
  StateDemands Table<dim>::demands() const
  {
    return demands_of_kept_bodies();
  }

  template <int dim>
  StateDemands Table<dim>::demands_of(const LoadBand &band) const
  {
    StateDemands result      = demands();
    result.pair.split_bodies = split_bodies;
    result.other_patches     = band.other_patches;
    return result;
  }

  template <int dim>
  std::string Table<dim>::sets(const std::size_t n) const
  {
    return std::to_string(n) + (n == 1 ? " set of bodies" : " sets of bodies");
  }

  template <int dim>
  double Table<dim>::smallest_share() const
  {
    return smallest_patch;
  }

  template <int dim>
  void Table<dim>::draw()
  {
    plot_sections(plan, context);
  }

  template class Table<2>;
  template class Table<3>;

  RunFolder::Resumption table_resumption(const Situation &scene)
  {
    return {entries_free_on_resume(*scene.inputs), "results.csv", {}, {}};
  }

  AnalysisKind table_kind()
  {
    AnalysisKind kind = kind_of<Table>(
      "table",
      "the states on a grid of any entries, or of the rows of a file, see "
      "section Table");
    kind.sections        = {"Table"};
    kind.has_many_states = true;
    kind.rules           = {&check_table};
    kind.resumption      = &table_resumption;
    return kind;
  }
} // namespace RollingContact
