#ifndef rolling_contact_surfaces_roughness_h
#define rolling_contact_surfaces_roughness_h

#include <rolling_contact/surfaces/height_expression.h>

namespace RollingContact
{
  /**
   * What the entry `Contact/Roughness` adds to the gap between the smooth
   * profiles: an expression in x and y (m) for muParser, or nothing. It stays
   * in the frame of the contact, as the profiles do. Units: m.
   */
  class Roughness : public HeightExpression
  {
  public:
    /**
     * Throws InputError naming the entry, its text and what is allowed.
     */
    explicit Roughness(const std::string &text)
      : HeightExpression("Contact/Roughness", text, ", or leave it empty.")
    {}
  };
} // namespace RollingContact

#endif
