#include <rolling_contact/base/text.h>
#include <rolling_contact/scene/scene_parameters.h>
#include <rolling_contact/scene/unused_entries.h>

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
        idle["Spectrum"] = "Analysis = transient reads that section";
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



    /** Entries on surfaces that move for which there is no use, and why. */
    std::map<std::string, std::string>
    idle_surface_entries(const SceneParameters &scene)
    {
      std::map<std::string, std::string> idle;
      if (scene.analysis == "contact table")
        return idle;
      const SurfaceParameters &surfaces = scene.surfaces;
      const std::string smooth = "Surfaces/Wheel height and Rail height are "
                                 "empty";
      if (!surfaces.in_use() && surfaces.friction_share.empty())
        idle["Surfaces/Position"] = smooth;
      if (!surfaces.records.wheel && !surfaces.records.rail)
        for (const char *entry :
             {"Shortest wavelength", "Position unit", "Height unit"})
          idle["Surfaces/" + std::string(entry)] =
            surfaces.in_use() ? "it is that of a file, and an expression gives "
                                "the heights"
                              : smooth;
      if (scene.analysis == "transient" &&
          !scene.spectrum.wanted(surfaces.in_use()))
        for (const char *entry : {"Skipped time", "Segment length"})
          idle["Spectrum/" + std::string(entry)] =
            scene.spectrum.write == WriteSpectrum::never
              ? "Spectrum/Write = never"
              : "no surface moves; take Spectrum/Write = always";
      return idle;
    }



    /** What is wanted of a run that is too short for it; empty if nothing. */
    std::string
    missing_spectrum(const SceneParameters &scene)
    {
      const auto &[skipped, segment] =
        std::pair(scene.spectrum.skipped_time, scene.spectrum.segment_length);
      if (scene.analysis != "transient" || (skipped == 0. && segment == 0.) ||
          !scene.spectrum.wanted(scene.surfaces.in_use()))
        return "";
      const std::string why = scene.spectrum.why_none(scene.time.steps(
        scene.time.histories(scene.contact, scene.prm_folder).speed));
      return why.empty()
               ? ""
               : "There will be no spectra, Spectrum/Skipped time = " +
                   significant(skipped, 6) +
                   " s, Segment length = " + significant(segment, 6) +
                   " s: " + why;
    }



    /** Entries of section Time on its end and its files without use, and why.
     */
    std::map<std::string, std::string>
    idle_entries_of_the_end(const SceneParameters &scene)
    {
      std::map<std::string, std::string> idle;
      if (scene.analysis == "limit cycle")
        idle[scene.limit_cycle.axis_entry()] = "Limit cycle/Values gives it";
      if (scene.analysis == "limit cycle")
        for (const char *entry : {"Stop when periodic",
                                  "Field interval",
                                  "Checkpoint interval",
                                  "Checkpoint seconds"})
          idle["Time/" + std::string(entry)] =
            "each run of a limit cycle ends when it is periodic, with a row";
      if (scene.analysis == "transient" && !scene.looks_for_cycles())
        for (const char *entry : {"Periodic tolerance", "Periodic after"})
          idle["Time/" + std::string(entry)] =
            "Time/Stop when periodic = true reads it";
      return idle;
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



  namespace
  {
    /** Of the supports of a body, entries without a use, and why. */
    void
    add_idle_supports(const BodyParameters               &body,
                      const unsigned int                  dimension,
                      std::map<std::string, std::string> &idle)
    {
      const Foundation &foundation = body.model.foundation;
      const auto        add = [&](const std::vector<std::string> &entries,
                           const std::string              &why) {
        for (const std::string &entry : entries)
          idle.emplace(body.section + '/' + entry, why);
      };
      const std::vector<std::string> pads{"Pad length",
                                          "Pad offset",
                                          "Sleeper mass"},
        ballast{"Ballast stiffness x",
                "Ballast stiffness y",
                "Ballast stiffness z",
                "Ballast loss factor"};
      if (dimension == 2)
        add({"Foundation stiffness y",
             "Ballast stiffness y",
             "Hub inertia x",
             "Hub inertia z"},
            "it has a meaning in 3D only");
      if (body.rigid || body.hub != Hub::elastic)
        {
          const std::string why = "an elastic body with Hub = elastic reads it";
          add({"Foundation stiffness x",
               "Foundation stiffness y",
               "Foundation stiffness z",
               "Foundation loss factor",
               "Pad spacing"},
              why);
          add(pads, why);
          add(ballast, why);
        }
      if (foundation.pad_spacing == 0.)
        add(pads, "the layer is continuous, Pad spacing = 0");
      if (!foundation.has_sleepers())
        add(ballast, "there are no sleepers, Sleeper mass = 0");
      if (body.rigid || body.hub != Hub::mass)
        add({"Hub mass", "Hub inertia x", "Hub inertia y", "Hub inertia z"},
            "an elastic body with Hub = mass reads it");
    }



    /** Of the damping of a body, entries without a use, and why. */
    void
    add_idle_damping(const SceneParameters              &scene,
                     const BodyParameters               &body,
                     std::map<std::string, std::string> &idle)
    {
      const BodyDamping &damping = body.model.damping;
      const auto         add     = [&](const std::vector<std::string> &entries,
                           const std::string              &why) {
        for (const std::string &entry : entries)
          idle.emplace(body.section + '/' + entry, why);
      };
      const std::vector<std::string> all{"Loss factor",
                                         "Loss frequency",
                                         "Foundation loss factor",
                                         "Ballast loss factor",
                                         "Rayleigh mass",
                                         "Rayleigh stiffness",
                                         "Sponge length",
                                         "Sponge rate"};
      const bool                     has_modes = scene.is_of_structures() ||
                             scene.is_of_stability() ||
                             scene.has_reduced_bodies();
      const bool moves = has_modes || (scene.time.inertia &&
                                       (scene.analysis == "transient" ||
                                        (scene.analysis == "accuracy study" &&
                                         scene.study.varies_time_step)));
      if (body.rigid)
        add(all, "a rigid body has no damping");
      if (!moves)
        add(all,
            "only bodies with inertia are damped, Analysis = transient with "
            "Time/Inertia = true, and those of analyses of modes");
      if (!has_modes)
        add({"Modal damping"},
            "modes of a body have it, and this analysis finds none");
      if (scene.is_of_structures())
        add({"Loss frequency"},
            "in the frequency domain loss factors need none");
      if (damping.sponge_length == 0.)
        add({"Sponge rate"}, "there are no absorbing ends, Sponge length = 0");
      if (damping.loss_factor == 0. &&
          body.model.foundation.loss_factor == 0. &&
          body.model.foundation.ballast_loss_factor == 0.)
        add({"Loss frequency"}, "all loss factors are 0");
    }



    std::map<std::string, std::string>
    idle_body_entries(const SceneParameters &scene)
    {
      std::map<std::string, std::string> idle;
      for (const BodyParameters *body : {&scene.wheel, &scene.rail})
        {
          add_idle_supports(*body, scene.dimension, idle);
          add_idle_damping(scene, *body, idle);
        }
      return idle;
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
    for (const auto &[path, why] : idle_surface_entries(scene))
      check(path, why);
    for (const auto &[path, why] : idle_entries_of_the_end(scene))
      check(path, why);
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
