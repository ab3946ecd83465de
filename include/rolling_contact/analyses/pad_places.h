#ifndef rolling_contact_analyses_pad_places_h
#define rolling_contact_analyses_pad_places_h

#include <rolling_contact/scene/situation.h>
#include <rolling_contact/scene/table_parameters.h>

#include <optional>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * Places of the contact in a bay between sleepers, which an analysis goes
   * through: entry `Pad offsets` of its section.
   */
  struct PadPlaces
  {
    /** Throws InputError if the text is no list of numbers. Units: m. */
    PadPlaces(const std::string &section, const std::string &text);

    /** Throws InputError if there are places and the rail lies on no pads. */
    void check(const BodyParameters &rail) const;

    /** The scene at each place; the scene as it is if there are none. Throws
     * InputError if a place is not possible. */
    std::vector<Situation> situations(const Situation &scene) const;

    /** What the entry takes the place of. */
    std::vector<TableAxis> axes() const;

    const std::string   entry, text;
    std::vector<double> offsets; ///< of a pad from the contact, m
  };

  /** The place of a scene whose rail lies on pads; none of others. Units: m. */
  std::optional<double> pad_offset_of(const PairSpec &scene);
} // namespace RollingContact

#endif
