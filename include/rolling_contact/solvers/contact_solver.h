#ifndef rolling_contact_solvers_contact_solver_h
#define rolling_contact_solvers_contact_solver_h

#include <rolling_contact/contact/tangential_problem.h>

#include <memory>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * What a solver did: enough to judge the result and to see why it failed.
   */
  struct SolverReport
  {
    std::string  solver; ///< name, and fall-backs if any were used
    bool         used_fallback = false;
    bool         edges_settled = true; ///< the rounds of the edge law
    bool         converged     = false;
    std::string  reason;                ///< of a failure
    unsigned int iterations        = 0; ///< all of them, of all stages
    unsigned int normal_solves     = 0; ///< linear solves on active sets
    unsigned int tangential_solves = 0;
    unsigned int passes            = 0; ///< of normal and tangential solves
    unsigned int corrections       = 0; ///< of an approximate compliance
    unsigned int friction_rounds   = 0; ///< of friction that follows
    unsigned int force_rounds      = 0; ///< states tried for asked forces

    NaturalResidual              residual;
    std::vector<NaturalResidual> history;

    /**
     * Take the residual of the present iterate, also into the history. Returns
     * true if that ends the iteration: converged, when it is at most
     * @p tolerance, or not a number, which then is the reason of the failure.
     */
    bool ends_with(const NaturalResidual &now, const double tolerance);

    /**
     * Count the work of a part, whose history follows what is there.
     */
    void add_work(const SolverReport &part);

    /**
     * Count a solve with the mu that the one before left behind, whose verdict
     * but convergence becomes that of this report.
     */
    void add_friction_round(const SolverReport &part);

    /** For Boost.Serialization. A member not listed here does not compile. */
    template <typename Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      auto &[solver,
             used_fallback,
             edges_settled,
             converged,
             reason,
             iterations,
             normal_solves,
             tangential_solves,
             passes,
             corrections,
             friction_rounds,
             force_rounds,
             residual,
             history] = *this;
      archive &solver &used_fallback &edges_settled &converged &reason
        &iterations &normal_solves &tangential_solves &passes &corrections
          &friction_rounds &force_rounds &residual &history;
    }
  };

  /**
   * Limits common to all solvers. The augmentation parameters are
   * rho_n = normal_augmentation / ||W_nn H|| and
   * rho_t = tangential_augmentation / ||B1 W_tt H||: dimensionless factors.
   */
  struct SolverControls
  {
    double       tolerance               = 1e-10; ///< of the natural residual
    unsigned int max_iterations          = 10000;
    double       normal_augmentation     = 1.;
    double       tangential_augmentation = 0.3;
  };

  /**
   * Solves the whole contact problem, starting from the state given. Never
   * throws for lack of convergence: the report says so.
   */
  class ContactSolver
  {
  public:
    virtual ~ContactSolver() = default;

    virtual SolverReport solve(const ContactProblem &problem,
                               ContactState         &state) const = 0;
  };

  /**
   * Solves for the pressure (and approach) at fixed traction, in place.
   */
  class NormalSolver
  {
  public:
    explicit NormalSolver(const SolverControls &controls)
      : controls(controls)
    {}

    virtual ~NormalSolver() = default;

    virtual SolverReport solve(const ContactProblem &problem,
                               ContactState         &state) const = 0;

  protected:
    SolverControls controls;
  };

  /**
   * Solves for the traction at fixed pressure, in place of @p state.traction,
   * to half the tolerance: the other half is left to the pressure.
   */
  class TangentialSolver
  {
  public:
    explicit TangentialSolver(const SolverControls &controls)
      : controls(controls)
    {}

    virtual ~TangentialSolver() = default;

    virtual SolverReport solve(const TangentialProblem &problem,
                               ContactState            &state) const = 0;

  protected:
    /**
     * SolverReport::ends_with() for the tangential residual of a traction.
     */
    bool ends_with(const double  tangential_residual,
                   SolverReport &report) const;

    SolverControls controls;
  };

  /**
   * A solver as Contact/Solver and --print-parameters know it.
   */
  struct ContactSolverKind
  {
    using Maker = std::unique_ptr<ContactSolver> (*)(const SolverControls &);

    std::string name;
    std::string help; ///< "what it is", for the list of parameters
    Maker       make; ///< for friction that does not depend on the slip
  };

  /**
   * All contact solvers, the default first.
   */
  const std::vector<ContactSolverKind> &contact_solver_kinds();

  /**
   * The solver of a name in contact_solver_kinds(), with
   * FallingFriction around it. Throws InputError for any other name.
   */
  std::unique_ptr<ContactSolver>
  make_contact_solver(const std::string &name, const SolverControls &controls);
} // namespace RollingContact

#endif
