#ifndef rolling_contact_analyses_rolling_noise_parameters_h
#define rolling_contact_analyses_rolling_noise_parameters_h

#include <rolling_contact/analyses/pad_places.h>
#include <rolling_contact/surfaces/roughness_levels.h>

#include <optional>
#include <string>
#include <vector>

namespace RollingContact
{
  class Entries;

  /** What a contact feels of the roughness of the surfaces. */
  enum class ContactFilter
  {
    random_across, ///< of waves that are not alike across
    patch,         ///< of a wave that is
    table          ///< by directive_contact_filter()
  };

  /**
   * Section `Rolling noise`: how rough wheel and rail are, how the contact
   * filters it, and how fast the wheel rolls.
   */
  struct RollingNoiseParameters
  {
    void declare(Entries &entries);

    /** Throws InputError. */
    void check() const;

    /** Ascending; @p given if there are none. Throws InputError. Units: m/s. */
    std::vector<double> speeds_or(const double given) const;

    /** Throws InputError. */
    PadPlaces places() const
    {
      return {"Rolling noise", pad_offsets};
    }

    /** Coherence across of the waves; 0 of waves alike across. */
    double coherence_of_waves() const
    {
      return filter == ContactFilter::random_across ? coherence : 0.;
    }

    std::string   speeds          = "";
    std::string   rail_roughness  = iso_3095_limit;
    std::string   wheel_roughness = "";
    ContactFilter filter          = ContactFilter::random_across;
    double        coherence       = 1.;
    std::string   pad_offsets     = "";
  };
} // namespace RollingContact

#endif
