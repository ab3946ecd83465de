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

    double centre_of(const int band)
    {
      return std::pow(10., band / 10.);
    }
  } // namespace

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

  std::vector<double> centres_of_bands(const Roughness &roughness,
                                       const double     speed,
                                       const double     highest)
  {
    const double        edge = std::pow(10., 0.05), rounding = 1 + 1e-9;
    std::vector<double> centres;
    for (int band = std::round(10 * std::log10(lowest_frequency));
         centre_of(band) < highest;
         ++band)
      {
        const double lower = centre_of(band) / edge,
                     upper = centre_of(band) * edge;
        if (upper <= highest * rounding &&
            speed / upper * rounding >= roughness.shortest &&
            speed / lower <= roughness.longest * rounding)
          centres.push_back(centre_of(band));
      }
    return centres;
  }

  void require_bands(const Situation           &scene,
                     const Roughness           &roughness,
                     const std::vector<double> &speeds)
  {
    const double highest = scene.inputs->modes.maximum_frequency;
    for (const double speed : speeds)
      if (centres_of_bands(roughness, speed, highest).empty())
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
