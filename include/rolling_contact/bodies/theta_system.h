#ifndef rolling_contact_bodies_theta_system_h
#define rolling_contact_bodies_theta_system_h

#include <rolling_contact/algebra/factorisation.h>
#include <rolling_contact/bodies/body_dynamics.h>

#include <cstddef>
#include <string>
#include <utility>
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
    using Vector = std::vector<double>;

    /** Vectors and where to put their products with a matrix. */
    using Products = std::vector<std::pair<const Vector *, Vector *>>;

    /**
     * What a state of the body needs for the solves of a step.
     */
    struct Work
    {
      explicit Work(const Vector &zero)
        : momentum(zero)
        , z(zero)
      {}

      void forget()
      {}

      std::string description() const
      {
        return "";
      }

      Vector momentum;      ///< right-hand side, then v_th
      Vector z;             ///< half-solved; free outside a step
      Vector free_velocity; ///< v_th of the contact unknowns without reactions
    };

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
    void set_time_step(const double h);

    /**
     * Length of the step; 0 before set_time_step(). Units: s.
     */
    double time_step() const
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
    const DenseMatrix &contact_compliance() const
    {
      return compliance;
    }

    /**
     * The condensed columns Y = L^-1 E of A.
     */
    const CondensedColumns &columns() const
    {
      return Y;
    }

    const Factorisation &factorisation() const
    {
      return factor;
    }

    const ThetaScheme &scheme() const
    {
      return parameters;
    }

    const SymmetricSparseMatrix &stiffness() const
    {
      return K;
    }

    const SymmetricSparseMatrix &mass() const
    {
      return M;
    }

    /**
     * A zero vector of all unknowns.
     */
    Vector vector() const
    {
      return Vector(M.size(), 0.);
    }

    /**
     * Values at the contact unknowns.
     */
    std::vector<double> on_contact(const Vector &values) const;

    /**
     * Begin a step of one or two states: one forward solve z = L^-1 b with the
     * momenta b, and v_th = Y^T z without reactions.
     */
    void begin(const std::vector<Work *> &states) const;

    /**
     * End a step: one backward solve for v_th with reactions. Units: N.
     */
    void end(const std::vector<Work *>                      &states,
             const std::vector<const std::vector<double> *> &reactions) const;

    /**
     * What reactions do to the contact unknowns in a step, see
     * contact_compliance(). Units: N to m.
     */
    std::vector<double> response(Work &,
                                 const std::vector<double> &reactions) const;

    /**
     * Products with K and M of one or two vectors, reading the matrix once.
     */
    void multiply_stiffness(const Products &products) const;

    void multiply_mass(const Products &products) const;

    /**
     * Product with the damping beside that of the scheme; false if there is
     * none.
     */
    bool multiply_damping(const Vector &x, Vector &result) const;

    /**
     * Sum over the ranks that share a vector, which is this one.
     */
    static void sum(std::vector<double> &)
    {}

    static double dot(const Vector &x, const Vector &y)
    {
      return RollingContact::dot(x, y);
    }

    /**
     * Memory in bytes.
     */
    BodyDynamics::Memory memory() const
    {
      return {K.memory_consumption() + M.memory_consumption(),
              factor.size().memory_consumption(),
              Y.memory_consumption()};
    }

    /**
     * Bytes of the factor, Y, the compliance, K, M and the damping.
     */
    std::size_t memory_consumption() const;

  private:
    SymmetricSparseMatrix step_matrix(const double h) const;

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
