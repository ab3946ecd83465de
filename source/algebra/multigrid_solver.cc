#include <deal.II/lac/solver_cg.h>

#include <Epetra_MultiVector.h>
#include <ml_MultiLevelPreconditioner.h>

#include <rolling_contact/algebra/multigrid_solver.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/memory.h>
#include <rolling_contact/base/stopwatch.h>
#include <rolling_contact/base/text.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    const unsigned int max_iterations = 1000;

    /**
     * Smoothed aggregation as measured on bodies with strong local refinement:
     * no threshold, since dropping entries only adds iterations; three steps of
     * Chebyshev, since fewer cost as much and need more global sums. W-cycles
     * in 2D, where levels are more and V-cycles weaken with their number.
     */
    Teuchos::ParameterList settings(const unsigned int n_components)
    {
      Teuchos::ParameterList list;
      ML_Epetra::SetDefaults("SA", list);
      list.set("PDE equations", int(n_components));
      list.set("prec type", n_components == 2 ? "MGW" : "MGV");
      list.set("aggregation: type", "Uncoupled");
      list.set("aggregation: threshold", 0.);
      list.set("smoother: type", "Chebyshev");
      list.set("smoother: sweeps", 3);
      list.set("smoother: Chebyshev alpha", 20.);
      list.set("coarse: type", "Amesos-KLU");
      list.set("coarse: max size", 2000);
      list.set("ML output", 0);
      return list;
    }

    double relative_residual(const TrilinosWrappers::SparseMatrix &matrix,
                             const MultigridSolver::Vector        &x,
                             const MultigridSolver::Vector        &b)
    {
      MultigridSolver::Vector residual(b);
      matrix.vmult(residual, x);
      residual -= b;
      return residual.l2_norm() / b.l2_norm();
    }
  } // namespace

  MultigridSolver::MultigridSolver(const TrilinosWrappers::SparseMatrix &matrix,
                                   const std::vector<Vector>            &modes,
                                   const unsigned int n_components)
    : matrix(matrix)
  {
    const Stopwatch        watch;
    Teuchos::ParameterList list = settings(n_components);
    // ML reads the modes while it builds the hierarchy, not afterwards
    Epetra_MultiVector null_space(matrix.trilinos_matrix().RowMap(),
                                  std::max<int>(1, modes.size()));
    for (std::size_t i = 0; i < modes.size(); ++i)
      std::copy(modes[i].begin(), modes[i].end(), null_space[i]);
    if (!modes.empty())
      {
        list.set("null space: type", "pre-computed");
        list.set("null space: dimension", int(modes.size()));
        list.set("null space: vectors", null_space.Values());
      }
    preconditioner.initialize(matrix, list);
    release_free_memory(); // three times as much as the hierarchy keeps
    setup_s = watch.seconds();
  }

  MultigridSolver::Report MultigridSolver::solve(std::vector<Vector>       &x,
                                                 const std::vector<Vector> &b,
                                                 const double tolerance) const
  {
    Report sum;
    for (std::size_t i = 0; i < b.size(); ++i)
      {
        const Report report = solve(x[i], b[i], tolerance);
        sum.iterations += report.iterations;
        sum.most     = std::max(sum.most, report.iterations);
        sum.residual = std::max(sum.residual, report.residual);
      }
    return sum;
  }

  MultigridSolver::Report MultigridSolver::solve(Vector       &x,
                                                 const Vector &b,
                                                 const double  tolerance) const
  {
    const double norm = b.l2_norm();
    if (!std::isfinite(norm))
      throw ConvergenceError("A load of a body is not a number.");
    if (norm == 0.)
      {
        x = 0.;
        return {};
      }
    Report report{0, 0, relative_residual(matrix, x, b)};
    // a guess from a much larger load is worse than none
    if (!(report.residual <= 1.))
      {
        x               = 0.;
        report.residual = 1.;
      }
    // the residual that CG updates may drift from b - A x: then start again,
    // as long as that helps
    for (double previous = 2 * report.residual + 1;
         !(report.residual <= tolerance);)
      {
        SolverControl control(max_iterations - report.iterations,
                              tolerance * norm);
        bool          stuck = !(report.residual < previous / 2);
        previous            = report.residual;
        try
          {
            if (!stuck)
              SolverCG<Vector>(control).solve(matrix, x, b, preconditioner);
          }
        catch (const SolverControl::NoConvergence &)
          {
            stuck = true;
          }
        if (control.last_step() != numbers::invalid_unsigned_int)
          report.iterations += control.last_step();
        report.residual = relative_residual(matrix, x, b);
        if (!stuck || report.residual <= tolerance)
          continue;
        // b - A x cannot be told more exactly
        const double rounding = 10 * std::numeric_limits<double>::epsilon() *
                                matrix.linfty_norm() * x.l2_norm();
        if (!(report.residual <= 1e-9 && report.residual * norm <= rounding))
          throw ConvergenceError(
            "CG with multigrid is at a residual of " +
            significant(report.residual, 2) + " |b| after " +
            std::to_string(report.iterations) + " iterations, required is " +
            significant(tolerance, 2) +
            ": is the body held, and Poisson's ratio below 0.49?");
        break;
      }
    return report;
  }

  std::size_t MultigridSolver::memory_consumption() const
  {
    const auto &ml = *dynamic_cast<ML_Epetra::MultiLevelPreconditioner &>(
                        preconditioner.trilinos_operator())
                        .GetML();
    std::size_t n_entries = 0;
    for (int level = 1; level < ml.ML_num_actual_levels; ++level)
      n_entries += ml.Amat[level].N_nonzeros + ml.Pmat[level].N_nonzeros +
                   ml.Rmat[level - 1].N_nonzeros;
    return n_entries * (sizeof(double) + sizeof(int));
  }
} // namespace RollingContact
