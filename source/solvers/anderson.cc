#include <rolling_contact/linear_algebra/dense_matrix.h>
#include <rolling_contact/solvers/anderson.h>

#include <algorithm>

namespace RollingContact
{
  namespace
  {
    std::vector<double>
    difference(const std::vector<double> &x, const std::vector<double> &y)
    {
      std::vector<double> result(x);
      for (std::size_t i = 0; i < x.size(); ++i)
        result[i] -= y[i];
      return result;
    }
  } // namespace



  std::vector<double>
  Anderson::next(const std::vector<double> &x, const std::vector<double> &image)
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

    std::vector<std::vector<double>> changes;
    for (std::size_t k = 0; k < n; ++k)
      changes.push_back(difference(residuals[k + 1], residuals[k]));
    DenseMatrix normal_matrix(n, n), weights(n, 1);
    double      largest = 0.;
    for (std::size_t i = 0; i < n; ++i)
      {
        weights(i, 0) = dot(changes[i], residuals.back());
        for (std::size_t j = 0; j < n; ++j)
          normal_matrix(i, j) = dot(changes[i], changes[j]);
        largest = std::max(largest, normal_matrix(i, i));
      }
    for (std::size_t i = 0; i < n; ++i)
      normal_matrix(i, i) += 1e-12 * largest;
    if (largest == 0. || !solve_positive_definite(normal_matrix, weights))
      return image;

    std::vector<double> result = image;
    for (std::size_t k = 0; k < n; ++k)
      {
        const std::vector<double> step = difference(images[k + 1], images[k]);
        for (std::size_t i = 0; i < result.size(); ++i)
          result[i] -= weights(k, 0) * step[i];
      }
    return result;
  }
} // namespace RollingContact
