#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/base/constants.h>
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

    std::vector<Coordinate> coordinates(const AbsorberPlaces            &places,
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
    DenseMatrix derivative(const AbsorberPlaces &places)
    {
      DenseMatrix T =
        DenseMatrix::Zero(places.n_coordinates(), places.n_coordinates());
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
    DenseMatrix springs_on(const DenseMatrix             &R,
                           const std::vector<Coordinate> &at)
    {
      const std::size_t c        = at.size();
      DenseMatrix       flexible = (R + R.transpose()) / 2,
                  springs        = DenseMatrix::Identity(c, c);
      for (std::size_t j = 0; j < c; ++j)
        flexible(j, j) += 1 / at[j].stiffness;
      if (!solve_positive_definite(flexible, springs))
        throw std::logic_error("Absorbers hang on a negative compliance.");
      return springs;
    }

    /** A value of each coordinate as a diagonal matrix. */
    template <class Value>
    Eigen::DiagonalMatrix<double, Eigen::Dynamic>
    diagonal(const std::vector<Coordinate> &at, const Value &value)
    {
      Eigen::DiagonalMatrix<double, Eigen::Dynamic> result(at.size());
      for (std::size_t k = 0; k < at.size(); ++k)
        result.diagonal()[k] = value(at[k]);
      return result;
    }

    double inverse_root_of_mass(const Coordinate &at)
    {
      return 1 / std::sqrt(at.mass);
    }
  } // namespace

  std::size_t AbsorberPlaces::n_coordinates() const
  {
    std::size_t sum = 0;
    for (const unsigned int D : diameters)
      sum += 2 * D + 1;
    return sum;
  }

  void hang_absorbers(const AbsorberPlaces            &places,
                      const std::vector<AbsorberRing> &rings,
                      const double                     rate,
                      DenseMatrix                     &K_m,
                      DenseMatrix                     &C_m)
  {
    const auto        at = coordinates(places, rings);
    const std::size_t c = at.size(), m = K_m.rows();
    if (c == 0)
      return;
    DenseMatrix elongation(c, m + c); // of the springs
    elongation << -places.motions,
      DenseMatrix(diagonal(at, inverse_root_of_mass));
    const DenseMatrix springs = springs_on(places.residual, at),
                      share =
                        diagonal(at,
                                 [](const Coordinate &at) {
                                   return std::sqrt(at.damping) / at.stiffness;
                                 }) *
                        springs, // of the dashpots: c k^-2 in two halves
      dashpots = share.transpose() * share, T = derivative(places);

    K_m.conservativeResizeLike(DenseMatrix::Zero(m + c, m + c));
    C_m.conservativeResizeLike(DenseMatrix::Zero(m + c, m + c));
    K_m += elongation.transpose() * springs * elongation;
    C_m += elongation.transpose() * dashpots * elongation;
    if (rate == 0.)
      return;
    K_m += rate * elongation.transpose() * dashpots * T * elongation;
    C_m.bottomRightCorner(c, c) += 2 * rate * T;
    K_m.bottomRightCorner(c, c) += rate * rate * T * T;
  }

  void join_absorbers(const AbsorberPlaces            &places,
                      const std::vector<AbsorberRing> &rings,
                      const DenseMatrix               &cross,
                      DenseMatrix                     &shapes,
                      DenseMatrix                     &residual)
  {
    const auto        at        = coordinates(places, rings);
    const DenseMatrix by_spring = cross * springs_on(places.residual, at);
    DenseMatrix       all(shapes.rows(), shapes.cols() + cross.cols());
    all << shapes - by_spring * places.motions,
      by_spring * diagonal(at, inverse_root_of_mass);
    shapes                   = std::move(all);
    const DenseMatrix softer = by_spring * cross.transpose();
    residual -= (softer + softer.transpose()) / 2;
  }

  std::vector<double> absorbers_at_rest(const AbsorberPlaces            &places,
                                        const std::vector<AbsorberRing> &rings,
                                        const std::vector<double>       &eta,
                                        const std::vector<double> &left_out)
  {
    const auto          at = coordinates(places, rings);
    std::vector<double> z  = sum(places.motions * eta, 1., left_out);
    for (std::size_t i = 0; i < z.size(); ++i)
      z[i] *= std::sqrt(at[i].mass);
    return z;
  }

  ComplexMatrix absorber_stiffness(const AbsorberPlaces            &places,
                                   const std::vector<AbsorberRing> &rings,
                                   const double                     rate,
                                   const std::complex<double>       s)
  {
    const auto    at = coordinates(places, rings);
    ComplexMatrix sigma =
      (rate * derivative(places)).cast<std::complex<double>>();
    sigma.diagonal().array() += s;
    ComplexMatrix g = sigma, free = sigma * sigma; // n m sigma^2 + g
    for (std::size_t j = 0; j < at.size(); ++j)
      {
        g.row(j) *= at[j].damping;
        g(j, j) += at[j].stiffness;
        free.row(j) *= at[j].mass;
      }
    free += g;
    ComplexMatrix follows = g;
    ComplexLU(std::move(free)).solve(follows);
    return g - g * follows;
  }

  ComplexMatrix receptances_with(const ComplexMatrix &alpha,
                                 const ComplexMatrix &Z,
                                 const std::size_t    n)
  {
    const std::size_t c      = Z.rows();
    ComplexMatrix     system = Z * alpha.bottomRightCorner(c, c),
                  force      = Z * alpha.bottomLeftCorner(c, n);
    system.diagonal().array() += 1.;
    ComplexLU(std::move(system)).solve(force);
    return alpha.topLeftCorner(n, n) - alpha.topRightCorner(n, c) * force;
  }

  double softening(const AbsorberPlaces            &places,
                   const std::vector<AbsorberRing> &rings)
  {
    const auto at      = coordinates(places, rings);
    double     largest = 0.;
    for (std::size_t i = 0; i < at.size(); ++i)
      largest = std::max(largest, at[i].stiffness * places.residual(i, i));
    return largest;
  }
} // namespace RollingContact
