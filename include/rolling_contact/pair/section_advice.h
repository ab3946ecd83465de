#ifndef rolling_contact_pair_section_advice_h
#define rolling_contact_pair_section_advice_h

#include <rolling_contact/scene/body_parameters.h>

#include <array>
#include <string>

namespace RollingContact
{
  /**
   * ", revolved in 96 cells about an axle 0.46 m behind the contact", for the
   * log; empty for a body without a section from a file.
   */
  std::string sweep_of(const BodyParameters &body);

  /**
   * The other number of Cells along that would need fewer cells at the patch, a
   * sentence for the log: where faces of the contact boundary, halved alike in
   * both directions, are much shorter for the interface's elements in one than
   * in the other. Empty for all other bodies. Sizes along x and y. Units: m.
   */
  std::string advice_on_cells_along(const BodyParameters        &body,
                                    const std::array<double, 2> &faces,
                                    const std::array<double, 2> &elements);
} // namespace RollingContact

#endif
