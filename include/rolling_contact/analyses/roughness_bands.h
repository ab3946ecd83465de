#ifndef rolling_contact_analyses_roughness_bands_h
#define rolling_contact_analyses_roughness_bands_h

#include <rolling_contact/algebra/third_octaves.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/surfaces/roughness_levels.h>

#include <vector>

namespace RollingContact
{
  /** All roughness that section Rolling noise names. Throws InputError. */
  Roughness roughness_of(const Situation &scene);

  /** The third octaves from 20 Hz to a frequency whose waves are known at a
   * speed. Units: m/s, Hz. */
  std::vector<Signals::ThirdOctave> bands_of_waves(const Roughness &roughness,
                                                   const double     speed,
                                                   const double     highest);

  /** Throws InputError if there is no third octave at one of these speeds. */
  void require_bands(const Situation           &scene,
                     const Roughness           &roughness,
                     const std::vector<double> &speeds);
} // namespace RollingContact

#endif
