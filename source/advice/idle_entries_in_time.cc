#include <rolling_contact/advice/idle_entries.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/scene/scene_parameters.h>

namespace RollingContact
{
  namespace
  {
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
      if (scene.analysis == "transient" && !scene.wants_spectra())
        for (const char *entry : {"Skipped time",
                                  "Segment length",
                                  "Highest frequency",
                                  "Line prominence",
                                  "Spectrogram",
                                  "Spectrogram signal",
                                  "Spectrogram window"})
          idle["Spectrum/" + std::string(entry)] =
            scene.spectrum.write == WriteSpectrum::never
              ? "Spectrum/Write = never"
              : "no surface moves, no vibration is excited and no points are "
                "named; take Spectrum/Write = always";
      else if (!scene.spectrum.spectrogram)
        for (const char *entry : {"Spectrogram signal", "Spectrogram window"})
          idle["Spectrum/" + std::string(entry)] =
            "Spectrum/Spectrogram = false";
      return idle;
    }



    /** Entries on sound that this scene has no use for, and why. */
    std::map<std::string, std::string>
    idle_sound_entries(const SceneParameters &scene)
    {
      std::map<std::string, std::string> idle;
      const SoundParameters             &sound = scene.sound;
      if (scene.analysis != "transient" || (sound.estimate && sound.wav_file))
        return idle;
      const auto add = [&](const std::string &entry) {
        idle["Sound/" + entry] =
          sound.estimate ? "Sound/WAV file = false" : "Sound/Estimate = false";
      };
      for (const char *entry : {"Sampling rate", "Full scale pressure"})
        add(entry);
      if (!sound.estimate)
        for (const char *entry : {"Density of air",
                                  "Speed of sound",
                                  "Distance",
                                  "Skipped time",
                                  "WAV file"})
          add(entry);
      return idle;
    }



    /** Entries of section Time on its end and its files without use, and why.
     */
    std::map<std::string, std::string>
    idle_entries_of_the_end(const SceneParameters &scene)
    {
      std::map<std::string, std::string> idle;
      if (scene.analysis == "limit cycle")
        for (const char *entry : {"Stop when periodic",
                                  "Field interval",
                                  "Checkpoint interval",
                                  "Checkpoint seconds"})
          idle["Time/" + std::string(entry)] =
            "Analysis = limit cycle always stops when the motion is periodic, "
            "and has a row for each run";
      if (scene.analysis == "transient" && !scene.looks_for_cycles())
        for (const char *entry : {"Periodic tolerance", "Periodic after"})
          idle["Time/" + std::string(entry)] =
            "Time/Stop when periodic = true reads it";
      return idle;
    }
  } // namespace



  std::map<std::string, std::string>
  idle_entries_in_time(const SceneParameters &scene)
  {
    std::map<std::string, std::string> idle = idle_surface_entries(scene);
    idle.merge(idle_sound_entries(scene));
    idle.merge(idle_entries_of_the_end(scene));
    return idle;
  }



  std::string
  missing_spectrum(const SceneParameters &scene)
  {
    const auto &[skipped, segment] =
      std::pair(scene.spectrum.skipped_time, scene.spectrum.segment_length);
    if (scene.analysis != "transient" || (skipped == 0. && segment == 0.) ||
        !scene.wants_spectra())
      return "";
    const std::string why = scene.spectrum.why_none(scene.time.steps(
      scene.time.histories(scene.contact, scene.prm_folder).speed));
    return why.empty() ? ""
                       : "There will be no spectra, Spectrum/Skipped time = " +
                           significant(skipped, 6) +
                           " s, Segment length = " + significant(segment, 6) +
                           " s: " + why;
  }
} // namespace RollingContact
