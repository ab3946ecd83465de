#include <rolling_contact/advice/idle_entries.h>
#include <rolling_contact/advice/unused_entries.h>
#include <rolling_contact/scene/scene_parameters.h>

#include <set>

namespace RollingContact
{
  namespace
  {
    /** The sections that only some analyses read, and who reads them. */
    std::map<std::string, std::string>
    idle_sections(const SceneParameters &scene)
    {
      const bool is_study = scene.analysis == "accuracy study";
      std::map<std::string, std::string> idle;
      if (scene.analysis != "creep curve")
        idle["Creep curve"] = "Analysis = creep curve reads that section";
      if (scene.analysis != "load curve")
        idle["Load curve"] = "Analysis = load curve reads that section";
      if (!scene.is_of_table())
        idle["Table"] = "Analysis = table or stability map reads that section";
      const bool is_stability = scene.is_of_stability();
      const bool by_modes     = is_stability || scene.has_reduced_bodies();
      if (!scene.is_of_structures() && !by_modes)
        idle["Modes"] = "Analysis = modes, receptance, stability and stability "
                        "map and Time/Bodies = reduced read that section";
      if (!by_modes)
        idle["Stability"] =
          "Analysis = stability or stability map reads that section";
      if (scene.analysis != "receptance")
        idle["Receptance"] = "Analysis = receptance reads that section";
      if (scene.is_of_structures())
        for (const char *section : {"Mesh", "Surfaces"})
          idle[section] = "an analysis of contact reads that section";
      if (scene.analysis == "contact table")
        for (const char *section : {"Contact", "Mesh", "Surfaces"})
          idle[section] = "an analysis with finite elements reads that section";
      else
        idle["Contact table"] = "Analysis = contact table reads that section";
      if (scene.analysis != "contact table" && !scene.profiles.in_use())
        idle["Profiles"] = "bodies with a Profiles/Wheel profile and Rail "
                           "profile read that section";
      if (!is_study)
        idle["Accuracy study"] = "Analysis = accuracy study reads that section";
      if (scene.analysis != "transient")
        for (const char *section : {"Spectrum", "Sound"})
          idle[section] = "Analysis = transient reads that section";
      const bool finds_cycles = scene.analysis == "limit cycle";
      if (!finds_cycles)
        idle["Limit cycle"] = "Analysis = limit cycle reads that section";
      if (scene.analysis != "transient" && !finds_cycles &&
          !(is_study && scene.study.varies_time_step))
        idle["Time"] = is_study ? "Accuracy study/Vary = time step reads that "
                                  "section"
                                : "Analysis = transient reads that section";
      return idle;
    }



    /** Entries that the dimension has no place for, and why. */
    std::map<std::string, std::string>
    entries_of_other_dimension(const SceneParameters &scene)
    {
      if (scene.dimension == 3)
        {
          const std::string why = "it is that of plane strain, Dimension = 2; "
                                  "in 3D a body has a Width";
          return {{"Wheel/Thickness", why}, {"Rail/Thickness", why}};
        }
      const std::string why = "it has a meaning in 3D only";
      return {{"Wheel/Width", why},
              {"Rail/Width", why},
              {"Mesh/Elements across patch y", why}};
    }



    /** Entries on profiles that this scene has no use for, and why. */
    std::map<std::string, std::string>
    idle_profile_entries(const SceneParameters &scene)
    {
      std::map<std::string, std::string> idle;
      const bool is_table = scene.analysis == "contact table";
      if (is_table)
        for (const char *entry : {"Side",
                                  "Contact surface",
                                  "Lateral shift",
                                  "Roll",
                                  "Creepages",
                                  "Pitch rate",
                                  "Body sections",
                                  "Web bow"})
          idle["Profiles/" + std::string(entry)] =
            "a contact table has both sides, its own shifts, no creepages and no "
            "bodies";
      if (!is_table && !scene.profiles.in_use())
        return idle;
      if (!is_table && !scene.profiles.gives_creepages())
        idle["Profiles/Pitch rate"] =
          "Profiles/Creepages = from kinematics reads it";
      if (!is_table && (!scene.profiles.true_sections || scene.wheel.rigid))
        idle["Profiles/Web bow"] =
          "Profiles/Body sections = true reads it, for an elastic wheel";
      if (!is_table && scene.profiles.true_sections)
        {
          const std::string why = "Profiles/Body sections = true gives the "
                                  "bodies' sections";
          for (const char *entry :
               {"Wheel/Width", "Rail/Width", "Rail/Block depth"})
            idle[entry] = why;
        }
      if (!scene.profiles.has_files())
        for (const char *entry :
             {"Smoothing length", "File unit", "Wheel mirror", "Rail mirror"})
          idle["Profiles/" + std::string(entry)] =
            "neither Profiles/Wheel profile nor Rail profile is a file";
      return idle;
    }



    /** Why section Contact's forces are not asked for; empty if they are. */
    std::string
    giver_of_forces(const SceneParameters &scene)
    {
      return scene.analysis == "creep curve"
               ? "the forces of a curve are those of section Creep curve"
               : "";
    }



    /** Who gives the creepages in place of section Contact; empty if none. */
    std::string
    giver_of_creepages(const SceneParameters &scene)
    {
      if (scene.profiles.gives_creepages())
        return "Profiles/Creepages = from kinematics gives them";
      if (scene.analysis == "creep curve")
        return scene.mesh.adaptive_levels > 0 ? ""
                                              : // what the levels refine for
                 "the creepages of a curve are those of section Creep curve";
      return scene.analysis == "accuracy study" && !scene.study.varies_time_step
               ? "the creepages of a study are Accuracy study/Creepages over "
                 "saturation"
               : "";
    }
  } // namespace



  std::vector<std::string>
  unused_entries(const SceneParameters &scene, const PrmEntries &given)
  {
    std::vector<std::string> warnings;
    const auto warn = [&](const std::string &entries, const std::string &why) {
      warnings.push_back(entries + " has no effect: " + why + ".");
    };
    for (const auto &[section, why] : idle_sections(scene))
      {
        std::string entries;
        for (const auto &[path, value] : given)
          if (path.compare(0, section.size() + 1, section + '/') == 0)
            entries += (entries.empty() ? "" : ", ") + path + " = " + value;
        if (!entries.empty())
          warn(entries, why + ", not " + scene.analysis);
      }
    const auto check = [&](const std::string &path, const std::string &why) {
      const auto entry = given.find(path);
      if (entry != given.end())
        warn(path + " = " + entry->second, why);
    };
    for (const auto &[path, why] : entries_of_other_dimension(scene))
      check(path, why);
    for (const auto &[path, why] : idle_profile_entries(scene))
      check(path, why);
    for (const auto &[path, why] : idle_body_entries(scene))
      check(path, why);
    for (const auto &[path, why] : idle_entries_in_time(scene))
      check(path, why);
    if (!scene.limit_cycle.axis_entry().empty() &&
        scene.analysis == "limit cycle")
      check(scene.limit_cycle.axis_entry(), "Limit cycle/Values gives it");
    const std::string missing = missing_spectrum(scene);
    if (!missing.empty())
      warnings.push_back(missing);
    if (scene.analysis == "transient" || scene.analysis == "accuracy study")
      check("Mesh/Target error",
            scene.analysis == "transient"
              ? "the error of a time step is not known beforehand; "
                "Mesh/Elements across patch gives the mesh"
              : "a study has its own meshes, Accuracy study/Elements across "
                "patch");
    if (scene.is_of_table())
      for (const TableAxis &axis : scene.table.axes())
        check(axis.entry, axis.name + " gives it");
    const std::string giver = giver_of_creepages(scene);
    if (!giver.empty())
      for (const char *path :
           {"Contact/Creepage x", "Contact/Creepage y", "Contact/Spin"})
        check(path, giver);
    const std::string why = giver_of_forces(scene);
    if (!why.empty())
      for (const char *path : {"Contact/Longitudinal force",
                               "Contact/Lateral force",
                               "Contact/Spin moment"})
        check(path, why);
    return warnings;
  }
} // namespace RollingContact
