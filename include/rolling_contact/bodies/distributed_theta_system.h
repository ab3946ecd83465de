#ifndef rolling_contact_bodies_distributed_theta_system_h
#define rolling_contact_bodies_distributed_theta_system_h

#include <rolling_contact/bodies/distributed_body.h>
#include <rolling_contact/bodies/extrapolated_guess.h>
#include <rolling_contact/bodies/theta_system.h>

namespace RollingContact
{
  /**
   * Matrices of the theta-scheme for a distributed body: K, M and, for a time
   * step h,
   *   A = M + theta h C + theta^2 h^2 K
   * with conjugate gradients to solve with A; and on one rank the ThetaSystem
   * of the body's model, for the contact compliance. Shared by all states of
   * the body. Functions are collective unless they only return a value.
   */
  template <int dim>
  class DistributedThetaSystem
  {
  public:
    using SurfaceNode = typename ElasticBody<dim>::SurfaceNode;
    using Vector      = DistributedVector;

    /** Vectors and where to put their products with a matrix. */
    using Products = std::vector<std::pair<const Vector *, Vector *>>;

    /**
     * What a state of the body needs for the solves of a step: the motion
     * without reactions and what reactions add.
     */
    struct Work
    {
      explicit Work(const Vector &zero);

      /**
       * Begin the next solves with zero.
       */
      void forget();

      /**
       * Solves and iterations in a step, for the log.
       */
      std::string description() const;

      Vector            momentum; ///< right-hand side, then v_th
      Vector            z;        ///< of use to anybody
      ExtrapolatedGuess free_motion, answer;
      std::vector<double>
        free_velocity; ///< v_th of the contact without reactions
      std::vector<double> answered;
      unsigned int        n_steps = 0, n_solves = 0, n_iterations = 0;
    };

    DistributedThetaSystem(const DistributedBody<dim>      &body,
                           const ThetaScheme               &scheme,
                           const MassKind                   mass,
                           const std::vector<SurfaceNode>  &nodes,
                           const std::vector<unsigned int> &components);

    /**
     * Assemble A for steps of this length, unless it is there. Units: s.
     */
    void set_time_step(const double h);

    /**
     * Length of the step that A belongs to; 0 before set_time_step(). Units: s.
     */
    double time_step() const
    {
      return h;
    }

    const ThetaScheme &scheme() const
    {
      return parameters;
    }

    /**
     * Contact compliance h^2 E^T A^-1 E of the model; on its rank, empty on
     * others. Units: m/N.
     */
    const DenseMatrix &contact_compliance() const;

    Vector vector() const
    {
      return body.vector();
    }

    /**
     * Values at the contact nodes, component by component, on all ranks.
     */
    std::vector<double> on_contact(const Vector &values) const
    {
      return body.on_contact(contact, values);
    }

    /**
     * Begin a step of one or several states: solve for the motion without
     * reactions.
     */
    void begin(const std::vector<Work *> &states) const;

    /**
     * End a step: add what the reactions do to v_th. Units: N.
     */
    void end(const std::vector<Work *>                      &states,
             const std::vector<const std::vector<double> *> &reactions) const;

    /**
     * What reactions do to the contact nodes in a step, h^2 E^T A^-1 E r,
     * solved for unless it was asked for last. Units: N to m.
     */
    std::vector<double> response(Work                      &state,
                                 const std::vector<double> &reactions) const;

    void multiply_stiffness(const Products &products) const;

    void multiply_mass(const Products &products) const;

    /**
     * There is no damping beside that of the scheme.
     */
    bool multiply_damping(const Vector &, Vector &) const
    {
      return false;
    }

    /**
     * Sum over all ranks.
     */
    static void sum(std::vector<double> &values);

    static double dot(const Vector &x, const Vector &y)
    {
      return x * y;
    }

    /**
     * Memory of this rank in bytes.
     */
    BodyDynamics::Memory memory() const;

  private:
    /**
     * Solve A x = b, from the guess in @p x.
     */
    void solve(Vector &x, Work &state) const;

    /**
     * A += factor M.
     */
    void add_mass(const double factor);

    const DistributedBody<dim>                  &body;
    ThetaScheme                                  parameters;
    std::vector<dealii::types::global_dof_index> contact;
    dealii::TrilinosWrappers::SparseMatrix       K, A;
    dealii::TrilinosWrappers::SparseMatrix       consistent; ///< M if so
    DistributedVector                            lumped;     ///< M if so
    bool                                         is_lumped;
    std::unique_ptr<MultigridSolver>             multigrid;
    std::unique_ptr<ThetaSystem>                 model;
    DenseMatrix                                  nothing;
    double                                       h = 0.;
  };
} // namespace RollingContact

#endif
