#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/files.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/fmu/description.h>
#include <rolling_contact/fmu/stored_zip.h>
#include <rolling_contact/tables/table_rows.h>
#include <rolling_contact/wheelset/fmu_export.h>
#include <rolling_contact/wheelset/fmu_points.h>

#include <map>

namespace RollingContact
{
  namespace
  {
    /// relative changes of a load at which there is no state
    const std::array<double, 6> loads_beside{
      {1e-3, -1e-3, 2e-3, -2e-3, -5e-3, 5e-3}};

    /**
     * The binary of FMUs, beside the program or in the folder of libraries of
     * its prefix. Throws InputError if it is in none of them.
     */
    std::string fmu_binary()
    {
      namespace fs = std::filesystem;
      std::error_code error;
      const fs::path  program =
        fs::read_symlink("/proc/self/exe", error).parent_path();
      const std::string     name = std::string(Fmu::model_name) + ".so";
      std::vector<fs::path> folders{program, program.parent_path()};
      for (const char *library : {"lib", "lib64"})
        {
          const fs::path all = program.parent_path() / library;
          folders.push_back(all / "rolling-contact");
          for (const auto &entry : fs::directory_iterator(all, error))
            folders.push_back(entry.path() / "rolling-contact");
        }
      for (const fs::path &folder : folders)
        if (fs::is_regular_file(folder / name, error))
          return read_bytes(folder / name);
      throw InputError("Analysis = fmu: " + name +
                       ", which an FMU holds, is "
                       "neither beside the program nor in lib/rolling-contact "
                       "of its prefix; build the target " +
                       Fmu::model_name + " or install the program again.");
    }

    std::string documentation(const std::string &title)
    {
      return "<!DOCTYPE html>\n<html><head><title>" + title +
             "</title></head><body>\n<h1>" + title +
             "</h1>\n<p>Forces between the wheels of a wheelset and its rails, "
             "from a table of states by finite elements, by rolling-contact. "
             "SI units; x forwards, y to the right, z down; forces act on the "
             "wheels, moments are about the centre of the wheelset. The scene "
             "is resources/scene.prm.</p>\n<p>The binary is under "
             "LGPL-2.1-or-later and needs nothing but the libraries of C and "
             "C++.</p>\n</body></html>\n";
    }
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
    write(model);
    is_written = true;
  }

  void FmuExport::write(const Fmu::WheelsetModel &model) const
  {
    Fmu::DescriptionText text;
    text.title = "Wheelset with forces of rolling contact: " +
                 scene.profiles.wheel_profile + " on " +
                 scene.profiles.rail_profile;
    text.version            = context.report.version;
    text.start              = model.start;
    text.radius             = model.radius;
    text.tape_circle        = model.tape_circle;
    const std::string table = model.bytes(),
                      prm = read_bytes(context.folder.get_path() / "used.prm"),
                      binary = fmu_binary();
    text.token               = Fmu::token_of(Fmu::description_2(text) +
                               Fmu::description_3(text) + table + prm);
    for (const unsigned int version : {2, 3})
      {
        const std::string folder =
          version == 2 ? "binaries/linux64/" : "binaries/x86_64-linux/";
        context.folder.write_atomically(
          "wheelset_fmi" + std::to_string(version) + ".fmu",
          Fmu::stored_zip(
            {{"modelDescription.xml",
              version == 2 ? Fmu::description_2(text)
                           : Fmu::description_3(text)},
             {folder + Fmu::model_name + ".so", binary},
             {std::string("resources/") + Fmu::token_file, text.token},
             {std::string("resources/") + Fmu::table_file, table},
             {"resources/scene.prm", prm},
             {"documentation/index.html", documentation(text.title)}}));
      }
    context.report.set_finding("fmu",
                               "wheelset_fmi2.fmu and wheelset_fmi3.fmu, " +
                                 text.token);
  }

  AnalysisKind fmu_kind()
  {
    AnalysisKind kind = kind_of<FmuExport>(
      "fmu",
      "a wheelset as a functional mock-up unit for vehicle codes, see section "
      "FMU");
    kind.sections = {"FMU", "Table"};
    kind.own_section.emplace(FmuParameters());
    kind.on_ranks        = false;
    kind.check_situation = &check_fmu;
    kind.resumption      = &table_resumption;
    return kind;
  }
} // namespace RollingContact
