#include <deal.II/base/parameter_handler.h>

#include <rolling_contact/base/exception_text.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/input/prm_entries.h>
#include <rolling_contact/pair/mesh_unit_check.h>
#include <rolling_contact/pair/moving_surfaces.h>
#include <rolling_contact/program/analysis_table.h>
#include <rolling_contact/program/scene_doubts.h>
#include <rolling_contact/program/scene_reader.h>
#include <rolling_contact/scene/known_entries.h>
#include <rolling_contact/tables/table_plan.h>

#include <algorithm>
#include <optional>
#include <set>
#include <sstream>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    /**
     * Set Section/Entry (or Entry) of @p prm. Throws InputError.
     */
    void set_entry(const PrmEntry   &entry,
                   const Entries    &entries,
                   ParameterHandler &prm)
    {
      entries.find(entry.path, entry.place).check(entry.value, entry.place);
      std::vector<std::string> names;
      std::istringstream       path(entry.path);
      for (std::string part; std::getline(path, part, '/');)
        names.push_back(part);
      for (std::size_t k = 0; k + 1 < names.size(); ++k)
        prm.enter_subsection(names[k]);
      prm.set(names.back(), entry.value);
      for (std::size_t k = 0; k + 1 < names.size(); ++k)
        prm.leave_subsection();
    }

    void apply_setting(const CommandLine::Setting &setting,
                       const Entries              &entries,
                       ParameterHandler           &prm)
    {
      std::string value = setting.value;
      std::replace(value.begin(), value.end(), '\t', ' ');
      const std::string place   = !setting.place.empty()
                                    ? setting.place
                                    : "--set \"" + quotable(setting.path, 200) +
                                      "=" + quotable(setting.value, 200) +
                                      "\": ",
                        problem = problem_of_value(setting.value);
      if (!problem.empty())
        throw InputError(place + problem);
      set_entry({setting.path, value, place}, entries, prm);
    }

    /**
     * Give the scene of a table the entries of its first state. Throws
     * InputError.
     */
    void apply_first_state(const TableStates &states,
                           const Entries     &entries,
                           ParameterHandler  &prm)
    {
      for (std::size_t d = 0; d < states.entries.size(); ++d)
        set_entry({states.entries[d],
                   exact_text(states.values[0][d]),
                   states.places[d]},
                  entries,
                  prm);
    }
  } // namespace

  namespace
  {
    /**
     * What file and command line give that is not the default.
     */
    PrmEntries
    changed_entries(const Entries                           &entries,
                    const PrmText                           &file,
                    const std::vector<CommandLine::Setting> &settings)
    {
      std::vector<PrmEntry> given = file.entries;
      for (const CommandLine::Setting &setting : settings)
        given.push_back({setting.path, setting.value, ""});
      PrmEntries changed;
      for (const PrmEntry &entry : given)
        if (entries.find(entry.path).is_default(entry.value))
          changed.erase(entry.path);
        else
          changed[entry.path] = entry.value;
      return changed;
    }

    /**
     * What file and command line give, whether it is the default or not.
     */
    std::set<std::string>
    given_entries(const PrmText                           &file,
                  const std::vector<CommandLine::Setting> &settings)
    {
      std::set<std::string> given;
      for (const PrmEntry &entry : file.entries)
        given.insert(entry.path);
      for (const CommandLine::Setting &setting : settings)
        given.insert(setting.path);
      return given;
    }

    /**
     * All entries as a .prm file, with the number in place of an automatic
     * growth of the mesh, unless that is chosen for an error.
     */
    std::string used_entries(const SceneParameters &scene,
                             ParameterHandler      &prm)
    {
      const bool chooses = !scene.mesh.growth && !scene.mesh.target_error;
      const auto set     = [&](const std::string &growth) {
        prm.enter_subsection("Mesh");
        prm.set("Growth", growth);
        prm.leave_subsection();
      };
      if (chooses)
        set(significant(scene.mesh.growth_in(scene.dimension), 6));
      std::ostringstream used;
      prm.print_parameters(used, ParameterHandler::ShortText);
      if (chooses)
        set("automatic");
      return used.str();
    }

    Entries declare(SceneParameters &scene)
    {
      const std::vector<AnalysisKind> &kinds = analysis_kinds();
      return scene.declare({kinds.begin(), kinds.end()});
    }
  } // namespace

  SceneInput read_scene(const CommandLine &command_line)
  {
    return scene_of_text(
      read_prm(command_line.prm_file),
      command_line.prm_file,
      std::filesystem::path(command_line.prm_file).parent_path(),
      command_line.settings);
  }

  SceneInput scene_of_text(const PrmText                           &file,
                           const std::string                       &name,
                           const std::filesystem::path             &folder,
                           const std::vector<CommandLine::Setting> &settings)
  {
    SceneParameters  scene;
    ParameterHandler prm;
    const Entries    entries = declare(scene);
    entries.declare(prm);
    scene.prm_folder = folder;
    for (const PrmEntry &section : file.sections)
      entries.check_section(section);
    try
      {
        for (const PrmEntry &entry : file.entries)
          set_entry(entry, entries, prm);
      }
    catch (const ExceptionBase &error)
      {
        throw InputError(name + ": " + quotable(message_of(error), 300));
      }
    for (const auto &setting : settings)
      apply_setting(setting, entries, prm);
    const std::string used = used_entries(scene, prm);
    if (scene.analysis.has_many_states)
      apply_first_state(table_states(scene.table, scene.prm_folder),
                        entries,
                        prm);
    scene.check();
    SceneInput input{Situation(scene), file.text, used, {}};
    if (scene.analysis.has_contact)
      {
        check_mesh_units(input.scene);
        check_moving_surfaces(input.scene);
      }
    std::optional<TablePlan> table;
    if (scene.analysis.has_many_states)
      table = plan_table(input.scene); // all states of it are possible
    if (const auto check = analysis_kind(scene.analysis.name).check_situation)
      check(input.scene);
    input.warnings =
      unused_entries(scene, changed_entries(entries, file, settings));
    const auto doubts =
      doubts_of(input.scene, table, given_entries(file, settings));
    input.warnings.insert(input.warnings.end(), doubts.begin(), doubts.end());
    return input;
  }

  std::string documented_parameters()
  {
    SceneParameters  scene;
    ParameterHandler prm;
    declare(scene).declare(prm);
    std::ostringstream text;
    prm.print_parameters(text, ParameterHandler::PRM);
    return text.str();
  }

  std::string parameters_as_json()
  {
    SceneParameters scene;
    return entries_as_json(declare(scene));
  }
} // namespace RollingContact
