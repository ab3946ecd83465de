#include <rolling_contact/base/text.h>
#include <rolling_contact/scene/pair_spec.h>
#include <rolling_contact/scene/plausibility.h>
#include <rolling_contact/scene/scene_parameters.h>
#include <rolling_contact/surfaces/profile_doubts.h>

#include <algorithm>

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
    if (scene.analysis.has_bodies ? !profiles.in_use()
                                  : profiles.has_radius_difference())
      return doubts;
    if (profiles.wheel_is_file())
      add_doubts(profiles.wheel_profile,
                 profiles.file_options(Profiles::ProfileKind::wheel),
                 Profiles::ProfileKind::wheel,
                 scene,
                 doubts);
    if (profiles.rail_is_file())
      add_doubts(profiles.rail_profile,
                 profiles.file_options(Profiles::ProfileKind::rail),
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
    if (scene.dimension == 3 && given.count("Mesh/Elements across patch") == 0)
      doubts.push_back("Dimension = 3 without Mesh/Elements across patch: the "
                       "default, " +
                       std::to_string(scene.mesh.elements_across_patch) +
                       ", is for 2D and may take minutes and 20 GB in 3D, "
                       "where 16 is usual.");
    return doubts;
  }

  namespace
  {
    /**
     * How far behind the contact point the bore of a section is, if its hub is
     * one: edges along the axle that nothing is behind. Units: m.
     */
    std::optional<double> depth_of_bore(const FileMesh &mesh,
                                        const double    tolerance)
    {
      double depth = 0.;
      for (const FileMesh::Point &vertex : mesh.vertices)
        depth = std::max(depth, -vertex[2]);
      for (const FileMesh::Face &edge : mesh.hub_faces)
        for (const unsigned int end : {edge[0], edge[1]})
          if (depth + mesh.vertices[end][2] > tolerance)
            return {};
      return mesh.hub_faces.empty() ? std::nullopt : std::optional(depth);
    }
  } // namespace

  std::vector<std::string> doubtful_bore(const PairSpec &scene)
  {
    // bores over the radius, as they are and usually; smaller ones are holes
    // along a solid axle, and larger ones those of rims alone
    const double smallest = 0.03, small = 0.12, usual = 0.2, large = 0.35,
                 largest = 0.7, on_circle = 0.02;
    const BodySpec &wheel = scene.wheel;
    if (!wheel.is_section() || !wheel.mesh || !(wheel.radius > 0.))
      return {};
    const auto depth = depth_of_bore(*wheel.mesh, on_circle * wheel.radius);
    if (!depth)
      return {};
    const double bore = wheel.radius - *depth, share = bore / wheel.radius;
    if (share < smallest || share > largest || (share > small && share < large))
      return {};
    return {"Wheel/Radius = " + significant(wheel.radius, 6) +
            " m is hardly that of Wheel/Mesh file = " + wheel.mesh_file +
            ": its bore, " + significant(*depth, 4) +
            " m behind the contact point, would have a radius of " +
            significant(bore, 3) + " m, " + significant(100 * share, 2) +
            " % of the wheel's, where 15 to 30 % are usual; is it the section "
            "of a wheel of about " +
            significant(*depth / (1 - usual), 2) + " m?"};
  }
} // namespace RollingContact
