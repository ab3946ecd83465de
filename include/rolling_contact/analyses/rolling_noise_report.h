#ifndef rolling_contact_analyses_rolling_noise_report_h
#define rolling_contact_analyses_rolling_noise_report_h

#include <rolling_contact/run/run_context.h>
#include <rolling_contact/scene/sound_parameters.h>

#include <optional>
#include <vector>

namespace RollingContact
{
  /**
   * Mean squares and sound powers of a band, or of all, at one speed.
   */
  struct NoisePowers
  {
    double wheel = 0., rail = 0.;                   ///< W
    double weighted_wheel = 0., weighted_rail = 0.; ///< with A, W
    double load        = 0.; ///< mean square of the normal load, N^2
    double load_of_one = 0.; ///< the same without the contact filter, N^2

    double total() const
    {
      return wheel + rail;
    }

    double weighted() const
    {
      return weighted_wheel + weighted_rail;
    }

    NoisePowers &operator+=(const NoisePowers &other);
  };

  /** A third octave of rolling at a speed. */
  struct NoiseBand
  {
    double      centre    = 0.; ///< Hz
    double      roughness = 0.; ///< mean square of both surfaces, m^2
    NoisePowers powers;
  };

  /** Rolling at a speed. */
  struct NoiseOfSpeed
  {
    double                 speed = 0.; ///< m/s
    std::vector<NoiseBand> bands;

    /** How far the level may be off by the elements of the patch, dB. */
    std::optional<double> uncertainty;

    NoisePowers sum() const;
  };

  /** 10 lg(W / 1 pW). Units: W, dB. */
  double power_level(const double power);

  /** dB per decade of speed of the A-weighted power, by least squares; none of
   * one speed. */
  std::optional<double> slope_of(const std::vector<NoiseOfSpeed> &speeds);

  /** rolling_noise.csv, rolling_noise_speeds.csv, the table on the screen, the
   * finding and, if it is wanted, rolling_noise.svg. */
  void report_noise(const std::vector<NoiseOfSpeed> &speeds,
                    const SoundParameters           &sound,
                    const bool                       picture,
                    RunContext                      &context);
} // namespace RollingContact

#endif
