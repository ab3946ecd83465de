#ifndef rolling_contact_analyses_impact_parameters_h
#define rolling_contact_analyses_impact_parameters_h

#include <string>
#include <vector>

namespace RollingContact
{
  class Entries;

  /**
   * Section `Impact`: how fast the wheel rolls over what is on the surfaces.
   */
  struct ImpactParameters
  {
    void declare(Entries &entries);

    /** Throws InputError unless speeds are above 0. */
    void check() const;

    /** Ascending; @p given if there are none. Throws InputError. Units: m/s. */
    std::vector<double> speeds_or(const double given) const;

    std::string speeds = "";
  };
} // namespace RollingContact

#endif
