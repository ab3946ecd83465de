#ifndef rolling_contact_contact_roughness_h
#define rolling_contact_contact_roughness_h

#include <deal.II/base/function_parser.h>

#include <memory>
#include <string>

namespace RollingContact
{
  /**
   * What the entry `Contact/Roughness` adds to the gap between the smooth
   * profiles: an expression in x and y (m) for muParser, or nothing. It stays
   * in the frame of the contact, as the profiles do. Units: m.
   */
  class Roughness
  {
  public:
    /**
     * Throws InputError naming the entry, its text and what is allowed.
     */
    explicit Roughness(const std::string &text);

    /**
     * Throws InputError where it is not finite.
     */
    double
    value(const double x, const double y) const;

  private:
    std::string                                text;
    std::shared_ptr<dealii::FunctionParser<2>> expression; ///< or none
  };
} // namespace RollingContact

#endif
