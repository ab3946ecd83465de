#ifndef rolling_contact_contact_patches_h
#define rolling_contact_contact_patches_h

#include <rolling_contact/contact/tangential_problem.h>
#include <rolling_contact/contact/trace.h>

namespace RollingContact
{
  /**
   * A patch: touching nodes that hang together over the elements of the
   * interface. Forces are those on the wheel: along the normals and tangents of
   * the nodes, and in_plane their sum in the axes of the plane of resultants,
   * the same thing where the surface of contact is plane. Units: m, m^2, N, Pa,
   * J per m rolled.
   */
  struct ContactPatch
  {
    std::vector<unsigned int> nodes;
    double                    centre_x = 0., centre_y = 0.; ///< of pressure
    double                    area         = 0.;
    double                    normal_force = 0., force_x = 0., force_y = 0.;
    NodalForce                in_plane;
    double                    max_pressure = 0.;
    double                    dissipation  = 0.;
  };

  /**
   * All patches of a state, that with the largest normal force first.
   */
  std::vector<ContactPatch> contact_patches(const Trace          &trace,
                                            const ContactProblem &problem,
                                            const ContactState   &state);
} // namespace RollingContact

#endif
