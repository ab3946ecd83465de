#include <Eigen/Cholesky>

#include <rolling_contact/results/local_fit.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /**
     * What slopes and curvatures that nothing determines are held to zero by,
     * over the sum of the weights.
     */
    const double least_of_slopes = 1e-9, least_of_curvatures = 1e-6;

    const unsigned int most_terms = 10;
    using Terms  = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_terms, 1>;
    using Normal = Eigen::
      Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_terms, most_terms>;

    /**
     * 1, the coordinates, and their products, in units of @p scale.
     */
    Terms terms_at(const KnownPlace            &place,
                   const std::array<double, 3> &scale,
                   const unsigned int           n_coordinates)
    {
      Terms terms(1 + n_coordinates + n_coordinates * (n_coordinates + 1) / 2);
      unsigned int k = 0;
      terms[k++]     = 1.;
      for (unsigned int d = 0; d < n_coordinates; ++d)
        terms[k++] = place.at[d] / scale[d];
      for (unsigned int d = 0; d < n_coordinates; ++d)
        for (unsigned int e = 0; e <= d; ++e)
          terms[k++] = terms[1 + d] * terms[1 + e];
      return terms;
    }
  } // namespace

  FitWeights fit_in_origin(const std::vector<KnownPlace> &places,
                           const unsigned int             n_coordinates)
  {
    std::array<double, 3> scale{};
    for (const KnownPlace &place : places)
      for (unsigned int d = 0; d < n_coordinates; ++d)
        scale[d] = std::max(scale[d], std::abs(place.at[d]));
    for (double &length : scale)
      if (length == 0.)
        length = 1.;
    std::vector<Terms> terms;
    for (const KnownPlace &place : places)
      terms.push_back(terms_at(place, scale, n_coordinates));

    const unsigned int n_linear = 1 + n_coordinates, n = terms.front().size();
    Normal             M = Normal::Zero(n, n);
    for (std::size_t s = 0; s < places.size(); ++s)
      M += places[s].weight * terms[s] * terms[s].transpose();
    const double all = M(0, 0);
    for (unsigned int k = 1; k < n; ++k)
      M(k, k) += all * (k < n_linear ? least_of_slopes : least_of_curvatures);

    const auto weights = [&](const unsigned int n_terms) {
      const Terms value = Normal(M.topLeftCorner(n_terms, n_terms))
                            .ldlt()
                            .solve(Terms(Terms::Unit(n_terms, 0)));
      std::vector<double> result;
      for (std::size_t s = 0; s < places.size(); ++s)
        result.push_back(places[s].weight * terms[s].head(n_terms).dot(value));
      return result;
    };
    return {weights(n), weights(n_linear)};
  }
} // namespace RollingContact
