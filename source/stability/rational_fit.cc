#include <rolling_contact/algebra/lapack.h>
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
    ComplexMatrix combinations(const ComplexMatrix &values)
    {
      const Eigen::Index n_kept = std::min<Eigen::Index>(values.cols(), 16);
      std::mt19937       generator(1);
      std::normal_distribution<double> normal;
      const Eigen::RowVectorXd sizes = values.cwiseAbs().colwise().maxCoeff();
      const double             least = 1e-9 * sizes.maxCoeff();
      ComplexMatrix mixed = ComplexMatrix::Zero(values.rows(), n_kept);
      for (Eigen::Index j = 0; j < values.cols(); ++j)
        for (Eigen::Index k = 0; k < n_kept && sizes[j] > 0.; ++k)
          mixed.col(k) +=
            normal(generator) / std::max(sizes[j], least) * values.col(j);
      return mixed;
    }

    /**
     * The weights of the support points that solve the linearised problem of
     * least squares at the other points.
     */
    ComplexVector best_weights(const ComplexValues            &points,
                               const ComplexMatrix            &values,
                               const std::vector<std::size_t> &support,
                               const std::vector<bool>        &is_support)
    {
      const std::size_t n_rest    = points.size() - support.size(),
                        n_columns = values.cols();
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

  RationalFit::RationalFit(const ComplexValues &points,
                           const ComplexMatrix &values,
                           const double         tolerance,
                           const unsigned int   most_points)
  {
    const std::size_t        n       = points.size();
    const ComplexMatrix      mixed   = combinations(values);
    const double             largest = mixed.cwiseAbs().maxCoeff();
    ComplexMatrix            fitted  = mixed.colwise().mean().replicate(n, 1);
    std::vector<std::size_t> chosen;
    std::vector<bool>        is_chosen(n, false);
    while (true)
      {
        // no error where points are chosen
        Eigen::Index worst = 0;
        const double error =
          (mixed - fitted).cwiseAbs().rowwise().maxCoeff().maxCoeff(&worst);
        largest_error     = largest > 0. ? error / largest : 0.;
        const bool enough = largest_error <= tolerance && !chosen.empty();
        if (enough || chosen.size() >= most_points || 2 * chosen.size() + 2 > n)
          break;
        chosen.push_back(worst);
        is_chosen[worst] = true;
        weights          = best_weights(points, mixed, chosen, is_chosen);
        for (std::size_t i = 0; i < n; ++i)
          {
            if (is_chosen[i])
              {
                fitted.row(i) = mixed.row(i);
                continue;
              }
            std::complex<double> sum = 0.;
            fitted.row(i).setZero();
            for (std::size_t l = 0; l < chosen.size(); ++l)
              {
                const auto part = weights[l] / (points[i] - points[chosen[l]]);
                sum += part;
                fitted.row(i) += part * mixed.row(chosen[l]);
              }
            fitted.row(i) /= sum;
          }
      }
    at_support = values(chosen, Eigen::all).transpose();
    for (const std::size_t k : chosen)
      support.push_back(points[k]);
  }

  ComplexVector RationalFit::operator()(const std::complex<double> s) const
  {
    ComplexVector        parts(support.size());
    std::complex<double> sum = 0.;
    for (std::size_t l = 0; l < support.size(); ++l)
      {
        const std::complex<double> distance = s - support[l];
        if (std::abs(distance) <= 1e-13 * std::abs(s))
          {
            parts.setZero();
            parts[l] = sum = 1.;
            break;
          }
        sum += parts[l] = weights[l] / distance;
      }
    return at_support * (parts / sum);
  }
} // namespace RollingContact
