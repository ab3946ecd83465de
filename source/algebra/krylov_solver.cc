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

  std::vector<double> solved_by_krylov(const LinearMap           &A,
                                       const LinearMap           &P,
                                       const std::vector<double> &b,
                                       const double               tolerance,
                                       const unsigned int         most)
  {
    const Values right(b.begin(), b.end());
    Values       x(b.size());
    if (right.l2_norm() == 0.)
      return b;
    dealii::SolverControl                       control(most,
                                  tolerance * right.l2_norm(),
                                  false,
                                  false);
    dealii::SolverGMRES<Values>::AdditionalData data;
    data.max_n_tmp_vectors     = most + 2;
    data.right_preconditioning = true;
    try
      {
        dealii::SolverGMRES<Values>(control, data)
          .solve(MappedVectors{A}, x, right, MappedVectors{P});
      }
    catch (const dealii::SolverControl::NoConvergence &)
      {
        // x is the best there is
      }
    return {x.begin(), x.end()};
  }
} // namespace RollingContact
