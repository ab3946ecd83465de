#include <deal.II/base/parameter_handler.h>

#include <rolling_contact/base/exception_text.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/input/prm_text.h>
#include <rolling_contact/pair/mesh_unit_check.h>
#include <rolling_contact/program/analysis_table.h>
#include <rolling_contact/program/scene_reader.h>

#include <algorithm>
#include <sstream>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    /**
     * Set Section/Entry (or Entry) of @p prm; the entry must be declared.
     */
    void
    apply_setting(const CommandLine::Setting &setting, ParameterHandler &prm)
    {
      std::vector<std::string> sections;
      std::istringstream       path(setting.path);
      for (std::string part; std::getline(path, part, '/');)
        sections.push_back(part);
      const std::string entry = sections.empty() ? "" : sections.back();
      const std::string option =
        "--set \"" + setting.path + "=" + setting.value + "\"";
      if (!entry.empty())
        sections.pop_back();
      for (const std::string &section : sections)
        prm.enter_subsection(section);
      std::string value = setting.value, problem = problem_of_value(value);
      std::replace(value.begin(), value.end(), '\t', ' ');
      try
        {
          prm.get(entry);
          if (problem.empty())
            prm.set(entry, value);
        }
      catch (const ParameterHandler::ExcEntryUndeclared &)
        {
          problem = "there is no such entry; see --print-parameters.";
        }
      catch (const ExceptionBase &error)
        {
          problem = message_of(error);
        }
      for (std::size_t k = 0; k < sections.size(); ++k)
        prm.leave_subsection();
      if (!problem.empty())
        throw InputError(option + ": " + problem);
    }
  } // namespace



  namespace
  {
    void
    declare(SceneParameters &scene, ParameterHandler &prm)
    {
      std::vector<DescribedChoice> analyses;
      for (const AnalysisKind &kind : analysis_kinds())
        analyses.push_back({kind.name, kind.help});
      scene.declare(prm, analyses);
    }
  } // namespace



  SceneInput
  read_scene(const CommandLine &command_line)
  {
    SceneInput       input;
    SceneParameters &scene = input.scene;
    ParameterHandler prm;
    declare(scene, prm);
    scene.prm_folder =
      std::filesystem::path(command_line.prm_file).parent_path();
    input.original = read_prm(command_line.prm_file);
    try
      {
        std::istringstream lines(input.original);
        prm.parse_input(lines, command_line.prm_file);
      }
    catch (const ExceptionBase &error)
      {
        throw InputError(command_line.prm_file + ": " + message_of(error));
      }
    for (const auto &setting : command_line.settings)
      apply_setting(setting, prm);
    scene.check();
    scene.read_meshes();
    check_mesh_units(scene);
    std::ostringstream used;
    prm.print_parameters(used, ParameterHandler::ShortText);
    input.used = used.str();
    return input;
  }



  std::string
  documented_parameters()
  {
    SceneParameters  scene;
    ParameterHandler prm;
    declare(scene, prm);
    std::ostringstream text;
    prm.print_parameters(text, ParameterHandler::PRM);
    return text.str();
  }
} // namespace RollingContact
