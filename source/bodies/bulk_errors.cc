#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/bodies/bulk_errors.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /**
     * 1, x, y, x^2, x y or y^2 of a point, k = 0, 1, ..., 5.
     */
    double shape(const unsigned int           k,
                 const std::array<double, 2> &at,
                 const std::array<double, 2> &scale)
    {
      const double x = at[0] / scale[0],
                   y = scale[1] > 0. ? at[1] / scale[1] : 0.;
      const std::array<double, 6> all{{1., x, y, x * x, x * y, y * y}};
      return all[k];
    }
  } // namespace

  SmoothForces::SmoothForces(const Positions             &positions,
                             const std::vector<double>   &areas,
                             const std::array<double, 2> &half_widths,
                             const unsigned int           n_components,
                             const unsigned int           degree)
    : scale(half_widths)
    , n_components(n_components)
    , n_shapes(half_widths[1] > 0. ? (degree == 1 ? 3 : 6) : 2)
  {
    const std::size_t   N = positions.size();
    std::vector<double> ellipse;
    double              sum = 0.;
    for (std::size_t i = 0; i < N; ++i)
      {
        double height = 1.;
        for (const unsigned int k : {1u, 2u})
          height -= std::pow(shape(k, positions[i], scale), 2);
        ellipse.push_back(areas[i] * std::sqrt(std::max(0., height)));
        sum += ellipse.back();
      }
    for (unsigned int c = 0; c < n_components; ++c)
      for (unsigned int k = 0; k < n_shapes; ++k)
        {
          std::vector<double> force(n_components * N, 0.);
          for (std::size_t i = 0; i < N; ++i)
            force[c * N + i] = ellipse[i] / sum * shape(k, positions[i], scale);
          all.push_back(std::move(force));
        }
    const std::size_t n = all.size();
    DenseMatrix       of_forces(n, n);
    for (std::size_t l = 0; l < n; ++l)
      of_forces.col(l) = moments(positions, all[l]);
    of_moments = DenseMatrix::Identity(n, n);
    if (!solve_general(of_forces, of_moments))
      of_moments.setZero();
  }

  Eigen::VectorXd SmoothForces::moments(const Positions           &positions,
                                        const std::vector<double> &values) const
  {
    const std::size_t N    = positions.size();
    Eigen::VectorXd   sums = Eigen::VectorXd::Zero(n_components * n_shapes);
    for (unsigned int c = 0; c < n_components; ++c)
      for (unsigned int k = 0; k < n_shapes; ++k)
        for (std::size_t i = 0; i < N; ++i)
          sums[c * n_shapes + k] +=
            values[c * N + i] * shape(k, positions[i], scale);
    return sums;
  }

  Eigen::VectorXd SmoothForces::amounts(const Positions           &positions,
                                        const std::vector<double> &values) const
  {
    return of_moments * moments(positions, values);
  }

  double BulkErrors::largest(const SmoothForces::Positions &at_weights,
                             const std::vector<double>     &weights,
                             const SmoothForces::Positions &at_forces,
                             const std::vector<double>     &forces) const
  {
    const Eigen::VectorXd of_weights = smooth.amounts(at_weights, weights),
                          of_forces  = smooth.amounts(at_forces, forces);
    double sum                       = 0.;
    for (const DenseMatrix &part : parts)
      sum += std::abs(of_weights.dot(part * of_forces));
    return sum;
  }
} // namespace RollingContact
