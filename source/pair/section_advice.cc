#include <rolling_contact/base/text.h>
#include <rolling_contact/pair/section_advice.h>

#include <cmath>

namespace RollingContact
{
  std::string sweep_of(const BodyParameters &body)
  {
    if (!body.is_section())
      return "";
    const std::string cells = std::to_string(body.cells_along) + " cells ";
    return body.radius > 0.
             ? ", revolved in " + cells + "about an axle " +
                 significant(body.radius, 4) + " m behind the contact"
             : ", extruded in " + cells + "over " +
                 significant(body.block_length, 4) + " m";
  }

  std::string advice_on_cells_along(const BodyParameters        &body,
                                    const std::array<double, 2> &faces,
                                    const std::array<double, 2> &elements)
  {
    const double worth_it = 2.2; // halving twice where once would do
    const double ratio    = (faces[0] / elements[0]) / (faces[1] / elements[1]);
    if (!body.is_section() || (ratio < worth_it && ratio > 1 / worth_it))
      return "";
    return " Its cells are not as long as they are wide: faces at the patch are " +
           millimetres(faces[0]) + " by " + millimetres(faces[1]) +
           ", the elements there " + millimetres(elements[0]) + " by " +
           millimetres(elements[1]) + "; about " + body.section +
           "/Cells along = " +
           std::to_string(std::lround(body.cells_along * ratio)) +
           " needs fewer cells at the patch.";
  }
} // namespace RollingContact
