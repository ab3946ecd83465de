#ifndef rolling_contact_time_sound_pressure_h
#define rolling_contact_time_sound_pressure_h

#include <rolling_contact/time/modal_sound.h>

namespace RollingContact::Sound
{
  /**
   * Mean square of the sound pressure at a distance r from a source of the
   * power W that radiates alike in all directions over ground that reflects all
   * sound, rho c W / (2 pi r^2). Units: W, m; Pa^2.
   */
  double mean_square_pressure(const double power,
                              const Air   &air,
                              const double distance);

  /** Level of a sound power re 1 pW. Units: W, dB. */
  double power_level(const double power);

  /** Level of a mean square of sound pressure re 20 uPa. Units: Pa^2, dB. */
  double pressure_level(const double mean_square);

  /**
   * How many of @p n steps, at most a hundredth fewer, are most nearly a whole
   * number of samples at @p rate. Units: s, Hz.
   */
  std::size_t steps_of_whole_samples(const std::size_t  n,
                                     const double       time_step,
                                     const unsigned int rate);

  /**
   * Sound pressure over time of bodies whose sounds are of the same record of
   * so many steps: each line has the mean square of its power, so that levels
   * are those of the power in every band, and the phase of the sum of the
   * modes' signals, sigma acting without delay. As of a record that goes on
   * periodically; samples at @p rate, which is above twice the frequencies of
   * the lines. Units: s, m, Hz; Pa.
   */
  std::vector<double> pressure_over_time(const std::vector<BodySound> &sounds,
                                         const double                  duration,
                                         const Air                    &air,
                                         const double                  distance,
                                         const unsigned int            rate);

  /**
   * Makes @p n_samples of a sound that repeats itself after @p period samples,
   * no whole number of them: the periods of @p record before its last tenth,
   * from its second half, that are the closest to whole samples, again and
   * again. The record as it is if it has not twenty periods, or samples enough.
   */
  std::vector<double> repeated_periods(const std::vector<double> &record,
                                       const double               period,
                                       const std::size_t          n_samples);

} // namespace RollingContact::Sound

#endif
