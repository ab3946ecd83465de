#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/tables/table_rows.h>
#include <rolling_contact/wheelset/fmu_export.h>
#include <rolling_contact/wheelset/fmu_package.h>
#include <rolling_contact/wheelset/fmu_points.h>

#include <cmath>
#include <map>

namespace RollingContact
{
  namespace
  {
    /// relative changes of a load at which there is no state
    const std::array<double, 6> loads_beside{
      {1e-3, -1e-3, 2e-3, -2e-3, -5e-3, 5e-3}};
  } // namespace

  FmuExport::FmuExport(const Situation &scene, RunContext &context)
    : FmuExport(scene, FmuStates(scene), context)
  {}

  FmuExport::FmuExport(const Situation &scene,
                       const FmuStates &states,
                       RunContext      &context)
    : Table<3>(scene, states.table_states(), context)
    , states(states)
  {}

  void FmuExport::run()
  {
    fmu_binary(); // before the work
    try
      {
        Table<3>::run();
      }
    catch (const ConvergenceError &)
      {
        if (!is_written)
          throw;
      }
  }

  std::optional<Fmu::Quantities>
  FmuExport::beside(const Fmu::Coordinates &point, Session &session) const
  {
    for (const double change : loads_beside)
      {
        Fmu::Coordinates near = point;
        near[Fmu::load_axis] *= 1 + change;
        const auto values = states.entries_of(near);
        for (std::size_t k = 0; k < values.size(); ++k)
          session.set(FmuStates::entries()[k], values[k]);
        if (!session.solve().converged)
          continue;
        std::map<std::string, double> row;
        for (const auto &[column, value] : session.row())
          if (const double *number = std::get_if<double>(&value))
            row[column] = *number;
        Fmu::Quantities found = states.quantities_of(
          [&](const std::string &column) {
            const auto at = row.find(column);
            return at == row.end() ? std::optional<double>() : at->second;
          },
          near);
        found[Fmu::force_bound] += std::abs(change) * found[Fmu::normal_force];
        for (std::size_t q = 0; q < Fmu::n_quantities; ++q)
          found[q] *= Fmu::scale_of(q, point[Fmu::load_axis]) /
                      Fmu::scale_of(q, near[Fmu::load_axis]);
        return found;
      }
    return {};
  }

  std::optional<std::vector<Fmu::Quantities>> FmuExport::all_states()
  {
    const ResultsTable          &rows = context.results;
    std::vector<Fmu::Quantities> all;
    std::optional<Session>       session;
    std::size_t                  n_beside = 0;
    for (std::size_t k = 0; k < rows.n_rows(); ++k)
      {
        const Fmu::Coordinates point = states.coordinates_of(k);
        if (status_of_row(rows, k) == TableStatus::solved)
          {
            all.push_back(states.quantities_of(
              [&](const std::string &column) { return rows.number(k, column); },
              point));
            continue;
          }
        if (!session)
          session.emplace(scene);
        const auto found = beside(point, *session);
        if (!found)
          return {};
        all.push_back(*found);
        ++n_beside;
      }
    if (n_beside > 0)
      context.log.warning(
        std::to_string(n_beside) + " of " + std::to_string(rows.n_rows()) +
        " states have no solution on their mesh, because the load jumps there "
        "as an edge of the contact moves. The FMU has states with a load up "
        "to " +
        significant(100 * loads_beside.back(), 2) +
        " % away in their place, and their bounds are wider by as much.");
    return all;
  }

  void FmuExport::summarise()
  {
    const auto all = all_states();
    if (!all)
      return; // what is not solved ends the run
    Fmu::WheelsetModel model  = states.model(*all);
    const unsigned int n      = scene.inputs->own<FmuParameters>().n_points;
    const FmuErrors    errors = measure_fmu(scene, states, n, model, context);
    if (errors.n > 0)
      context.report.set_finding(
        "points",
        std::to_string(errors.n_within) + " of " + std::to_string(errors.n) +
          " states between those of the table are within the bound that the "
          "FMU tells, with a margin of " +
          significant(model.table.margin, 3) +
          " from as many others; forces are " + significant(errors.median, 2) +
          " (median) to " + significant(errors.most, 2) + " of mu N off" +
          (errors.n_unsolved > 0 ? "; " + std::to_string(errors.n_unsolved) +
                                     " more were not solved"
                                 : ""));
    write_fmus_of_table(scene, model, context);
    if (scene.inputs->own<FmuParameters>().kind == FmuKind::both)
      write_fmus_of_states(scene, context);
    is_written = true;
  }

  namespace
  {
    /** FMUs whose states the program solves: there is nothing to compute. */
    class FmuOfStates : public Analysis
    {
    public:
      FmuOfStates(const Situation &scene, RunContext &context)
        : scene(scene)
        , context(context)
      {}

      void run() override
      {
        write_fmus_of_states(scene, context);
        context.report.errors.push_back(
          {"forces",
           std::nan(""),
           "",
           "each state that is solved tells its bound, force_bound",
           true,
           ""});
      }

    private:
      const Situation &scene;
      RunContext      &context;
    };

    std::unique_ptr<Analysis> make_fmus(const Situation &scene,
                                        RunContext      &context)
    {
      if (scene.inputs->own<FmuParameters>().kind == FmuKind::states)
        return std::make_unique<FmuOfStates>(scene, context);
      return std::make_unique<FmuExport>(scene, context);
    }
  } // namespace

  AnalysisKind fmu_kind()
  {
    AnalysisKind kind = kind_of<FmuExport>(
      "fmu",
      "a wheelset as a functional mock-up unit for vehicle codes, see section "
      "FMU");
    kind.in_3d    = &make_fmus;
    kind.sections = {"FMU", "Table"};
    kind.own_section.emplace(FmuParameters());
    kind.on_ranks        = false;
    kind.check_situation = &check_fmu;
    kind.resumption      = &table_resumption;
    return kind;
  }
} // namespace RollingContact
