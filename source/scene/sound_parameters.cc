#include <deal.II/base/parameter_handler.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/input/prm_declarations.h>
#include <rolling_contact/scene/sound_parameters.h>
#include <rolling_contact/scene/time_parameters.h>

#include <cmath>

namespace RollingContact
{
  using namespace dealii;

  void
  SoundParameters::declare(ParameterHandler &prm)
  {
    const Patterns::Double not_negative(0.);
    prm.enter_subsection("Sound");
    prm.add_parameter(
      "Estimate",
      estimate,
      "Whether a transient run of bodies by their modes (Time/Bodies = "
      "reduced, Dimension = 3) ends with an estimate of the sound that wheel "
      "and rail radiate. It keeps the velocities of all modes up to "
      "Modes/Maximum frequency at each step, in modal_velocities.csv.");
    prm.add_parameter("Density of air",
                      air_density,
                      "Density of the air around. Units: kg/m^3.",
                      not_negative);
    prm.add_parameter("Speed of sound",
                      speed_of_sound,
                      "Speed of sound in the air around. Units: m/s.",
                      not_negative);
    prm.add_parameter(
      "Distance",
      distance,
      "Distance from the contact at which the sound pressure is told, over "
      "ground that reflects all sound and alike in all directions. Units: m.",
      not_negative);
    prm.add_parameter("Skipped time",
                      skipped_time,
                      "Beginning of the run that the sound leaves out: what is "
                      "left of the start. Units: s.",
                      not_negative);
    prm.add_parameter("WAV file",
                      wav_file,
                      "Whether the sound pressure at that distance is written "
                      "to be listened to, in pressure.wav: 24 bit, one "
                      "channel.");
    prm.add_parameter("Sampling rate",
                      sampling_rate,
                      "Sampling rate of the WAV file. Units: Hz.",
                      Patterns::Integer(1000, 384000));
    declare_number(
      prm,
      "Sound/Full scale pressure",
      full_scale_pressure,
      "Pa",
      "Sound pressure that the largest number of the WAV file stands for. Give "
      "it to compare files of several runs. Left empty: the next of 1, 2, 5, "
      "10, ... above the highest pressure. The summary, results.csv and a "
      "comment within the file say what it is. Units: Pa.");
    prm.leave_subsection();
  }



  namespace
  {
    void
    require_positive(const std::string &entry,
                     const double       value,
                     const std::string &advice)
    {
      if (!(value > 0.))
        throw InputError("Sound/" + entry + " = " + text_of(value) +
                         ": it must be above 0; " + advice);
    }
  } // namespace



  void
  SoundParameters::check(const TimeSteps &steps,
                         const double     maximum_frequency) const
  {
    require_positive("Density of air",
                     air_density,
                     "1.2 kg/m^3 at 20 degrees.");
    require_positive("Speed of sound",
                     speed_of_sound,
                     "343 m/s at 20 degrees.");
    require_positive("Distance", distance, "7.5 m is usual.");
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



  std::size_t
  SoundParameters::skipped_rows(const double time_step) const
  {
    return std::llround(skipped_time / time_step);
  }
} // namespace RollingContact
