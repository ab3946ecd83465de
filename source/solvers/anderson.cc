#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/solvers/anderson.h>

namespace RollingContact
{
  namespace
  {
    NodalField difference(NodalField x, const NodalField &y)
    {
      return x -= y;
    }
  } // namespace

  NodalField Anderson::next(const NodalField &x, const NodalField &image)
  {
    images.push_back(image);
    residuals.push_back(difference(image, x));
    if (images.size() > depth + 1)
      {
        images.pop_front();
        residuals.pop_front();
      }
    const std::size_t n = images.size() - 1;
    if (n == 0)
      return image;

    std::vector<NodalField> changes;
    for (std::size_t k = 0; k < n; ++k)
      changes.push_back(difference(residuals[k + 1], residuals[k]));
    DenseMatrix     normal_matrix(n, n);
    Eigen::VectorXd weights(n);
    for (std::size_t i = 0; i < n; ++i)
      {
        weights[i] = dot(changes[i], residuals.back());
        for (std::size_t j = 0; j < n; ++j)
          normal_matrix(i, j) = dot(changes[i], changes[j]);
      }
    const double largest = normal_matrix.diagonal().maxCoeff();
    normal_matrix.diagonal().array() += 1e-12 * largest;
    if (largest == 0. || !solve_positive_definite(normal_matrix, weights))
      return image;

    NodalField result = image;
    for (std::size_t k = 0; k < n; ++k)
      result.add(-weights[k], difference(images[k + 1], images[k]));
    return result;
  }
} // namespace RollingContact
