#include <rolling_contact/base/constants.h>
#include <rolling_contact/linear_algebra/block_products.h>
#include <rolling_contact/linear_algebra/dense_eigenvalues.h>
#include <rolling_contact/modes/absorbers.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace RollingContact
{
  namespace
  {
    /** A ring as a whole, at one of its coordinates. */
    struct Coordinate
    {
      std::size_t ring;
      double      mass;      ///< n m, kg
      double      frequency; ///< omega_0, rad/s
      double      stiffness; ///< k, N/m
      double      damping;   ///< c, N s/m
    };



    std::vector<Coordinate>
    coordinates(const AbsorberPlaces            &places,
                const std::vector<AbsorberRing> &rings)
    {
      if (rings.size() != places.diameters.size())
        throw std::logic_error("Absorbers are on other rings.");
      std::vector<Coordinate> result;
      for (std::size_t r = 0; r < rings.size(); ++r)
        {
          Coordinate at{r,
                        rings[r].number * rings[r].mass,
                        2 * pi * rings[r].frequency,
                        0.,
                        0.};
          at.stiffness = at.mass * at.frequency * at.frequency;
          at.damping   = 2 * rings[r].damping_ratio * at.mass * at.frequency;
          result.insert(result.end(), 2 * places.diameters[r] + 1, at);
        }
      return result;
    }



    /** T, the derivative by the angle. */
    DenseMatrix
    derivative(const AbsorberPlaces &places)
    {
      DenseMatrix T(places.n_coordinates(), places.n_coordinates());
      std::size_t first = 0;
      for (const unsigned int D : places.diameters)
        {
          for (unsigned int d = 1; d <= D; ++d)
            {
              const std::size_t c = first + 2 * d - 1, s = c + 1;
              T(c, s) = d;
              T(s, c) = -double(d);
            }
          first += 2 * D + 1;
        }
      return T;
    }



    /** (1/k + R)^-1. */
    DenseMatrix
    springs_on(const DenseMatrix &R, const std::vector<Coordinate> &at)
    {
      const std::size_t c = at.size();
      DenseMatrix       flexible(c, c), springs(c, c);
      for (std::size_t j = 0; j < c; ++j)
        {
          for (std::size_t i = 0; i < c; ++i)
            flexible(i, j) = (R(i, j) + R(j, i)) / 2;
          flexible(j, j) += 1 / at[j].stiffness;
          springs(j, j) = 1.;
        }
      if (c > 0 && !solve_positive_definite(flexible, springs))
        throw std::logic_error("Absorbers hang on a negative compliance.");
      return springs;
    }



    DenseMatrix
    enlarged(const DenseMatrix &A, const std::size_t n)
    {
      DenseMatrix result(n, n);
      for (std::size_t j = 0; j < A.n_columns(); ++j)
        for (std::size_t i = 0; i < A.n_rows(); ++i)
          result(i, j) = A(i, j);
      return result;
    }



    void
    add(const double factor, const DenseMatrix &A, DenseMatrix &sum)
    {
      for (std::size_t k = 0; k < A.n_rows() * A.n_columns(); ++k)
        sum.data()[k] += factor * A.data()[k];
    }
  } // namespace



  std::size_t
  AbsorberPlaces::n_coordinates() const
  {
    std::size_t sum = 0;
    for (const unsigned int D : diameters)
      sum += 2 * D + 1;
    return sum;
  }



  void
  hang_absorbers(const AbsorberPlaces            &places,
                 const std::vector<AbsorberRing> &rings,
                 const double                     rate,
                 DenseMatrix                     &K_m,
                 DenseMatrix                     &C_m)
  {
    const auto        at = coordinates(places, rings);
    const std::size_t c = at.size(), m = K_m.n_rows();
    if (c == 0)
      return;
    DenseMatrix elongation(c, m + c); // of the springs
    for (std::size_t i = 0; i < c; ++i)
      {
        for (std::size_t j = 0; j < m; ++j)
          elongation(i, j) = -places.motions(i, j);
        elongation(i, m + i) = 1 / std::sqrt(at[i].mass);
      }
    const DenseMatrix springs = springs_on(places.residual, at);
    DenseMatrix       share   = springs; // of the dashpots
    for (std::size_t j = 0; j < c; ++j)
      for (std::size_t i = 0; i < c; ++i)
        share(i, j) *=
          std::sqrt(at[i].damping) / at[i].stiffness; // c k^-2 in two halves
    const DenseMatrix dashpots = transposed_product(share, share),
                      T        = derivative(places),
                      flow     = dense_product(T, elongation);

    K_m = enlarged(K_m, m + c);
    C_m = enlarged(C_m, m + c);
    add(1.,
        transposed_product(elongation, dense_product(springs, elongation)),
        K_m);
    add(1.,
        transposed_product(elongation, dense_product(dashpots, elongation)),
        C_m);
    if (rate == 0.)
      return;
    add(rate,
        transposed_product(elongation, dense_product(dashpots, flow)),
        K_m);
    const DenseMatrix T_T = dense_product(T, T);
    for (std::size_t j = 0; j < c; ++j)
      for (std::size_t i = 0; i < c; ++i)
        {
          C_m(m + i, m + j) += 2 * rate * T(i, j);
          K_m(m + i, m + j) += rate * rate * T_T(i, j);
        }
  }



  void
  join_absorbers(const AbsorberPlaces            &places,
                 const std::vector<AbsorberRing> &rings,
                 const DenseMatrix               &cross,
                 DenseMatrix                     &shapes,
                 DenseMatrix                     &residual)
  {
    const auto        at = coordinates(places, rings);
    const std::size_t m = shapes.n_columns(), n = shapes.n_rows(),
                      c = at.size();
    const DenseMatrix by_spring =
                        dense_product(cross, springs_on(places.residual, at)),
                      of_modes = dense_product(by_spring, places.motions);
    DenseMatrix all(n, m + c);
    for (std::size_t i = 0; i < n; ++i)
      {
        for (std::size_t j = 0; j < m; ++j)
          all(i, j) = shapes(i, j) - of_modes(i, j);
        for (std::size_t k = 0; k < c; ++k)
          all(i, m + k) = by_spring(i, k) / std::sqrt(at[k].mass);
      }
    shapes                   = std::move(all);
    const DenseMatrix softer = dense_product(by_spring, transposed(cross));
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i)
        residual(i, j) -= (softer(i, j) + softer(j, i)) / 2;
  }



  std::vector<double>
  absorbers_at_rest(const AbsorberPlaces            &places,
                    const std::vector<AbsorberRing> &rings,
                    const std::vector<double>       &eta,
                    const std::vector<double>       &left_out)
  {
    const auto          at = coordinates(places, rings);
    std::vector<double> z  = left_out;
    for (std::size_t i = 0; i < z.size(); ++i)
      {
        for (std::size_t j = 0; j < eta.size(); ++j)
          z[i] += places.motions(i, j) * eta[j];
        z[i] *= std::sqrt(at[i].mass);
      }
    return z;
  }



  ComplexMatrix
  absorber_stiffness(const AbsorberPlaces            &places,
                     const std::vector<AbsorberRing> &rings,
                     const double                     rate,
                     const std::complex<double>       s)
  {
    const auto        at = coordinates(places, rings);
    const DenseMatrix T  = derivative(places);
    const std::size_t c  = at.size();
    ComplexMatrix     sigma(c, c), g(c, c);
    for (std::size_t j = 0; j < c; ++j)
      {
        for (std::size_t i = 0; i < c; ++i)
          {
            sigma(i, j) = rate * T(i, j) + (i == j ? s : 0.);
            g(i, j)     = at[i].damping * sigma(i, j);
          }
        g(j, j) += at[j].stiffness;
      }
    ComplexMatrix free = sigma * sigma; // n m sigma^2 + g
    for (std::size_t j = 0; j < c; ++j)
      for (std::size_t i = 0; i < c; ++i)
        free(i, j) = at[i].mass * free(i, j) + g(i, j);
    ComplexMatrix   follows = g;
    const ComplexLU factors(std::move(free));
    factors.solve(follows);
    const ComplexMatrix carried = g * follows;
    for (std::size_t j = 0; j < c; ++j)
      for (std::size_t i = 0; i < c; ++i)
        g(i, j) -= carried(i, j);
    return g;
  }



  std::vector<std::complex<double>>
  receptances_with(const std::vector<std::complex<double>> &alpha,
                   const ComplexMatrix                     &Z,
                   const std::size_t                        n)
  {
    const std::size_t c = Z.n_rows(), all = n + c;
    const auto        at = [&](const std::size_t p, const std::size_t q) {
      return alpha[p + q * all];
    };
    ComplexMatrix of_ring(c, c), to_ring(c, n);
    for (std::size_t q = 0; q < c; ++q)
      for (std::size_t p = 0; p < c; ++p)
        of_ring(p, q) = at(n + p, n + q);
    for (std::size_t q = 0; q < n; ++q)
      for (std::size_t p = 0; p < c; ++p)
        to_ring(p, q) = at(n + p, q);
    ComplexMatrix system = Z * of_ring, force = Z * to_ring;
    for (std::size_t p = 0; p < c; ++p)
      system(p, p) += 1.;
    const ComplexLU factors(std::move(system));
    factors.solve(force);
    std::vector<std::complex<double>> result(n * n);
    for (std::size_t q = 0; q < n; ++q)
      for (std::size_t p = 0; p < n; ++p)
        {
          std::complex<double> value = at(p, q);
          for (std::size_t k = 0; k < c; ++k)
            value -= at(p, n + k) * force(k, q);
          result[p + q * n] = value;
        }
    return result;
  }



  double
  softening(const AbsorberPlaces            &places,
            const std::vector<AbsorberRing> &rings)
  {
    const auto at      = coordinates(places, rings);
    double     largest = 0.;
    for (std::size_t i = 0; i < at.size(); ++i)
      largest = std::max(largest, at[i].stiffness * places.residual(i, i));
    return largest;
  }
} // namespace RollingContact
