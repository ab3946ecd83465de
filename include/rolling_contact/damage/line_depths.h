#ifndef rolling_contact_damage_line_depths_h
#define rolling_contact_damage_line_depths_h

#include <rolling_contact/damage/wear_laws.h>

#include <vector>

namespace RollingContact::Damage
{
  /**
   * The nodes of a line, and of each its length along the line (area over width
   * of the line). Units: m.
   */
  struct NodeLine
  {
    std::vector<RubbingNode> nodes;
    std::vector<double>      lengths;
  };

  /**
   * Worn depth h = sum g dx of the rail under a line for one passage of the
   * wheel, g the rate of the law (m/m) and dx the lengths of the nodes. Units:
   * m. Throws InputError unless each node has a length.
   */
  double depth_per_passage(const NodeLine         &line,
                           const WearLaw          &law,
                           const DamageParameters &parameters = {});

  /**
   * Worn depth of the wheel per metre rolled, h/(2 pi r), by that of the rail
   * per passage, h (m), and the rolling radius r (m): a point of the wheel
   * passes the contact once a revolution. Throws InputError unless r > 0.
   * Units: m/m.
   */
  double wheel_depth_per_metre(const double depth_per_passage,
                               const double rolling_radius);
} // namespace RollingContact::Damage

#endif
