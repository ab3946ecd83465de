#ifndef rolling_contact_algebra_multigrid_solver_h
#define rolling_contact_algebra_multigrid_solver_h

#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <cstddef>
#include <vector>

namespace RollingContact
{
  /**
   * Solver of A x = b for a symmetric positive definite A with the unknowns of
   * a mesh node consecutive: conjugate gradients preconditioned by one cycle of
   * smoothed aggregation (Trilinos' ML; Vanek, Mandel and Brezina 1996),
   * smoothed by Chebyshev polynomials, which do not depend on the number of
   * ranks. Owns the hierarchy; the matrix is the caller's. All functions are
   * collective.
   *
   * Iterations hardly grow with the number of unknowns, but do with Poisson's
   * ratio from 0.45 on: rigid modes span nothing of the fields of constant
   * volume.
   */
  class MultigridSolver
  {
  public:
    using Vector = dealii::LinearAlgebra::distributed::Vector<double>;

    /**
     * CG iterations of all right-hand sides together, the most of one, and the
     * largest |b - A x| / |b|.
     */
    struct Report
    {
      unsigned int iterations = 0;
      unsigned int most       = 0;
      double       residual   = 0.;
    };

    /**
     * Build the hierarchy. @p modes are the fields that A nearly maps to zero,
     * zero in constrained entries: for elasticity the 3 or 6 rigid modes. If
     * there are none, each of the @p n_components components of a node gets a
     * constant. They are copied, the matrix must outlive the solver.
     */
    MultigridSolver(const dealii::TrilinosWrappers::SparseMatrix &matrix,
                    const std::vector<Vector>                    &modes,
                    const unsigned int                            n_components);

    /**
     * Solve A x = b for all right-hand sides, from the initial guesses in @p x
     * to |b - A x| <= tolerance |b|, or to 10 eps |A| |x| where that is larger,
     * and at most 1e-9 |b|: nearly incompressible bodies reach no more. Vectors
     * have no ghost entries. Throws ConvergenceError with iterations, residual
     * and tolerance.
     */
    Report solve(std::vector<Vector>       &x,
                 const std::vector<Vector> &b,
                 const double               tolerance) const;

    /**
     * Bytes of the coarse matrices and transfers on this rank. The factor of
     * the coarsest matrix is not counted.
     */
    std::size_t memory_consumption() const;

    double setup_seconds() const
    {
      return setup_s;
    }

  private:
    Report solve(Vector &x, const Vector &b, const double tolerance) const;

    const dealii::TrilinosWrappers::SparseMatrix &matrix;
    dealii::TrilinosWrappers::PreconditionAMG     preconditioner;
    double                                        setup_s = 0.;
  };
} // namespace RollingContact

#endif
