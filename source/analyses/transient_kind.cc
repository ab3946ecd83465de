#include <rolling_contact/analyses/transient.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/scene/known_entries.h>
#include <rolling_contact/scene/run_signals.h>

namespace RollingContact
{
  namespace
  {
    void check_points(const SceneParameters &scene)
    {
      const auto points = scene.velocity_points(Side::wheel),
                 others = scene.velocity_points(Side::rail);
      for (const VelocityPoint &other : others)
        for (const VelocityPoint &point : points)
          if (point.name == other.name)
            throw InputError("Wheel/Velocity points and Rail/Velocity points "
                             "both have a point " +
                             point.name +
                             "; each has a column of its own, give "
                             "them different names.");
      if (scene.body_solver == BodySolver::distributed &&
          !(points.empty() && others.empty()))
        throw InputError("Body solver = distributed: Velocity points of Wheel "
                         "and Rail need all nodes of a body on one rank; take "
                         "direct or automatic, or name no points.");
    }

    void check_spectra(const SceneParameters &scene, const TimeSteps &steps)
    {
      const SpectrumParameters &spectrum = scene.spectrum;
      if (spectrum.write == WriteSpectrum::always)
        if (const std::string why = spectrum.why_none(steps); !why.empty())
          throw InputError("Spectrum/Write = always, Skipped time = " +
                           text_of(spectrum.skipped_time) +
                           " s, Segment length = " +
                           text_of(spectrum.segment_length) + " s: " + why);
      if (!scene.wants_spectra() || !spectrum.spectrogram)
        return;
      spectrogram_signal(scene);
      const std::size_t window =
        spectrum.rows_in_window(steps.length, steps.number);
      if (spectrum.spectrogram_window > 0. &&
          (window < SpectrumParameters::least_rows || window > steps.number))
        throw InputError("Spectrum/Spectrogram window = " +
                         text_of(spectrum.spectrogram_window) + " s: it has " +
                         std::to_string(window) + " steps of " +
                         significant(steps.length, 4) +
                         " s; give from 32 to the " +
                         std::to_string(steps.number) + " steps of the run.");
    }

    void check_sound(const SceneParameters &scene, const TimeSteps &steps)
    {
      if (!scene.sound.estimate)
        return;
      const std::string why = "Sound/Estimate = true: ";
      if (!scene.has_reduced_bodies())
        throw InputError(why +
                         "sound is estimated from the modes of the bodies; "
                         "set Time/Bodies = reduced.");
      if (scene.dimension == 2)
        throw InputError(why +
                         "in plane strain (Dimension = 2) a wheel has no "
                         "axial motion, which radiates most; set Dimension "
                         "= 3.");
      scene.sound.check(steps, scene.modes.maximum_frequency);
    }

    void check_transient(const SceneParameters &scene)
    {
      const TimeSteps steps = scene.time.steps(
        scene.time.histories(scene.contact, scene.prm_folder).speed);
      check_points(scene);
      check_spectra(scene, steps);
      if (scene.time.stop_when_periodic)
        scene.time.check_cycles(steps, "Time/Stop when periodic = true: ");
      check_sound(scene, steps);
    }

    RunFolder::Resumption resumption(const Situation &scene)
    {
      return {entries_free_on_resume(*scene.inputs),
              checkpoint_name,
              {history_name,
               numbers_of(history_name),
               modal_velocities_name,
               numbers_of(modal_velocities_name)},
              [&](const std::filesystem::path &path) {
                check_resumable(scene, path);
              }};
    }
  } // namespace

  AnalysisKind transient_kind()
  {
    AnalysisKind kind =
      kind_of<Transient>("transient", "rolling in time, see section Time");
    kind.sections    = {"Time", "Spectrum", "Sound"};
    kind.marches     = true;
    kind.records_run = true;
    kind.resumption  = &resumption;
    kind.rules       = {&check_transient};
    return kind;
  }
} // namespace RollingContact
