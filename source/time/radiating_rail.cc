#include <rolling_contact/base/constants.h>
#include <rolling_contact/modes/section_outline.h>
#include <rolling_contact/time/radiating_rail.h>
#include <rolling_contact/time/radiating_surface.h>

#include <cmath>

namespace RollingContact::Sound
{
  namespace
  {
    /// of a third octave
    const int samples_of_band = 24;
  } // namespace

  RadiatingRail::RadiatingRail(const VibratingBody<3> &rail,
                               const Air              &surroundings,
                               const double            added)
    : waves(*rail.waves)
    , air(surroundings)
    , added_damping(added)
    , efficiencies(efficiencies_of_beam(rail, air))
  {
    const auto         shape = rail.parameters.body_shape()->extruded_section();
    const auto         directions = shape->placement.directions();
    const Waveguide   &guide      = waves.waveguide();
    const Eigen::Index n = guide.size().n_along + guide.size().n_across;
    forms.assign(2, ComplexMatrix::Zero(n, n));
    for (const OutlinePoint &at : outline_of(shape->section))
      {
        const ComplexMatrix &motion =
          guide.motion_at(shape->placement.to_body(0., at.point));
        for (const unsigned int c : {1, 2})
          {
            const double normal =
              directions[c][0] * at.normal[0] + directions[c][1] * at.normal[1];
            forms[c - 1] += normal * normal * at.length *
                            motion.row(c).adjoint() * motion.row(c);
          }
      }
  }

  const ComplexMatrix &RadiatingRail::at_sample(const int sample)
  {
    const auto [place, is_new] = known.try_emplace(sample);
    if (is_new)
      {
        const double f = std::pow(10., 0.1 * sample / samples_of_band),
                     w = 2 * pi * f;
        const auto all = waves.integrals({0., w}, forms, added_damping);
        place->second =
          air.density * air.speed * w * w *
          (efficiencies[0](f) * all[0] + efficiencies[1](f) * all[1]);
      }
    return place->second;
  }

  ComplexMatrix RadiatingRail::power_form(const double frequency)
  {
    const double at     = 10 * samples_of_band * std::log10(frequency);
    const int    before = std::floor(at);
    const double share  = at - before;
    return (1 - share) * at_sample(before) + share * at_sample(before + 1);
  }
} // namespace RollingContact::Sound
