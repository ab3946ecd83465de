#ifndef rolling_contact_time_radiating_surface_h
#define rolling_contact_time_radiating_surface_h

#include <rolling_contact/time/modal_sound.h>
#include <rolling_contact/vibration/vibrating_body.h>

namespace RollingContact::Sound
{
  /**
   * Radiation efficiencies of a body that moves along y, and along z, as a long
   * beam along x, see efficiency_of_cylinder(), by its area and its extent.
   */
  std::vector<std::function<double(double)>>
  efficiencies_of_beam(const VibratingBody<3> &body, const Air &air);

  /**
   * A body of a scene by the sound of its modes up to a frequency, those of its
   * first columns. A body with an axle radiates along it and away from it, each
   * number of nodal diameters by itself, see axial_efficiency_of_wheel() and
   * radial_efficiency_of_wheel(); another one along y and z as a long beam
   * along x, see efficiency_of_cylinder(). Throws InputError if modes about an
   * axle have no nodal diameters that could be counted. Units: Hz.
   */
  RadiatingBody radiating_body(const VibratingBody<3> &body,
                               const double            maximum_frequency,
                               const Air              &air);
} // namespace RollingContact::Sound

#endif
