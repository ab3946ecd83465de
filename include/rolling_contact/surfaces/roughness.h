#ifndef rolling_contact_surfaces_roughness_h
#define rolling_contact_surfaces_roughness_h

#include <rolling_contact/surfaces/height_expression.h>
#include <rolling_contact/surfaces/surface_record.h>

namespace RollingContact
{
  /**
   * What the entry `Contact/Roughness` adds to the gap between the smooth
   * profiles: an expression in x and y (m) for muParser, or nothing, also
   * where it names a file. It stays in the frame of the contact, as the
   * profiles do. Units: m.
   */
  class Roughness : public HeightExpression
  {
  public:
    /**
     * Throws InputError naming the entry, its text and what is allowed.
     */
    explicit Roughness(const std::string &text)
      : HeightExpression("Contact/Roughness",
                         names_a_record(text) ? "" : text,
                         ", " + std::string(kinds_of_surface_files) +
                           ", or leave it empty.")
    {}
  };
} // namespace RollingContact

#endif
