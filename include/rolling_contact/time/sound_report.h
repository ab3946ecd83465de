#ifndef rolling_contact_time_sound_report_h
#define rolling_contact_time_sound_report_h

#include <rolling_contact/modes/mode_character.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/time/modal_sound.h>

namespace RollingContact
{
  struct RunContext;

  /**
   * A body of a run by its sound: what radiates, what its modes look like, and
   * the sound of the run.
   */
  struct SoundingBody
  {
    Side                       side = Side::wheel;
    Sound::RadiatingBody       radiating;
    std::vector<ModeCharacter> characters;
    Sound::BodySound           sound;
  };

  /**
   * The air of section Sound.
   */
  Sound::Air air_of(const SoundParameters &parameters);

  /**
   * Frequencies that the sound of a scene is told for: from 20 Hz to
   * Modes/Maximum frequency.
   */
  Sound::AudibleRange audible_range(const Situation &scene);

  /**
   * What the sound of a run becomes, of a record of @p duration and, unless it
   * is 0, of a motion with this @p period, which pressure.wav repeats for three
   * seconds: sound.csv,
   * sound_modes.csv, sound.svg with Output/Plot, pressure.wav with Sound/WAV
   * file, columns of the row of results.csv that is not ended yet, and a
   * finding. Only for one rank. Units: s.
   */
  void report_sound(const Situation                 &scene,
                    const std::vector<SoundingBody> &bodies,
                    const double                     duration,
                    const double                     period,
                    RunContext                      &context);
} // namespace RollingContact

#endif
