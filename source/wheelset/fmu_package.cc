#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/files.h>
#include <rolling_contact/fmu/description.h>
#include <rolling_contact/fmu/program_forces.h>
#include <rolling_contact/fmu/resources.h>
#include <rolling_contact/fmu/stored_zip.h>
#include <rolling_contact/wheelset/fmu_package.h>
#include <rolling_contact/wheelset/fmu_states.h>

#include <regex>

namespace RollingContact
{
  namespace
  {
    namespace fs = std::filesystem;

    using Files = std::vector<std::pair<std::string, std::string>>;

    fs::path this_program()
    {
      std::error_code error;
      return fs::read_symlink("/proc/self/exe", error);
    }

    std::string documentation(const Fmu::DescriptionText &text)
    {
      const std::string same =
        "SI units; x forwards, y to the right, z down; forces act on the "
        "wheels, moments are about the centre of the wheelset. The scene is "
        "resources/scene.prm.</p>\n";
      const std::string of_table =
        "<p>Forces between the wheels of a wheelset and its rails, from a "
        "table of states by finite elements, by rolling-contact. " +
        same +
        "<p>The binary is under LGPL-2.1-or-later and needs nothing but the "
        "libraries of C and C++.</p>\n";
      const std::string of_states =
        "<p>Forces between the wheels of a wheelset and its rails. Each state "
        "is solved by finite elements when it is asked for, by the program "
        "rolling-contact in a process of its own. " +
        same +
        "<p>The program must be installed on the machine. It is the one that "
        "the parameter program names, else the environment variable "
        "ROLLING_CONTACT_PROGRAM, else " +
        text.program +
        ", else rolling-contact in a folder of PATH.</p>\n"
        "<p>The binary of this unit is under LGPL-2.1-or-later and needs "
        "nothing but the libraries of C and C++. The program is linked with "
        "CHOLMOD's supernodal factorisation, which is under the GNU General "
        "Public License, version 2 or later, and so is the program as a whole. "
        "It is no part of this unit, which starts it as a process and talks to "
        "it through a socket.</p>\n";
      return "<!DOCTYPE html>\n<html><head><title>" + text.title +
             "</title></head><body>\n<h1>" + text.title + "</h1>\n" +
             (text.kind == Fmu::ForceKind::table ? of_table : of_states) +
             "</body></html>\n";
    }

    Fmu::DescriptionText description_of(const Situation     &scene,
                                        const Fmu::Wheelset &wheelset,
                                        const RunContext    &context)
    {
      Fmu::DescriptionText text;
      text.title = "Wheelset with forces of rolling contact: " +
                   scene.profiles.wheel_profile + " on " +
                   scene.profiles.rail_profile;
      text.version     = context.report.version;
      text.start       = wheelset.start;
      text.radius      = wheelset.radius;
      text.tape_circle = wheelset.tape_circle;
      return text;
    }

    std::string used_scene(const RunContext &context)
    {
      return read_bytes(context.folder.get_path() / "used.prm");
    }

    /** Two files that hold these resources. */
    void write(const std::string   &name,
               Fmu::DescriptionText text,
               const Files         &resources,
               const RunContext    &context)
    {
      const std::string binary = fmu_binary();
      std::string all = Fmu::description_2(text) + Fmu::description_3(text);
      for (const auto &file : resources)
        all += file.second;
      text.token = Fmu::token_of(all);
      for (const unsigned int version : {2, 3})
        {
          Files files{{"modelDescription.xml",
                       version == 2 ? Fmu::description_2(text)
                                    : Fmu::description_3(text)},
                      {std::string(version == 2 ? "binaries/linux64/"
                                                : "binaries/x86_64-linux/") +
                         Fmu::model_name + ".so",
                       binary},
                      {std::string("resources/") + Fmu::token_file,
                       text.token}};
          for (const auto &file : resources)
            files.emplace_back("resources/" + file.first, file.second);
          files.emplace_back("documentation/index.html", documentation(text));
          context.folder.write_atomically(name + "_fmi" +
                                            std::to_string(version) + ".fmu",
                                          Fmu::stored_zip(files));
        }
      context.report.set_finding(text.kind == Fmu::ForceKind::table ? "fmu"
                                                                    : "states",
                                 name + "_fmi2.fmu and " + name +
                                   "_fmi3.fmu, " + text.token);
    }

    /** Pack the file of a profile, and have the scene read it from there. */
    void pack_profile(const std::string &entry,
                      const std::string &profile,
                      const fs::path    &folder,
                      std::string       &scene,
                      Files             &resources)
    {
      const fs::path    file = folder / profile;
      const std::string name = (entry == "Wheel profile" ? "wheel" : "rail") +
                               file.extension().string();
      resources.emplace_back(name, read_bytes(file));
      scene =
        std::regex_replace(scene,
                           std::regex("(\n *set " + entry + " *=) [^\n]*"),
                           "$1 " + name);
    }
  } // namespace

  std::string fmu_binary()
  {
    std::error_code       error;
    const fs::path        program = this_program().parent_path();
    const std::string     name    = std::string(Fmu::model_name) + ".so";
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

  void write_fmus_of_table(const Situation          &scene,
                           const Fmu::WheelsetModel &model,
                           const RunContext         &context)
  {
    write("wheelset",
          description_of(scene, model, context),
          {{Fmu::table_file, model.bytes()},
           {Fmu::scene_file, used_scene(context)}},
          context);
  }

  void write_fmus_of_states(const Situation &scene, const RunContext &context)
  {
    const Fmu::Wheelset  wheelset = fmu_wheelset(scene);
    Fmu::DescriptionText text     = description_of(scene, wheelset, context);
    text.kind                     = Fmu::ForceKind::program;
    text.program                  = this_program().string();
    std::string     prm           = used_scene(context);
    const fs::path &folder        = scene.inputs->prm_folder;
    Files           resources{
      {Fmu::values_file, Fmu::program_values(wheelset, text.program)}};
    if (scene.profiles.wheel_is_file())
      pack_profile(
        "Wheel profile", scene.profiles.wheel_profile, folder, prm, resources);
    if (scene.profiles.rail_is_file())
      pack_profile(
        "Rail profile", scene.profiles.rail_profile, folder, prm, resources);
    resources.emplace_back(Fmu::scene_file, prm);
    write("wheelset_states", text, resources, context);
  }
} // namespace RollingContact
