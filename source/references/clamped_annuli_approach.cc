#include <rolling_contact/references/clamped_annuli_approach.h>
#include <rolling_contact/references/contact_modulus.h>
#include <rolling_contact/references/line_contact_approach.h>

namespace RollingContact::References
{
  namespace
  {
    class AnnuliPair
    {
    public:
      AnnuliPair(const Annulus &first, const Annulus &second)
        : first(first)
        , second(second)
        , radius(relative_radius(first.rim_radius, second.rim_radius))
        , modulus(contact_modulus(first.young_modulus,
                                  first.poisson_ratio,
                                  second.young_modulus,
                                  second.poisson_ratio))
      {}

      HertzLine hertz(const double half_width) const
      {
        return hertz_line_of_half_width(half_width, radius, modulus);
      }

      double approach(const double half_width) const
      {
        return -hertz(half_width).load_per_length() *
               (first.radial_displacement(half_width) +
                second.radial_displacement(half_width));
      }

      const ClampedAnnulus first;
      const ClampedAnnulus second;
      const double         radius;
      const double         modulus;
    };
  } // namespace

  AnnuliContact approach_of_two_clamped_annuli(const Annulus &first,
                                               const Annulus &second,
                                               const double   load_per_length)
  {
    const AnnuliPair pair(first, second);
    const HertzLine  hertz =
      hertz_line(load_per_length, pair.radius, pair.modulus);
    return {hertz, hertz.half_width > 0 ? pair.approach(hertz.half_width) : 0};
  }

  double load_of_two_clamped_annuli(const Annulus &first,
                                    const Annulus &second,
                                    const double   approach)
  {
    const AnnuliPair pair(first, second);
    const double     half_width = half_width_of_approach(
      [&](const double trial) { return pair.approach(trial); },
      pair.radius,
      approach);
    return pair.hertz(half_width).load_per_length();
  }
} // namespace RollingContact::References
