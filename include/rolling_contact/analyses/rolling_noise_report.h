#ifndef rolling_contact_analyses_rolling_noise_report_h
#define rolling_contact_analyses_rolling_noise_report_h

#include <Eigen/Core>

#include <rolling_contact/run/run_context.h>
#include <rolling_contact/scene/sound_parameters.h>

#include <optional>
#include <vector>

namespace RollingContact
{
  /**
   * Sound powers (W; weighted_: with A) and mean squares of the normal load
   * (N^2; load_of_one: without the contact filter) of a band, or of all, at one
   * speed.
   */
  struct NoisePowers
  {
    enum Value
    {
      wheel,
      rail,
      load,
      load_of_one,
      weighted_wheel,
      weighted_rail,
      n_values
    };

    double operator[](const Value value) const
    {
      return values[value];
    }

    double total() const
    {
      return values[wheel] + values[rail];
    }

    double weighted() const
    {
      return values[weighted_wheel] + values[weighted_rail];
    }

    Eigen::Array<double, n_values, 1> values =
      Eigen::Array<double, n_values, 1>::Zero();
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

    /** Difference of the A-weighted levels of the loudest and the quietest
     * place between the sleepers, dB. */
    std::optional<double> range;

    NoisePowers sum() const;
  };

  /** Powers in the mean over places at the same speed, and the largest of their
   * uncertainties; one that is not known at a place is not known. */
  NoiseOfSpeed mean_of_places(const std::vector<NoiseOfSpeed> &places);

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
