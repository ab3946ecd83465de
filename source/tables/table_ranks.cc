#include <rolling_contact/base/ranks.h>
#include <rolling_contact/scene/known_entries.h>
#include <rolling_contact/tables/table.h>
#include <rolling_contact/tables/table_rows.h>

#include <exception>

namespace RollingContact
{
  template <int dim>
  void Table<dim>::take_rows()
  {
    std::vector<double> known(has_row.size(), 0.);
    Ranks::on_root([&]() {
      if (!scene.inputs->table.join.empty())
        join_rows(plan,
                  scene.inputs->table.join,
                  entries_free_on_resume(*scene.inputs),
                  context);
      else if (context.resume)
        restore_rows(plan, context);
      n_before = context.results.n_rows();
      for (std::size_t row = 0; row < n_before; ++row)
        known[state_of_row(context.results, row)] = 1.;
    });
    Ranks::broadcast(known);
    for (std::size_t state = 0; state < known.size(); ++state)
      has_row[state] = known[state] != 0.;
  }

  template <int dim>
  void Table<dim>::BandTurns::go_on() const
  {
    if (turns.stopped())
      throw StoppedElsewhere();
  }

  template <int dim>
  typename Table<dim>::Chains
  Table<dim>::BandTurns::rest_of(const Chains &chains) const
  {
    Chains rest;
    while (const auto k = take())
      rest.push_back(chains[*k]);
    return rest;
  }

  template <int dim>
  void Table<dim>::solve_bands(const std::vector<Chains> &of_bands)
  {
    rows_of_ranks.claim();
    std::exception_ptr failure;
    try
      {
        Ranks::Turns turns;
        Ranks::apart([&]() { solve_own_turns(of_bands, turns); });
      }
    catch (...)
      {
        failure = std::current_exception();
      }
    try
      {
        rows_of_ranks.collect(plan);
      }
    catch (...)
      {
        // rows that cannot be taken now are there for --resume
        if (!failure)
          throw;
      }
    if (failure)
      std::rethrow_exception(failure);
  }

  template <int dim>
  void Table<dim>::solve_own_turns(const std::vector<Chains> &of_bands,
                                   Ranks::Turns              &turns)
  {
    std::size_t first = 0;
    try
      {
        for (std::size_t k = 0; k < bands.size(); ++k)
          {
            const std::size_t n = of_bands[k].size();
            solve_band(bands[k], of_bands[k], BandTurns{turns, first, n});
            first += n;
          }
        context.results.flush();
      }
    catch (const StoppedElsewhere &)
      {
        context.results.flush();
      }
    catch (...)
      {
        turns.stop();
        context.results.flush();
        throw;
      }
  }

  template void             Table<2>::take_rows();
  template void             Table<3>::take_rows();
  template void             Table<2>::solve_bands(const std::vector<Chains> &);
  template void             Table<3>::solve_bands(const std::vector<Chains> &);
  template void             Table<2>::BandTurns::go_on() const;
  template void             Table<3>::BandTurns::go_on() const;
  template Table<2>::Chains Table<2>::BandTurns::rest_of(const Chains &) const;
  template Table<3>::Chains Table<3>::BandTurns::rest_of(const Chains &) const;
} // namespace RollingContact
