#ifndef rolling_contact_contact_contact_problem_h
#define rolling_contact_contact_contact_problem_h

#include <rolling_contact/base/asked_forces.h>
#include <rolling_contact/base/creepages.h>
#include <rolling_contact/contact/contact_operators.h>
#include <rolling_contact/contact/contact_state.h>
#include <rolling_contact/contact/friction_law.h>

#include <memory>
#include <optional>
#include <vector>

namespace RollingContact
{
  /**
   * A load at an @p angle about x to the normal of the plane in which the
   * resultants N and T_y are given, which pressure and friction share: load = N
   * cos(angle) - T_y sin(angle). Units: N, rad.
   */
  struct InclinedLoad
  {
    double load;
    double angle;
  };

  /**
   * The creepages to begin a search with: those that were found last where a
   * force is asked for, those that are given elsewhere.
   */
  inline Creepages start_of_search(const AskedForces &asked,
                                   const Creepages   &found,
                                   const Creepages   &given)
  {
    return {asked.x ? found.x : given.x,
            asked.y ? found.y : given.y,
            asked.moment ? found.spin : given.spin};
  }

  /**
   * The part of the loads that each time step sets anew: slip, dissipation and
   * invariants of its state follow from it.
   */
  struct StepLoads
  {
    std::vector<double> gap; ///< undeformed, m
    Creepages           creepages;
    double              speed = 0.; ///< |V| for the friction law, m/s

    NodalField free_slip;         ///< besides the rigid slip; empty for zero
    NodalField free_displacement; ///< of convection; empty for zero, m

    /** Where friction answers the slip within a time step: the share of that
     * at the end, and what the slip at the start adds to it. Empty where it
     * answers the slip at the end. */
    std::vector<double> slip_share;
    NodalField          slip_before;

    /** mu of the points that arrive at the nodes, and how far they have come,
     * m. See FrictionMemory. */
    std::vector<double> friction_arriving;
    double              step_path = 0.;

    /** For Boost.Serialization. A member not listed here does not compile. */
    template <typename Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      auto &[gap,
             creepages,
             speed,
             free_slip,
             free_displacement,
             slip_share,
             slip_before,
             friction_arriving,
             step_path] = *this;
      archive &gap &creepages.x &creepages.y &creepages.spin &speed;
      archive &free_slip &free_displacement &slip_share      &slip_before;
      archive &friction_arriving                             &step_path;
    }
  };

  /**
   * What presses and drags the bodies: gap, load or approach, creepages,
   * friction, and the motion of a time step that needs no reactions. May be
   * changed at any time.
   */
  struct ContactLoads : StepLoads
  {
    /** N, as ContactOperators::load(); the approach is unknown then. */
    std::optional<double> normal_load;
    double                approach = 0.; ///< m
    /** The normal load is what this asks for, found anew with each state. */
    std::optional<InclinedLoad> inclined_load;

    /** What the creepages are found for, anew with each state. */
    AskedForces forces;
    /** Rigid slip of profiles beyond that of the creepages, as where a radius
     * does not change in proportion to y. Empty for zero. */
    NodalField slip_of_profile;

    std::vector<double>
      friction; ///< mu of each node, mu_s if it depends on |s|
    std::shared_ptr<const FrictionLaw> friction_law; ///< none: mu is constant
    /** Sliding distance over which mu comes to that of the law, m; 0 for none.
     * See FrictionMemory. */
    double memory_length = 0.;
  };

  /**
   * Everything the contact laws need, on N paired nodes and with the bodies
   * reduced to their compliance. Knows no mesh and no solver.
   *
   * Pressure p >= 0 and traction q act on the wheel, -p and -q on the rail:
   *   u_n = gap - share approach + W_nn H p + W_nt H q                (m)
   *   w   = W_tt H q + W_tn H p                                      (m)
   *   s   = rigid_slip + free_slip
   *         + flow B1 (free_displacement + convection w) + rate w    (1)
   *   p = Proj_{>=0}(p - rho_n u_n),  q = Proj_{|.| <= mu p}(q - rho_t s)
   * eqs. (8) and (12) of Lai et al. 2017; the share is 1 in a plane, see
   * SurfaceFrames. For convection and rate see
   * TimeScaling; what a time step does without reactions is in gap, free_slip
   * and free_displacement. With a friction law mu falls with the sliding speed
   * |s| |V|, s the slip that the traction answers, and p, q, s and mu hold at
   * once.
   */
  struct ContactProblem
  {
    ContactOperators operators;
    ContactLoads     loads;

    unsigned int n_nodes() const
    {
      return operators.n_nodes();
    }

    unsigned int n_tangential() const
    {
      return operators.n_tangential();
    }

    /**
     * The rigid slip at the nodes. Units: 1.
     */
    NodalField rigid_slip() const;
  };

  /**
   * The rigid slip of creepages at the nodes, in the directions of their
   * tractions: the work of these is that of their resultants on the creepages.
   * Units: 1.
   */
  NodalField rigid_slip(const ContactOperators &operators,
                        const Creepages        &creepages);

  /**
   * A state without pressure and traction.
   */
  ContactState open_state(const ContactProblem &problem);

  /**
   * Make @p state one that solvers can start from: no pressure or traction
   * where it has none yet, the given approach unless the load is given.
   */
  void complete(const ContactProblem &problem, ContactState &state);

  /**
   * H q and H p of a state, (T + 1) N values with the tangential components
   * first, as W and the bodies take them. Units: N.
   */
  std::vector<double> nodal_forces(const ContactProblem &contact,
                                   const ContactState   &state);

  /**
   * Force on the wheel at a node. Units: N.
   */
  struct NodalForce
  {
    double x = 0., y = 0., z = 0.;
  };

  /**
   * The nodal_forces() of a state in the axes of the plane of resultants, see
   * SurfaceFrames. Units: N.
   */
  std::vector<NodalForce> forces_in_plane(const ContactProblem      &contact,
                                          const std::vector<double> &forces);

  /**
   * The gap u_n of a state at the nodes. Units: m.
   */
  std::vector<double> normal_gap(const ContactProblem &contact,
                                 const ContactState   &state);
} // namespace RollingContact

#endif
