#include <rolling_contact/analyses/rolling_noise_parameters.h>
#include <rolling_contact/analyses/roughness_bands.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>

#include <cmath>

namespace RollingContact
{
  namespace
  {
    const double lowest_frequency = 20.; ///< Hz
  }                                      // namespace

  Roughness roughness_of(const Situation &scene)
  {
    const auto &section = scene.inputs->own<RollingNoiseParameters>();
    Roughness   result;
    for (const auto &[entry, text] :
         {std::pair("Rolling noise/Rail roughness", section.rail_roughness),
          std::pair("Rolling noise/Wheel roughness", section.wheel_roughness)})
      if (!text.empty())
        result.add(roughness_levels(entry, text, scene.inputs->prm_folder));
    return result;
  }

  std::vector<Signals::ThirdOctave> bands_of_waves(const Roughness &roughness,
                                                   const double     speed,
                                                   const double     highest)
  {
    const double                      rounding = 1 + 1e-9;
    std::vector<Signals::ThirdOctave> bands;
    Signals::ThirdOctave              band;
    for (int k = std::round(10 * std::log10(lowest_frequency));; ++k)
      {
        band.centre = std::pow(10., k / 10.);
        if (band.upper_edge() > highest * rounding)
          return bands;
        if (speed / band.upper_edge() * rounding >= roughness.shortest &&
            speed / band.lower_edge() <= roughness.longest * rounding)
          bands.push_back(band);
      }
  }

  void require_bands(const Situation           &scene,
                     const Roughness           &roughness,
                     const std::vector<double> &speeds)
  {
    const double highest = scene.inputs->modes.maximum_frequency;
    for (const double speed : speeds)
      if (bands_of_waves(roughness, speed, highest).empty())
        throw InputError(
          "Rolling noise: no third octave up to Modes/Maximum frequency = " +
          text_of(highest) + " Hz has waves of " +
          significant(1e3 * roughness.shortest, 3) + " to " +
          significant(1e3 * roughness.longest, 3) + " mm at " +
          significant(speed, 3) +
          " m/s; take another speed, more Mesh/Elements across patch, or "
          "roughness of other waves.");
  }
} // namespace RollingContact
