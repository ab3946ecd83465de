#ifndef rolling_contact_stability_linear_contact_h
#define rolling_contact_stability_linear_contact_h

#include <rolling_contact/contact/contact_problem.h>
#include <rolling_contact/contact/friction_law.h>

#include <vector>

namespace RollingContact
{
  /**
   * What a state is linearised with besides itself.
   */
  struct LinearContactOptions
  {
    double           speed    = 0.; ///< |V|, m/s
    FrictionResponse friction = FrictionResponse::patch_mean;
    double           memory   = 60e-6; ///< tau of patch_mean, s

    /** How near to a change of state a node is counted as on the border:
     * relative to the largest pressure, and to the traction bound. */
    double border = 1e-4;
  };

  /**
   * A steady state of rolling, linearised: disturbances of motion u and its
   * rate u' at all N nodes, (T + 1) N values, and of the unknowns x of the
   * contact obey
   *
   *   N_u u + N_v u' + N_r x + N_s x' = 0,      nodal forces = forces x.
   *
   * x are the tractions of the n_a touching nodes by components, then their
   * pressures (Pa), and with FrictionResponse::patch_mean one number more. The
   * rows, as many, are the normal ones, then the tangential ones by components,
   * in m, Pa where nodes slip and m/s where they stick:
   *
   *   touching:    u_n = 0
   *   slip:        dq + mu t dp + D dv = 0,   t = v / |v|,
   *                D = p [mu / |v| (I - t t^T) + dmu/d|v| t t^T]
   *   stick:       dv = 0,      dv = |V| flow B1 u_t + B2 u_t',
   *
   * and at a leading edge dv has |V| times what the edge law takes of tractions
   * and pressures (slip_rows()), with the scheme of the state: so the edge of
   * a stick zone moves with the pressure. v is the sliding velocity of the
   * wheel over the rail. Open nodes carry nothing and take part in B1. With
   * patch_mean mu = mu_s m with one m for all nodes that follows the mean
   * sliding speed, weighted by the load A_i p_i of each node:
   *
   *   tau m' = 1 - drop(mean) - m,      mean = sum A_i p_i |v_i| / sum A_i p_i,
   *
   * so that p mu_s t dm is added to slip, and the last row is
   * dm + tau dm' + drop'(mean) d(mean) = 0,
   *
   *   d(mean) = sum A_i [p_i t_i . dv_i + (|v_i| - mean) dp_i] / sum A_i p_i,
   *
   * without dv of nodes that stick.
   */
  struct LinearContact
  {
    DenseMatrix N_u, N_v; ///< n_x x (T + 1) N
    DenseMatrix N_r, N_s; ///< n_x x n_x
    DenseMatrix forces;   ///< (T + 1) N x n_x, m^2: H of the touching nodes

    unsigned int              n_nodes      = 0; ///< N
    unsigned int              n_tangential = 0; ///< T
    std::vector<unsigned int> touching;         ///< nodes
    std::vector<bool>         slips;            ///< of the touching nodes

    /** Nodes where the state is about to change: there it has other
     * derivatives on either side, and these are those of one. */
    unsigned int n_opening  = 0; ///< pressure or gap nearly zero
    unsigned int n_slipping = 0; ///< stick with |q| nearly mu p
    unsigned int n_sticking = 0; ///< slip of almost no size

    unsigned int n_unknowns() const
    {
      return N_r.rows();
    }

    /** The first of the unknowns, tractions and pressures. */
    unsigned int n_tractions() const
    {
      return (n_tangential + 1) * touching.size();
    }

    unsigned int n_slip() const;

    /** The normal load by the unknowns, a row of n_x. Units: m^2. */
    Eigen::RowVectorXd normal_load() const
    {
      return forces.bottomRows(n_nodes).colwise().sum();
    }

    unsigned int n_border() const
    {
      return n_opening + n_slipping + n_sticking;
    }
  };

  /**
   * The linearised contact of a steady @p state that solves @p problem. Throws
   * InputError where the slip operator is Galerkin's, in a time step, without
   * speed, without touching nodes, with friction that remembers a sliding
   * distance, or with a memory of no duration.
   */
  LinearContact linear_contact(const ContactProblem       &problem,
                               const ContactState         &state,
                               const LinearContactOptions &options);
} // namespace RollingContact

#endif
