#ifndef rolling_contact_damage_line_depths_h
#define rolling_contact_damage_line_depths_h

#include <rolling_contact/damage/wear_laws.h>

#include <vector>

namespace RollingContact::Damage
{
  /**
   * A line along the rolling direction by its place y and its width across; the
   * width is half the distance of the neighbours. Units: m.
   */
  struct LinePlace
  {
    double y     = 0.;
    double width = 0.;
  };

  /**
   * The nodes of a line, and of each its length along the line (area over width
   * of the line). Units: m.
   */
  struct NodeLine
  {
    LinePlace                place;
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

  /**
   * Worn area sum h w of a section per passage, h the depths of the lines (m)
   * and w their widths. Units: m^2. Throws InputError unless each line has a
   * depth.
   */
  double worn_area(const std::vector<LinePlace> &lines,
                   const std::vector<double>    &depths);

  /**
   * Areas (m^2) that the points at the abscissae (m) of a profile get of the
   * @p areas of lines, depth times width. Each is spread by the hat function of
   * its line, one at the line and zero at its neighbours; outwards of the first
   * and the last line it reaches as far as the width says, twice that less the
   * distance of the neighbour within. A point gets the integral with its own
   * hat function, which beyond the first and the last point stays one: sums of
   * areas are kept to rounding and nothing is lost at the ends. Throws
   * InputError unless y and the abscissae rise, widths are positive, and
   * numbers of lines and areas are equal.
   */
  std::vector<double> deposit(const std::vector<LinePlace> &lines,
                              const std::vector<double>    &areas,
                              const std::vector<double>    &abscissae);
} // namespace RollingContact::Damage

#endif
