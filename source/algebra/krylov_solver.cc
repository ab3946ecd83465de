#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>
#include <deal.II/lac/vector.h>

#include <rolling_contact/algebra/krylov_solver.h>

#include <algorithm>

namespace RollingContact
{
  namespace
  {
    using Values = dealii::Vector<double>;

    /** A map as deal.II's solvers want one. */
    struct MappedVectors
    {
      const LinearMap &map;

      void vmult(Values &image, const Values &x) const
      {
        const auto result = map(std::vector<double>(x.begin(), x.end()));
        std::copy(result.begin(), result.end(), image.begin());
      }
    };
  } // namespace

  bool solve_by_krylov(const LinearMap           &A,
                       const LinearMap           &P,
                       const std::vector<double> &b,
                       const double               tolerance,
                       const unsigned int         max_iterations,
                       std::vector<double>       &x)
  {
    Values right(b.begin(), b.end()), solution(x.begin(), x.end());
    if (right.l2_norm() == 0.)
      {
        std::fill(x.begin(), x.end(), 0.);
        return true;
      }
    dealii::SolverControl                       control(max_iterations,
                                  tolerance * right.l2_norm(),
                                  false,
                                  false);
    dealii::SolverGMRES<Values>::AdditionalData data;
    data.max_n_tmp_vectors     = 102;
    data.right_preconditioning = true;
    bool converged             = true;
    try
      {
        dealii::SolverGMRES<Values>(control, data)
          .solve(MappedVectors{A}, solution, right, MappedVectors{P});
      }
    catch (const dealii::SolverControl::NoConvergence &)
      {
        converged = false;
      }
    std::copy(solution.begin(), solution.end(), x.begin());
    return converged;
  }
} // namespace RollingContact
