#include "bindings.h"
#include <fmt/format.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>

namespace RollingContact::Bindings
{
  namespace
  {
    std::vector<CommandLine::Setting> settings_of(const py::object &given)
    {
      std::vector<CommandLine::Setting> settings;
      if (given.is_none())
        return settings;
      if (!py::isinstance<py::dict>(given))
        throw py::type_error("settings must be a dict of entries and values, "
                             "{\"Contact/Creepage x\": 1e-3}.");
      for (const auto &[key, value] : py::reinterpret_borrow<py::dict>(given))
        {
          if (!py::isinstance<py::str>(key))
            throw py::type_error("settings: an entry is a text, "
                                 "\"Section/Entry\".");
          const std::string path = key.cast<std::string>();
          const std::string text = text_of_value(path, value);
          settings.push_back({path,
                              text,
                              "settings[\"" + quotable(path, 200) +
                                "\"] = " + quotable(text, 200) + ": "});
        }
      return settings;
    }

    /** The entries of a scene, not yet read. */
    Scene draft(const PrmText               &text,
                const std::string           &name,
                const std::filesystem::path &folder)
    {
      Scene scene{{}, text, name, folder, {}, {}, {}, {}};
      for (const PrmEntry &entry : text.entries)
        scene.entries[entry.path] = entry.value;
      return scene;
    }

    void add(const std::vector<CommandLine::Setting> &settings, Scene &scene)
    {
      for (const CommandLine::Setting &setting : settings)
        {
          scene.settings.push_back(setting);
          scene.entries[setting.path] = setting.value;
        }
    }

    std::shared_ptr<const Scene> read(Scene scene)
    {
      SceneInput input =
        scene_of_text(scene.text, scene.name, scene.folder, scene.settings);
      scene.warnings  = std::move(input.warnings);
      scene.situation = std::move(input.scene);
      return std::make_shared<const Scene>(std::move(scene));
    }

    Scene draft_of_text(const std::string           &text,
                        const std::filesystem::path &folder)
    {
      const std::string name = "the text";
      return draft(read_prm_text(text, name), name, folder);
    }

    Scene draft_of(const py::object &source, const py::object &settings)
    {
      Scene scene;
      if (py::isinstance<Scene>(source))
        scene = *source.cast<std::shared_ptr<Scene>>();
      else if (py::isinstance<py::str>(source) ||
               py::hasattr(source, "__fspath__"))
        {
          const auto path =
            py::isinstance<py::str>(source)
              ? source.cast<std::string>()
              : py::str(source.attr("__fspath__")()).cast<std::string>();
          scene = path.find('\n') != std::string::npos
                    ? draft_of_text(path, "")
                    : draft(read_prm(path),
                            path,
                            std::filesystem::path(path).parent_path());
        }
      else
        throw py::type_error(
          "a scene is a path, a text or a Scene, not " +
          py::repr(py::type::of(source)).cast<std::string>() + '.');
      add(settings_of(settings), scene);
      return scene;
    }

    double given_length(const Scene &scene, const std::string &entry)
    {
      const auto found = scene.entries.find(entry);
      return found == scene.entries.end() ? 0.
                                          : number(found->second).value_or(0.);
    }
  } // namespace

  std::string text_of_value(const std::string &entry, const py::handle &value)
  {
    if (py::isinstance<py::str>(value))
      return value.cast<std::string>();
    if (py::isinstance<py::bool_>(value))
      return value.cast<bool>() ? "true" : "false";
    if (PyIndex_Check(value.ptr())) // int, and those of numpy
      return py::str(py::int_(py::reinterpret_borrow<py::object>(value)));
    if (PyNumber_Check(value.ptr()))
      {
        const double number = PyFloat_AsDouble(value.ptr());
        if (!(PyErr_Occurred()))
          return fmt::format("{}", number);
        PyErr_Clear();
      }
    throw py::type_error(
      entry + ": a value is a text, a number or True or False, not " +
      py::repr(py::type::handle_of(value)).cast<std::string>() + '.');
  }

  std::shared_ptr<const Scene> make_scene(const py::object &source,
                                          const py::object &settings)
  {
    return read(draft_of(source, settings));
  }

  std::shared_ptr<const Scene> make_scene_of(const std::string &analysis,
                                             const py::object  &source,
                                             const py::object  &settings)
  {
    Scene scene = draft_of(source, settings);
    add({{"Analysis", analysis}}, scene);
    return read(scene);
  }

  std::shared_ptr<const Scene>
  make_scene_in_time(const py::object           &source,
                     const py::object           &settings,
                     const std::optional<double> time_step)
  {
    Scene scene = draft_of(source, settings);
    add({{"Analysis", "transient"}}, scene);
    if (time_step)
      {
        const std::string text = fmt::format("{}", *time_step);
        add({{"Time/Time step", text, "time_step = " + text + ": "},
             {"Time/Step length", "0"}},
            scene);
      }
    if (given_length(scene, "Time/End time") == 0. &&
        given_length(scene, "Time/Rolled distance") == 0.)
      for (const auto &[step, end] :
           {std::pair("Time/Time step", "Time/End time"),
            std::pair("Time/Step length", "Time/Rolled distance")})
        if (given_length(scene, step) > 0.)
          add({{end, scene.entries.at(step)}}, scene);
    return read(scene);
  }

  void define_scene(py::module_ &module)
  {
    py::class_<Scene, std::shared_ptr<Scene>>(
      module, "Scene", "A scene: the entries of a .prm file, read and checked.")
      .def(py::init([](const py::object &source, const py::object &settings) {
             return std::const_pointer_cast<Scene>(
               make_scene(source, settings));
           }),
           py::arg("source"),
           py::arg("settings") = py::none(),
           "Read a .prm file (its path), the text of one (with line ends) or "
           "another Scene. settings {\"Section/Entry\": value} replace its "
           "entries, as --set of the program does. Raises InputError.")
      .def_static(
        "from_text",
        [](const std::string &text,
           const std::string &folder,
           const py::object  &settings) {
          Scene scene = draft_of_text(text, folder);
          add(settings_of(settings), scene);
          return std::const_pointer_cast<Scene>(read(scene));
        },
        py::arg("text"),
        py::arg("folder")   = "",
        py::arg("settings") = py::none(),
        "Read a text. Names of files in it are relative to the folder. Raises "
        "InputError.")
      .def_property_readonly(
        "entries",
        [](const Scene &scene) { return scene.entries; },
        "All entries that the file and the settings give, as texts; other "
        "entries have their defaults.")
      .def_property_readonly(
        "warnings",
        [](const Scene &scene) { return scene.warnings; },
        "Warnings: entries without effect, and values that look wrong.")
      .def_property_readonly(
        "dimension",
        [](const Scene &scene) { return scene.situation->dimension; },
        "The dimension, 2 or 3.")
      .def("__repr__", [](const Scene &scene) {
        return "<rolling_contact.Scene of " + scene.name + ">";
      });
  }
} // namespace RollingContact::Bindings
