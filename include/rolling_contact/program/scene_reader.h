#ifndef rolling_contact_program_scene_reader_h
#define rolling_contact_program_scene_reader_h

#include <rolling_contact/input/prm_text.h>
#include <rolling_contact/program/command_line.h>
#include <rolling_contact/scene/situation.h>

#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * A scene as read and the texts it came from: its file, and the whole as
   * deal.II writes it back, settings of the command line included.
   */
  struct SceneInput
  {
    Situation   scene;
    std::string original; ///< the file
    std::string used;     ///< every entry that differs from its default
    /** Entries without effect and values that are hardly meant so. */
    std::vector<std::string> warnings;
  };

  /**
   * Read and check a scene. Throws InputError, one message with file and line
   * where deal.II knows them.
   */
  SceneInput read_scene(const CommandLine &command_line);

  /**
   * The scene of a text that was read; files it names are relative to a @p
   * folder, and @p name stands for the text in messages. Throws InputError.
   */
  SceneInput scene_of_text(const PrmText                           &text,
                           const std::string                       &name,
                           const std::filesystem::path             &folder,
                           const std::vector<CommandLine::Setting> &settings);

  /**
   * Every parameter with its default and documentation, as a .prm file.
   */
  std::string documented_parameters();

  /**
   * Every parameter with its default, meaning, unit and allowed values, as
   * entries_as_json() of `scene/entries.h` writes them.
   */
  std::string parameters_as_json();
} // namespace RollingContact

#endif
