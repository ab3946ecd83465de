#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/scene/entries.h>
#include <rolling_contact/scene/scene_parameters.h>
#include <rolling_contact/scene/sound_parameters.h>
#include <rolling_contact/scene/time_parameters.h>

#include <cmath>

namespace RollingContact
{
  void SoundParameters::declare(Entries &entries)
  {
    EntrySection &section =
      entries.section("Sound").read_by_analyses("transient and rolling noise");
    const Reader tells{asks<AnalysisTraits, SoundParameters>(
                         [](const auto &analysis, const auto &sound) {
                           return analysis.passes_waves || sound.estimate;
                         }),
                       "Sound/Estimate = false"},
      of_a_run{asks<AnalysisTraits>(
                 [](const auto &analysis) { return !analysis.passes_waves; }),
               "rolling noise has no steps in time"},
      estimates{asks<SoundParameters>(
                  [](const auto &sound) { return sound.estimate; }),
                "Sound/Estimate = false"},
      writes{asks<SoundParameters>(
               [](const auto &sound) { return sound.wav_file; }),
             "Sound/WAV file = false"};
    entries.add("Estimate", estimate).read_by(of_a_run).help =
      "Whether a transient run of bodies by their modes (Time/Bodies = "
      "reduced, Dimension = 3) ends with an estimate of the sound that wheel "
      "and rail radiate. It keeps the velocities of all modes up to "
      "Modes/Maximum frequency at each step, in modal_velocities.csv.";
    section.free_on_resume = in_all_scenes;
    entries.add("Density of air", air_density, "kg/m^3")
      .at_least(0.)
      .read_by(tells)
      .help = "Density of the surrounding air.";
    entries.add("Speed of sound", speed_of_sound, "m/s")
      .at_least(0.)
      .read_by(tells)
      .help = "Speed of sound in the surrounding air.";
    entries.add("Distance", distance, "m").at_least(0.).read_by(tells).help =
      "Distance from the contact at which the sound pressure is given. The "
      "ground reflects all sound, and the sound is the same in all directions.";
    entries.add("Skipped time", skipped_time, "s")
      .at_least(0.)
      .read_by(of_a_run)
      .read_by(estimates)
      .help =
      "Time at the beginning of the run that the sound leaves out, so that "
      "the start has faded.";
    entries.add("WAV file", wav_file)
      .read_by(of_a_run)
      .read_by(estimates)
      .help =
      "Whether the sound pressure at `Distance` is written as a file to "
      "listen to, pressure.wav: 24 bit, one channel.";
    entries.add("Sampling rate", sampling_rate, "Hz")
      .between(1000, 384000)
      .read_by(of_a_run)
      .read_by(estimates)
      .read_by(writes)
      .help = "Sampling rate of the WAV file.";
    entries.add("Full scale pressure", full_scale_pressure, "Pa")
      .read_by(of_a_run)
      .read_by(estimates)
      .read_by(writes)
      .help =
      "Sound pressure of the largest number in the WAV file. Give it to "
      "compare files of several runs. Empty: the next of 1, 2, 5, 10, ... "
      "above the highest pressure. The summary, results.csv and a comment in "
      "the file state it.";
  }

  namespace
  {
    void require_positive(const std::string &entry,
                          const double       value,
                          const std::string &advice)
    {
      if (!(value > 0.))
        throw InputError("Sound/" + entry + " = " + text_of(value) +
                         ": it must be above 0; " + advice);
    }
  } // namespace

  void SoundParameters::check_air() const
  {
    require_positive("Density of air",
                     air_density,
                     "1.2 kg/m^3 at 20 degrees.");
    require_positive("Speed of sound",
                     speed_of_sound,
                     "343 m/s at 20 degrees.");
    require_positive("Distance", distance, "7.5 m is usual.");
  }

  void SoundParameters::check(const TimeSteps &steps,
                              const double     maximum_frequency) const
  {
    check_air();
    if (full_scale_pressure)
      require_positive("Full scale pressure",
                       *full_scale_pressure,
                       "leave it empty to have it chosen.");
    const std::string highest =
      "Modes/Maximum frequency = " + text_of(maximum_frequency) + " Hz";
    if (wav_file && sampling_rate < 2 * maximum_frequency)
      throw InputError(
        "Sound/Sampling rate = " + std::to_string(sampling_rate) +
        " Hz: " + highest + " needs at least twice as much; 44100 is usual.");
    if (steps.length * 2 * maximum_frequency > 1.)
      throw InputError("Sound/Estimate = true: " + highest +
                       " needs steps of at most half a period, " +
                       significant(0.5 / maximum_frequency, 3) +
                       " s, and they have " + significant(steps.length, 3) +
                       " s; take a shorter Time/Time step.");
    const double length = steps.length * steps.number;
    if (skipped_time > length ||
        skipped_rows(steps.length) + least_rows > steps.number)
      throw InputError(
        "Sound/Skipped time = " + text_of(skipped_time) + " s: the run lasts " +
        significant(length, 6) + " s, " + std::to_string(steps.number) +
        " steps, and a sound needs at least " + std::to_string(least_rows) +
        " behind what is skipped; skip less or take a longer "
        "run.");
  }

  std::size_t SoundParameters::skipped_rows(const double time_step) const
  {
    return std::llround(skipped_time / time_step);
  }
} // namespace RollingContact
