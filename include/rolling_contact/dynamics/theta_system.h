#ifndef rolling_contact_dynamics_theta_system_h
#define rolling_contact_dynamics_theta_system_h

#include <rolling_contact/dynamics/theta_scheme.h>
#include <rolling_contact/linear_algebra/factorisation.h>

#include <cstddef>
#include <vector>

namespace RollingContact
{
  /**
   * The matrices of one body in time, shared by all states of it (two for
   * mirror-identical bodies): K, M and, for a time step h, the factor of
   *   A = M + theta h C + theta^2 h^2 K,
   * C being that of the scheme (Rayleigh) and a given one; its condensed
   * columns Y = L^-1 E for the contact unknowns, and h^2 Y^T Y.
   */
  class ThetaSystem
  {
  public:
    /**
     * Order, analyse; nothing is factorised before set_time_step(). K and M
     * have the same size, M may be diagonal (lumped). The @p damping, of size 0
     * if there is none, adds to that of the scheme. Units: N/m, kg, N s/m.
     */
    ThetaSystem(const ThetaScheme               &scheme,
                SymmetricSparseMatrix            stiffness,
                SymmetricSparseMatrix            mass,
                const std::vector<unsigned int> &node_of_unknown,
                std::vector<std::size_t>         contact_unknowns,
                SymmetricSparseMatrix            damping = {});

    /**
     * Factorise A and condense, if @p h is not the current step. Throws
     * InputError unless h > 0, ConvergenceError when A is not positive
     * definite. Units: s.
     */
    void
    set_time_step(const double h);

    /**
     * Length of the step; 0 before set_time_step(). Units: s.
     */
    double
    time_step() const
    {
      return h;
    }

    /**
     * Compliance h^2 E^T A^-1 E: for unit reactions, the change of the shifted
     * displacement of the contact unknowns,
     *   u1 + h (1 - theta) v1 = u0 + h (1 - theta) v0 + h v1.
     * The changes of v_th, v1 and u1 are theta/h, 1/h and theta times it.
     * Units: m/N.
     */
    const DenseMatrix &
    contact_compliance() const
    {
      return compliance;
    }

    /**
     * The condensed columns Y = L^-1 E of A.
     */
    const CondensedColumns &
    columns() const
    {
      return Y;
    }

    const Factorisation &
    factorisation() const
    {
      return factor;
    }

    const ThetaScheme &
    scheme() const
    {
      return parameters;
    }

    const SymmetricSparseMatrix &
    stiffness() const
    {
      return K;
    }

    const SymmetricSparseMatrix &
    mass() const
    {
      return M;
    }

    /**
     * Damping beside that of the scheme; of size 0 if there is none.
     */
    const SymmetricSparseMatrix &
    damping() const
    {
      return D;
    }

    const std::vector<std::size_t> &
    contact_unknowns() const
    {
      return contact;
    }

    /**
     * Bytes of the factor, Y, the compliance, K, M and the damping.
     */
    std::size_t
    memory_consumption() const;

  private:
    SymmetricSparseMatrix
    step_matrix(const double h) const;

    ThetaScheme              parameters;
    SymmetricSparseMatrix    K, M, D;
    std::vector<std::size_t> contact;
    Factorisation            factor;
    double                   h = 0.;
    CondensedColumns         Y;
    DenseMatrix              compliance;
  };
} // namespace RollingContact

#endif
