#ifndef rolling_contact_mesh_wheel_web_h
#define rolling_contact_mesh_wheel_web_h

#include <rolling_contact/mesh/wheel_section_mesh.h>

#include <vector>

namespace RollingContact
{
  /**
   * A wheel's web with its fillets at one radius: the middle, across, and half
   * the thickness. Units: m.
   */
  struct WebSides
  {
    double middle, half;
  };

  /**
   * The web at the radius @p outwards, its middle line straight but for a @p
   * bow, bow sin^2 from rim to hub. Units: m.
   */
  WebSides wheel_web(const WheelMeasures &measures,
                     const double         bow,
                     const double         outwards);

  /**
   * Radii of the rows of cells from rim to hub, short enough for bending.
   * Units: m.
   */
  std::vector<double> radii_of_web(const WheelMeasures &measures);
} // namespace RollingContact

#endif
