#ifndef rolling_contact_wheelset_hunting_wheelset_h
#define rolling_contact_wheelset_hunting_wheelset_h

namespace RollingContact
{
  /**
   * What a wheelset is that hunts: mass, moments of inertia about the vertical
   * and about the axle, and springs and dashpots of the suspension that hold it
   * at its equilibrium, or to the frame of its bogie. Units: kg, kg m^2, N/m,
   * N s/m, N m s/rad.
   */
  struct HuntingWheelset
  {
    double mass = 0., yaw_inertia = 0., axle_inertia = 0.;
    double lateral_stiffness = 0., lateral_damping = 0., yaw_damping = 0.;
  };

  /**
   * The frame of a bogie: mass, moment of inertia about the vertical, springs
   * and dashpots between it and the car body. Units as above, and N m/rad.
   */
  struct HuntingFrame
  {
    double mass = 0., yaw_inertia = 0.;
    double yaw_stiffness = 0., yaw_damping = 0.;
    double lateral_stiffness = 0., lateral_damping = 0.;
  };
} // namespace RollingContact

#endif
