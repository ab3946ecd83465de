#ifndef rolling_contact_program_scene_reader_h
#define rolling_contact_program_scene_reader_h

#include <rolling_contact/program/command_line.h>
#include <rolling_contact/scene/scene_parameters.h>

namespace RollingContact
{
  /**
   * A scene as read: its file, the settings of the command line applied, and
   * the whole as deal.II writes it back.
   */
  struct SceneText
  {
    std::string original; ///< the file
    std::string used;     ///< every entry that differs from its default
  };

  /**
   * Read and check a scene. Throws InputError, one message with file and line
   * where deal.II knows them.
   */
  SceneText
  read_scene(const CommandLine &command_line, SceneParameters &scene);

  /**
   * The same when the parameters are declared already and have their defaults.
   */
  SceneText
  read_declared_scene(const CommandLine &command_line, SceneParameters &scene);

  /**
   * Every parameter with its default and documentation, as a .prm file.
   */
  std::string
  documented_parameters();
} // namespace RollingContact

#endif
