#ifndef rolling_contact_vibration_reduced_motion_h
#define rolling_contact_vibration_reduced_motion_h

#include <rolling_contact/bodies/theta_scheme.h>
#include <rolling_contact/pair/pair_motion.h>
#include <rolling_contact/stability/reduced_pair.h>

#include <vector>

namespace RollingContact
{
  /**
   * Wheel and rail by their modes and a massless residual compliance, in time
   * by the implicit midpoint rule. With v = eta' and m = n + 1/2 the middle of
   * a step h,
   *
   *   v_m   = v_n + h/2 (load + g a_m + Phi^T f_m - C_m v_m - K_m eta_m),
   *   eta_m = eta_n + h/2 v_m,    eta_(n+1) = eta_n + h v_m,
   *   u_m   = Phi eta_m + W_res g_m,      u'_m = Phi v_m + W_res g'_m,
   *   g'_m  = (3/2 g_m - 2 g_(m-1) + 1/2 g_(m-2)) / h,     g_m + tau g'_m =
   * f_m,
   *
   * where a_m is the acceleration of the hub that the wheel moves with and g
   * what it loads the modes by. The nodes have no mass, so that none of them
   * bounces, and forces and laws of contact belong to the middle of the step.
   * All is of second order in h;
   * without damping the modes keep their energy but for the work of the forces,
   * and the rate by BDF2 takes some at the scale of the step alone.
   *
   * The contact laws take one matrix, with which u_m = free + W f and u'_m =
   * free + 3/2 W f / h,
   *
   *   W = W_res / (1 + 3/2 tau / h) + h^2/3 sym(G),
   *   G = Phi (1 + h/2 C_m + h^2/4 K_m)^-1 Phi^T.
   *
   * That gives the velocity exactly and the displacement but for h^2/12 G f,
   * for which, and for the skew part of G, the forces are extrapolated from the
   * steps before: an error of order h^4, and stable.
   */
  class ReducedMotion
  {
  public:
    /**
     * At rest and undeformed. Throws InputError as check() does.
     */
    explicit ReducedMotion(ReducedPair pair);

    /**
     * What the modes are loaded by when the wheel's hub accelerates towards the
     * rail, with which the displacements move: g = -Phi^T M e_z of all nodes of
     * the wheel, m values. What modes beyond the basis would take of it is left
     * out. Throws InputError if it is that of other bodies. Units: kg^(1/2).
     */
    void set_hub_inertia(std::vector<double> inertia);

    /**
     * Prepare steps of this length. Throws InputError unless it is above 0.
     * Units: s.
     */
    void set_time_step(const double h);

    /**
     * W of the step. Units: m/N.
     */
    const DenseMatrix &compliance() const
    {
      return W;
    }

    /** What forces add to the velocity, times h and over W f. */
    static constexpr double velocity_factor = 1.5;

    /**
     * Come to rest with the given amplitudes under nodal forces, and stay so
     * as long as these do: a load on the modes makes up for what K_m has beyond
     * the static stiffness. Units: m kg^(1/2), N.
     */
    void rest_at(const std::vector<double> &eta,
                 const std::vector<double> &forces);

    /**
     * The constant modal load that keeps the state of rest_at(). Units: m
     * kg^(1/2)/s^2.
     */
    const std::vector<double> &load_at_rest() const
    {
      return rest_load;
    }

    /**
     * Begin a step, in place of one that was begun and not ended. Unless
     * @p smooth forces may jump in it, so that those before tell nothing.
     * @p hub_acceleration is that in its middle. Units: m/s^2.
     */
    void begin_step(const bool   smooth           = true,
                    const double hub_acceleration = 0.);

    /**
     * u_m and u'_m at the nodes without forces. Units: m, m/s.
     */
    const std::vector<double> &free_displacement() const
    {
      return free_u;
    }

    const std::vector<double> &free_velocity() const
    {
      return free_v;
    }

    /**
     * Take the step with these nodal forces, and return the energies: strain
     * is that of the modes, eta^T K_m eta / 2, and of the residual compliance,
     * and damping has the work of the skew part of K_m as well. Units: N, J.
     */
    const StepEnergy &end_step(const std::vector<double> &forces);

    /**
     * Motion of wheel relative to rail at the middle of the last step. Units:
     * m/s.
     */
    const std::vector<double> &contact_velocity() const
    {
      return velocity;
    }

    /**
     * Kinetic and strain energy now, and what the last step did. Units: J.
     */
    const StepEnergy &energy() const
    {
      return step_energy;
    }

    const ReducedState &state() const
    {
      return now;
    }

    /**
     * Go on from a state. Throws InputError if it is that of other bodies.
     */
    void set_state(ReducedState state);

    const ReducedPair &bodies() const
    {
      return pair;
    }

    std::size_t memory_consumption() const;

  private:
    /** The weights of the two steps before in the rate of the forces. */
    struct Past
    {
      double before, earlier;
    };

    Past past(const bool smooth) const;

    /** What part of a force the residual compliance follows within a step. */
    double follows() const
    {
      return 1 / (1 + velocity_factor * pair.retardation / h);
    }

    /**
     * Energy stored in the residual compliance, in the measure that BDF2
     * conserves. Units: J.
     */
    double residual_energy() const;

    /** Kinetic and strain energy of the state. */
    void find_energy();

    const ReducedPair   pair;
    DenseMatrix         shapes;                      ///< Phi^T
    DenseMatrix         inverse, inverse_transposed; ///< of 1 + h/2 C + h^2/4 K
    DenseMatrix         W;
    double              h     = 0.;
    bool                begun = false, continues = true;
    ReducedState        now;
    std::vector<double> rest_load, hub_inertia;
    std::vector<double> load; ///< of the step that has begun
    std::vector<double> K_eta;
    std::vector<double> residual, residual_before; ///< W_res g, m
    std::vector<double> free_rate, free_u, free_v, velocity;
    StepEnergy          step_energy;
  };
} // namespace RollingContact

#endif
