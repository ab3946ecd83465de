#ifndef rolling_contact_contact_resultants_h
#define rolling_contact_contact_resultants_h

#include <rolling_contact/contact/tangential_problem.h>

#include <array>

namespace RollingContact
{
  enum class NodeState
  {
    open  = 0,
    slip  = 1,
    stick = 2
  };

  /**
   * States of the nodes: open where p = 0, slip where |q| has reached mu p,
   * stick else.
   */
  std::vector<NodeState> node_states(const TangentialProblem &tangential,
                                     const ContactState      &state);

  /**
   * Integrals and sizes of a state; forces are those on the wheel, moments
   * about the origin of the contact plane, both in its axes: where the surface
   * of contact is curved (SurfaceFrames), pressure has a part in all but
   * force_x. Units: N, N m, Pa, m^2, m.
   */
  struct Resultants
  {
    double       normal_force = 0.;
    double       force_x = 0., force_y = 0., spin_moment = 0.;
    double       friction_force   = 0.; ///< integral of mu p, mu_s if it falls
    double       tangential_force = 0.; ///< |T|, of friction alone
    double       traction_coefficient = 0.; ///< that over the sum of pressure
    double       max_pressure         = 0.;
    unsigned int n_touching           = 0;

    double centre_x = 0., centre_y = 0.;       ///< of the pressure
    double edge_begin_x = 0., edge_end_x = 0.; ///< of the patch
    double half_width_x = 0., half_width_y = 0.;

    double creep_work  = 0.; ///< T . rigid slip, J per m rolled
    double dissipation = 0.; ///< see dissipation(), J per m rolled

    /**
     * Energy error, |creep work - dissipation| over the larger of them; 0 at
     * rest.
     */
    double energy_error() const;
  };

  Resultants resultants(const ContactProblem &problem,
                        const ContactState   &state);

  /**
   * Forces along x and y and moment about the origin of nodal_forces(), as
   * Resultants has them. Units: N, N, N m.
   */
  std::array<double, 3> plane_resultant(const ContactProblem      &problem,
                                        const std::vector<double> &forces);

  /**
   * What sliding turns into heat over a rolled distance, -A q . s, A the areas
   * of the nodes and s the slip in the mean around each
   * (TangentialProblem::mean_slip). Units: J/m.
   */
  double dissipation(const TangentialProblem &tangential,
                     const ContactState      &state);

  /**
   * -A q . s with the areas A of the nodes, a traction and a slip: power of
   * friction over the speed that the slip is measured by. Units: Pa m^2.
   */
  double dissipation(const ContactOperators &operators,
                     const NodalField       &traction,
                     const NodalField       &slip);

  /**
   * The nodes that touch and whose surroundings are not all on the trace: where
   * there are any, the candidate zone is too small for the patch.
   */
  std::vector<unsigned int>
  nodes_at_border(const std::vector<bool>   &border,
                  const ContactProblem      &problem,
                  const std::vector<double> &pressure);

  /** True if there are nodes_at_border(). */
  bool reaches_border(const std::vector<bool>   &border,
                      const ContactProblem      &problem,
                      const std::vector<double> &pressure);
} // namespace RollingContact

#endif
