#include <rolling_contact/linear_algebra/dense_eigenvalues.h>
#include <rolling_contact/stability/rational_fit.h>

#include <algorithm>
#include <random>

namespace RollingContact
{
  namespace
  {
    /**
     * A few random combinations of the columns, each scaled to largest entry 1:
     * what fits them fits all.
     */
    ComplexMatrix
    combinations(const ComplexMatrix &values)
    {
      const std::size_t n = values.n_rows(), n_functions = values.n_columns(),
                        n_kept = std::min<std::size_t>(n_functions, 16);
      std::mt19937                     generator(1);
      std::normal_distribution<double> normal;
      std::vector<double>              sizes(n_functions, 0.);
      for (std::size_t j = 0; j < n_functions; ++j)
        for (std::size_t i = 0; i < n; ++i)
          sizes[j] = std::max(sizes[j], std::abs(values(i, j)));
      const double least = 1e-9 * *std::max_element(sizes.begin(), sizes.end());
      ComplexMatrix mixed(n, n_kept);
      for (std::size_t j = 0; j < n_functions; ++j)
        for (std::size_t k = 0; k < n_kept; ++k)
          {
            const double factor =
              sizes[j] > 0. ? normal(generator) / std::max(sizes[j], least)
                            : 0.;
            for (std::size_t i = 0; i < n; ++i)
              mixed(i, k) += factor * values(i, j);
          }
      return mixed;
    }



    /**
     * The weights of the support points that solve the linearised problem of
     * least squares at the other points.
     */
    ComplexVector
    best_weights(const ComplexVector            &points,
                 const ComplexMatrix            &values,
                 const std::vector<std::size_t> &support,
                 const std::vector<bool>        &is_support)
    {
      const std::size_t n_rest    = points.size() - support.size(),
                        n_columns = values.n_columns();
      ComplexMatrix loewner(n_rest * n_columns, support.size());
      for (std::size_t l = 0; l < support.size(); ++l)
        {
          std::size_t row = 0;
          for (std::size_t i = 0; i < points.size(); ++i)
            if (!is_support[i])
              for (std::size_t k = 0; k < n_columns; ++k)
                loewner(row++, l) = (values(i, k) - values(support[l], k)) /
                                    (points[i] - points[support[l]]);
        }
      return smallest_singular_vector(std::move(loewner));
    }
  } // namespace



  RationalFit::RationalFit(const ComplexVector &points,
                           const ComplexMatrix &values,
                           const double         tolerance,
                           const unsigned int   most_points)
  {
    const std::size_t   n         = points.size();
    const ComplexMatrix mixed     = combinations(values);
    const std::size_t   n_columns = mixed.n_columns();
    ComplexMatrix       fitted(n, n_columns);
    double              largest = 0.;
    for (std::size_t k = 0; k < n_columns; ++k)
      for (std::size_t i = 0; i < n; ++i)
        {
          largest = std::max(largest, std::abs(mixed(i, k)));
          for (std::size_t j = 0; j < n; ++j)
            fitted(j, k) += mixed(i, k) / static_cast<double>(n);
        }
    std::vector<std::size_t> chosen;
    std::vector<bool>        is_chosen(n, false);
    while (true)
      {
        std::size_t worst = 0;
        double      error = 0.;
        for (std::size_t i = 0; i < n; ++i)
          for (std::size_t k = 0; k < n_columns && !is_chosen[i]; ++k)
            if (std::abs(mixed(i, k) - fitted(i, k)) > error)
              {
                error = std::abs(mixed(i, k) - fitted(i, k));
                worst = i;
              }
        largest_error     = largest > 0. ? error / largest : 0.;
        const bool enough = largest_error <= tolerance && !chosen.empty();
        if (enough || chosen.size() >= most_points || 2 * chosen.size() + 2 > n)
          break;
        chosen.push_back(worst);
        is_chosen[worst] = true;
        weights          = best_weights(points, mixed, chosen, is_chosen);
        for (std::size_t i = 0; i < n; ++i)
          {
            std::complex<double> sum = 0.;
            ComplexVector        numerator(n_columns);
            for (std::size_t l = 0; l < chosen.size() && !is_chosen[i]; ++l)
              {
                const auto part = weights[l] / (points[i] - points[chosen[l]]);
                sum += part;
                for (std::size_t k = 0; k < n_columns; ++k)
                  numerator[k] += part * mixed(chosen[l], k);
              }
            for (std::size_t k = 0; k < n_columns; ++k)
              fitted(i, k) = is_chosen[i] ? mixed(i, k) : numerator[k] / sum;
          }
      }
    at_support = ComplexMatrix(values.n_columns(), chosen.size());
    for (std::size_t l = 0; l < chosen.size(); ++l)
      {
        support.push_back(points[chosen[l]]);
        for (std::size_t j = 0; j < values.n_columns(); ++j)
          at_support(j, l) = values(chosen[l], j);
      }
  }



  ComplexVector
  RationalFit::operator()(const std::complex<double> s) const
  {
    ComplexVector        parts(support.size());
    std::complex<double> sum = 0.;
    for (std::size_t l = 0; l < support.size(); ++l)
      {
        const std::complex<double> distance = s - support[l];
        if (std::abs(distance) <= 1e-13 * std::abs(s))
          {
            std::fill(parts.begin(), parts.end(), 0.);
            parts[l] = sum = 1.;
            break;
          }
        sum += parts[l] = weights[l] / distance;
      }
    for (auto &part : parts)
      part /= sum;
    return at_support * parts;
  }
} // namespace RollingContact
