#ifndef rolling_contact_stability_reduced_pair_h
#define rolling_contact_stability_reduced_pair_h

#include <rolling_contact/algebra/dense_matrix.h>
#include <rolling_contact/contact/surface_coupling.h>

#include <vector>

namespace RollingContact
{
  /**
   * Wheel and rail as the contact sees them: m modes of unit modal mass, of
   * both bodies together, and the static compliance of all that the modes leave
   * out (MacNeal's residual flexibility, a massless interface):
   *
   *   eta'' + C_m eta' + K_m eta = Phi^T f,      u = Phi eta + W_res g,
   *   g + tau g' = f,
   *
   * with the retardation time tau of the material under the contact; u the
   * motion of the wheel relative to the rail at the N nodes of contact, f
   * the nodal forces on the wheel, both (T + 1) N values in the order of
   * ContactOperators::W(), tangential components first, in the frame of the
   * pair. The columns of Phi that belong to the rail carry the minus sign of
   * the relative motion. Modes first of the wheel, then of the rail. What hangs
   * on a body counts among its modes, as coordinates of unit mass.
   */
  struct ReducedPair
  {
    DenseMatrix K_m; ///< m x m, 1/s^2
    DenseMatrix C_m; ///< m x m, 1/s
    /** Loss stiffness besides C_m, m x m, 1/s^2: i sgn(w) H_m joins K_m at a
     * rate s = i w, and nowhere else; empty where C_m stands for it. */
    DenseMatrix H_m;
    DenseMatrix Phi;   ///< (T + 1) N x m, 1/sqrt(kg)
    DenseMatrix W_res; ///< (T + 1) N square, symmetric, m/N
    /** Motions of the nodes whose generalised forces are asked for besides,
     * (T + 1) N rows; empty where there are none. */
    DenseMatrix watched;

    double retardation = 0.; ///< tau, s

    unsigned int n_wheel_modes = 0; ///< the first columns of Phi

    unsigned int n_modes() const
    {
      return K_m.rows();
    }
  };

  /**
   * Throws InputError unless the sizes of @p pair fit each other, tau >= 0 and
   * W_res is symmetric with no eigenvalue below -1e-10 of its largest one.
   * Modes and compliance that come from different matrices fail here: then
   * W_res would push where it should give way.
   */
  void check(const ReducedPair &pair);

  /**
   * A pair in contact at other nodes, to which motions go over as @p coupling
   * says, and forces back alike.
   */
  ReducedPair at_nodes(const ReducedPair     &pair,
                       const SurfaceCoupling &coupling);

  /**
   * A pair of which fast modes only follow, and the columns of the modes that
   * are left.
   */
  struct CondensedPair
  {
    ReducedPair               pair;
    std::vector<unsigned int> kept;

    /** Values of the modes of this pair as those of the whole one, 0 for modes
     * that follow. */
    std::vector<double> expanded(const std::vector<double> &values,
                                 const std::size_t          n_modes) const;
  };

  /**
   * Take the modes d with a stiffness K_dd above @p highest squared (1/s) as
   * static: W_res + Phi_d K_dd^-1 Phi_d^T, by the diagonal of K_m; their
   * inertia, their damping but tau, and what couples them to others are left
   * out.
   */
  CondensedPair condensed(const ReducedPair &pair, const double highest);

  /**
   * Let the material of the bodies pass through their modes, as a wheel does
   * that turns at @p rate: the material's velocity is d/dt + Omega d/dtheta,
   * which adds
   *
   *   2 Omega S to C_m,      Omega^2 S^2 + Omega C_m S to K_m,
   *
   * with the skew matrix S_ij = integral of rho phi_i . d(phi_j)/dtheta, m x m,
   * zero where modes do not turn. Units: 1, rad/s.
   */
  void add_rotation(ReducedPair &pair, const DenseMatrix &S, const double rate);
} // namespace RollingContact

#endif
