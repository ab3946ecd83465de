#include <rolling_contact/solvers/anderson.h>

#include <algorithm>

namespace RollingContact
{
  namespace
  {
    NodalField
    difference(NodalField x, const NodalField &y)
    {
      return x -= y;
    }
  } // namespace



  NodalField
  Anderson::next(const NodalField &x, const NodalField &image)
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

    NodalField result = image;
    for (std::size_t k = 0; k < n; ++k)
      result.add(-weights(k, 0), difference(images[k + 1], images[k]));
    return result;
  }
} // namespace RollingContact
