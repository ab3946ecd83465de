#include <rolling_contact/base/text.h>
#include <rolling_contact/scene/plausibility.h>
#include <rolling_contact/scene/scene_parameters.h>
#include <rolling_contact/surfaces/profile_doubts.h>

#include <tuple>

namespace RollingContact
{
  namespace
  {
    void add_doubts(const std::string           &profile,
                    const Profiles::FileOptions &options,
                    const Profiles::ProfileKind  kind,
                    const SceneParameters       &scene,
                    std::vector<std::string>    &doubts)
    {
      const std::filesystem::path file = scene.prm_folder / profile;
      for (const std::string &doubt : Profiles::doubts_of_points(
             Profiles::read_points(file, options), kind, file.string()))
        doubts.push_back(doubt);
    }

    /** Whether the analysis meshes bodies for a patch. */
    bool meshes_a_patch(const SceneParameters &scene)
    {
      return scene.analysis.has_contact && !scene.analysis.has_own_meshes &&
             !scene.mesh.target_error;
    }
  } // namespace

  std::vector<std::string> doubtful_profiles(const SceneParameters &scene)
  {
    std::vector<std::string> doubts;
    const auto              &profiles = scene.profiles;
    if (scene.analysis.has_bodies && !profiles.in_use())
      return doubts;
    if (profiles.wheel_is_file())
      add_doubts(profiles.wheel_profile,
                 profiles.file_options(profiles.wheel_mirror),
                 Profiles::ProfileKind::wheel,
                 scene,
                 doubts);
    if (profiles.rail_is_file())
      add_doubts(profiles.rail_profile,
                 profiles.file_options(profiles.rail_mirror),
                 Profiles::ProfileKind::rail,
                 scene,
                 doubts);
    return doubts;
  }

  std::vector<std::string> doubtful_defaults(const SceneParameters       &scene,
                                             const std::set<std::string> &given)
  {
    std::vector<std::string> doubts;
    if (!meshes_a_patch(scene))
      return doubts;
    for (const BodyParameters *body : {&scene.wheel, &scene.rail})
      if (body->shape == "block" && body->radius != 0. &&
          given.count(body->section + "/Radius") == 0)
        doubts.push_back(body->section + "/Shape = block without " +
                         body->section +
                         "/Radius: the block is curved along x by the default "
                         "of " +
                         significant(body->radius, 3) +
                         " m, like a roller; a straight rail has Radius = 0.");
    for (const auto &[entry, by_default, usual] :
         {std::tuple("Mesh/Elements across patch",
                     std::to_string(scene.mesh.elements_across_patch),
                     "16"),
          std::tuple("Mesh/Growth", significant(scene.mesh.growth, 2), "0.4")})
      if (scene.dimension == 3 && given.count(entry) == 0)
        doubts.push_back("Dimension = 3 without " + std::string(entry) +
                         ": the default, " + by_default +
                         ", is for 2D and may take minutes and 20 GB in 3D, "
                         "where " +
                         usual + " is usual.");
    return doubts;
  }
} // namespace RollingContact
