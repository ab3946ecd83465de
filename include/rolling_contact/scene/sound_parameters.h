#ifndef rolling_contact_scene_sound_parameters_h
#define rolling_contact_scene_sound_parameters_h

#include <cstddef>
#include <optional>

namespace RollingContact
{
  class Entries;

  struct TimeSteps;

  /**
   * Section `Sound`: the sound that wheel and rail radiate in a transient run
   * of their modes.
   */
  struct SoundParameters
  {
    void declare(Entries &entries);

    /**
     * Rules for the sound of modes up to a frequency (Hz) over these steps.
     * Throws InputError.
     */
    void check(const TimeSteps &steps, const double maximum_frequency) const;

    /** Throws InputError unless air and distance are above 0. */
    void check_air() const;

    /**
     * Steps at the beginning that are left out. Units: s.
     */
    std::size_t skipped_rows(const double time_step) const;

    /** Fewest steps that a sound is estimated from. */
    static constexpr std::size_t least_rows = 64;

    bool         estimate       = false;
    double       air_density    = 1.2;  ///< kg/m^3
    double       speed_of_sound = 343.; ///< m/s
    double       distance       = 7.5;  ///< m
    double       skipped_time   = 0.;   ///< s
    bool         wav_file       = true;
    unsigned int sampling_rate  = 44100; ///< Hz
    /**
     * Pressure that is full scale in the WAV file; empty for the next of 1, 2,
     * 5, 10, ... above the largest. Units: Pa.
     */
    std::optional<double> full_scale_pressure;
  };
} // namespace RollingContact

#endif
