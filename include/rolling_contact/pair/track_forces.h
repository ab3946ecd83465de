#ifndef rolling_contact_pair_track_forces_h
#define rolling_contact_pair_track_forces_h

#include <rolling_contact/contact/contact_problem.h>
#include <rolling_contact/scene/pair_spec.h>

namespace RollingContact
{
  /**
   * The forces of the contact on a wheel in the axes of the track: forwards, to
   * the right and down, moments about the middle of the track at the top of the
   * rails, right-handed, and the torque about the axle. Tangential forces T of
   * the nodes do the work of their resultants on the motion u of the wheelset,
   *
   *   - sum T . slip = - (force_x u0 + force_y u1 + moment_z u2
   *                       + axle_torque u3),
   *
   * in a steady state, u1 = 0, as creep_work of Resultants. Pressure has a part
   * in all but the axle's torque: the wheel is a surface of revolution about
   * that. In a curve the normals of the rail turn with it, so that pressure
   * ahead of the middle of the wheelset has a part along the track. The middle
   * of the pressure is at pressure_y to the right of the middle of the track;
   * its resultant is inclined as a surface that falls to the right by
   * pressure_angle. Units: N, N m, m, rad.
   */
  struct TrackForces
  {
    double force_x = 0., force_y = 0., force_z = 0.;
    double moment_x = 0., moment_z = 0.;
    double axle_torque = 0.;
    double pressure_y = 0., pressure_angle = 0.;
  };

  /**
   * The forces of a state of bodies with profiles.
   */
  TrackForces track_forces(const PairSpec       &scene,
                           const ContactProblem &problem,
                           const ContactState   &state);
} // namespace RollingContact

#endif
