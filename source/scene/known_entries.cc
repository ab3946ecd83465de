#include <rolling_contact/base/text.h>
#include <rolling_contact/scene/entries.h>
#include <rolling_contact/scene/known_entries.h>
#include <rolling_contact/scene/scene_parameters.h>

namespace RollingContact
{
  namespace
  {
    /** Entries that an axis or a sweep gives, and the entry of that. */
    std::map<std::string, std::string>
    entries_on_axes(const SceneParameters &scene)
    {
      std::map<std::string, std::string> given;
      for (const TableAxis &axis : scene.axes())
        given[axis.entry] = axis.name;
      return given;
    }

    /**
     * Why a run is too short for the spectra that are wanted of it, a sentence;
     * empty if it is not.
     */
    std::string missing_spectrum(const SceneParameters &scene)
    {
      const double skipped = scene.spectrum.skipped_time,
                   segment = scene.spectrum.segment_length;
      if (!scene.analysis.records_run || (skipped == 0. && segment == 0.) ||
          !scene.wants_spectra())
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
  } // namespace

  const Entries &known_entries()
  {
    static SceneParameters scene;
    static const Entries   entries = scene.declare({});
    return entries;
  }

  Renews renewed_by(const std::string &path)
  {
    for (const Entry &entry : known_entries().rows())
      if (entry.path() == path)
        return entry.renews;
    return Renews::loads;
  }

  std::vector<std::string> unused_entries(const SceneParameters &scene,
                                          const PrmEntries      &given)
  {
    SceneParameters          declared = scene;
    const Entries            known    = declared.declare({});
    std::vector<std::string> warnings;
    const auto warn = [&](const std::string &entries, const std::string &why) {
      warnings.push_back(entries + " has no effect: " + why + ".");
    };
    for (const EntrySection &section : known.sections())
      {
        std::string       entries;
        const std::string why = section.why_idle(scene);
        for (const auto &[path, value] : given)
          if (!why.empty() && path.find(section.name + '/') == 0)
            entries += (entries.empty() ? "" : ", ") + path + " = " + value;
        if (!entries.empty())
          warn(entries, why + ", not " + scene.analysis.name);
      }
    const auto on_axes = entries_on_axes(scene);
    for (const auto &[path, value] : given)
      {
        const Entry &entry = known.find(path);
        if (!entry.section->why_idle(scene).empty())
          continue;
        const std::string why  = entry.why_idle(scene);
        const auto        axis = on_axes.find(path);
        if (!why.empty())
          warn(path + " = " + value, why);
        else if (axis != on_axes.end())
          warn(path + " = " + value, axis->second + " gives it");
      }
    const std::string missing = missing_spectrum(scene);
    if (!missing.empty())
      warnings.push_back(missing);
    return warnings;
  }

  std::set<std::string> entries_free_on_resume(const SceneParameters &scene)
  {
    std::set<std::string> free;
    for (const Entry &entry : known_entries().rows())
      if (entry.free_on_resume && entry.free_on_resume(scene))
        free.insert(entry.path());
    return free;
  }
} // namespace RollingContact
