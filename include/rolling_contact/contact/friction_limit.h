#ifndef rolling_contact_contact_friction_limit_h
#define rolling_contact_contact_friction_limit_h

#include <rolling_contact/contact/contact_problem.h>

namespace RollingContact
{
  /**
   * The largest factor on asked forces, forces of pressure in their directions
   * apart, that friction can carry under a pressure. Tractions within |q| <=
   * mu p have resultants F in a convex set whose support function is h(v) = sum
   * of A mu p |s(v)|, the power of full sliding with creepages v, so that the
   * factor is the least of h(v) over all v with F . v = 1; v has the components
   * whose forces are asked for. Infinite if these are zero. Units: 1.
   */
  double largest_share_of_forces(const ContactProblem      &problem,
                                 const std::vector<double> &pressure);

  /**
   * Resultants of pressure alone, which has some on a curved surface of contact
   * only: force along x, along y, moment. Units: N, N, N m.
   */
  std::array<double, 3>
  plane_resultant_of_pressure(const ContactProblem      &problem,
                              const std::vector<double> &pressure);

  /**
   * The components that are asked for: 0, 1, 2 for force along x, along y and
   * moment, and what they shall be, in that order. Units: N, N, N m.
   */
  std::vector<std::pair<unsigned int, double>>
  asked_components(const AskedForces &forces);

  /**
   * The resultants of full sliding with one creepage alone in its own
   * direction: mu N, mu N and the moment of pure spin. Units: N, N, N m.
   */
  double sliding_resultant(const ContactProblem      &problem,
                           const std::vector<double> &pressure,
                           const unsigned int         component);

  /**
   * Creepages with one component 1 (1/m) and the others 0.
   */
  Creepages unit_creepage(const unsigned int component);
} // namespace RollingContact

#endif
