#include <deal.II/base/numbers.h>

#include <rolling_contact/bodies/moment_fields.h>

#include <cmath>

namespace RollingContact
{
  namespace
  {
    const unsigned int highest_degree = 2;

    /**
     * A function of (x, y, z) about a point as its Taylor polynomial, of degree
     * highest_degree + 1 in all and 1 in z, which has the derivatives that
     * gradients of moments are made of.
     */
    class Taylor
    {
    public:
      /** The constant @p value, with slopes along x, y and z. */
      Taylor(const double value, const std::array<double, 3> &slopes = {})
      {
        c[index(0, 0, 0)] = value;
        c[index(1, 0, 0)] = slopes[0];
        c[index(0, 1, 0)] = slopes[1];
        c[index(0, 0, 1)] = slopes[2];
      }

      double derivative(const unsigned int x,
                        const unsigned int y,
                        const unsigned int z) const
      {
        const std::array<double, 4> factorial{{1., 1., 2., 6.}};
        return factorial[x] * factorial[y] * c[index(x, y, z)];
      }

      double value() const
      {
        return c[0];
      }

      friend Taylor operator+(Taylor a, const Taylor &b)
      {
        for (unsigned int k = 0; k < size; ++k)
          a.c[k] += b.c[k];
        return a;
      }

      friend Taylor operator-(Taylor a, const Taylor &b)
      {
        for (unsigned int k = 0; k < size; ++k)
          a.c[k] -= b.c[k];
        return a;
      }

      friend Taylor operator*(const double a, Taylor b)
      {
        for (double &coefficient : b.c)
          coefficient *= a;
        return b;
      }

      friend Taylor operator*(const Taylor &a, const Taylor &b)
      {
        Taylor product(0.);
        for (const Term &term : terms())
          product.c[term.of] += a.c[term.left] * b.c[term.right];
        return product;
      }

    private:
      static constexpr unsigned int n = highest_degree + 2, size = 2 * n * n;

      struct Term
      {
        unsigned int of, left, right;
      };

      static constexpr unsigned int
      index(const unsigned int x, const unsigned int y, const unsigned int z)
      {
        return (z * n + y) * n + x;
      }

      /**
       * The products of powers that are not of too high a degree.
       */
      static const std::vector<Term> &terms()
      {
        static const std::vector<Term> all = []() {
          std::vector<Term> found;
          for (unsigned int a = 0; a < size; ++a)
            for (unsigned int b = 0; b < size; ++b)
              {
                const unsigned int x = a % n + b % n, y = a / n % n + b / n % n,
                                   z = a / (n * n) + b / (n * n);
                if (z < 2 && x + y + z < n)
                  found.push_back({index(x, y, z), a, b});
              }
          return found;
        }();
        return all;
      }

      std::array<double, size> c{};
    };

    /**
     * 1/a: Newton's method doubles the number of right derivatives.
     */
    Taylor inverse(const Taylor &a)
    {
      Taylor x(1 / a.value());
      for (unsigned int round = 0; round < 2; ++round)
        x = x * (Taylor(2.) - a * x);
      return x;
    }

    Taylor inverse_root(const Taylor &a)
    {
      Taylor x(1 / std::sqrt(a.value()));
      for (unsigned int round = 0; round < 2; ++round)
        x = 0.5 * (x * (Taylor(3.) - a * (x * x)));
      return x;
    }

    using Forces = std::array<std::array<Taylor, 3>, 3>; // [force][component]

    /**
     * Displacements by unit forces at the origin along x, y and out of the
     * body, over 1/(4 pi G).
     */
    Forces point_forces(const dealii::Point<3> &point,
                        const double            poisson_ratio)
    {
      const double m = 1 - 2 * poisson_ratio;
      const Taylor x(point[0], {{1., 0., 0.}}), y(point[1], {{0., 1., 0.}}),
        depth(-point[2], {{0., 0., -1.}});
      const Taylor xx = x * x, yy = y * y, zz = depth * depth,
                   square = xx + yy + zz, over_R = inverse_root(square),
                   over_R3  = over_R * over_R * over_R,
                   over_sum = inverse(square * over_R + depth),
                   of_sum   = m * (over_R * over_sum),
                   of_both  = over_R3 - of_sum * over_sum,
                   along = over_R + m * over_sum, mixed = x * y * of_both,
                   sheared = depth * over_R3, down = -1. * (sheared + of_sum),
                   up = of_sum - sheared;
      return {
        {{{along + xx * of_both, mixed, x * down}},
         {{mixed, along + yy * of_both, y * down}},
         {{x * up, y * up, zz * over_R3 + 2 * (1 - poisson_ratio) * over_R}}}};
    }

    double power_over_factorial(const double x, const unsigned int n)
    {
      return n == 0 ? 1. : x / n * power_over_factorial(x, n - 1);
    }
  } // namespace

  double ForceMoment::shape(const double x, const double y) const
  {
    return power_over_factorial(x, i) * power_over_factorial(y, j);
  }

  const std::vector<ForceMoment> &force_moments()
  {
    static const std::vector<ForceMoment> moments = []() {
      std::vector<ForceMoment> all;
      for (unsigned int degree = 0; degree <= highest_degree; ++degree)
        for (unsigned int j = 0; j <= degree; ++j)
          for (unsigned int component = 0; component < 3; ++component)
            all.push_back({component, degree - j, j});
      return all;
    }();
    return moments;
  }

  DenseMatrix
  shapes_of_moments(const std::vector<std::array<double, 2>> &positions,
                    const std::vector<unsigned int>          &components)
  {
    const auto       &moments = force_moments();
    const std::size_t N       = positions.size();
    DenseMatrix Phi = DenseMatrix::Zero(components.size() * N, moments.size());
    for (std::size_t m = 0; m < moments.size(); ++m)
      for (std::size_t c = 0; c < components.size(); ++c)
        if (components[c] == moments[m].component)
          for (std::size_t i = 0; i < N; ++i)
            Phi(c * N + i, m) =
              moments[m].shape(positions[i][0], positions[i][1]);
    return Phi;
  }

  std::vector<DisplacementField> moment_fields(const dealii::Point<3> &point,
                                               const Material         &material)
  {
    const Forces forces = point_forces(point, material.poisson_ratio);
    const double scale =
      1 / (4 * dealii::numbers::PI * material.shear_modulus());
    std::vector<DisplacementField> fields(force_moments().size());
    for (std::size_t m = 0; m < fields.size(); ++m)
      {
        const ForceMoment &moment = force_moments()[m];
        // a force moved by +x is a point moved by -x
        const double factor = moment.degree() % 2 == 0 ? scale : -scale;
        for (unsigned int k = 0; k < 3; ++k)
          {
            const Taylor &u          = forces[moment.component][k];
            const auto    derivative = [&](const unsigned int along_x,
                                        const unsigned int along_y,
                                        const unsigned int along_z) {
              return factor * u.derivative(moment.i + along_x,
                                           moment.j + along_y,
                                           along_z);
            };
            fields[m].value[k]       = derivative(0, 0, 0);
            fields[m].gradient[k][0] = derivative(1, 0, 0);
            fields[m].gradient[k][1] = derivative(0, 1, 0);
            fields[m].gradient[k][2] = derivative(0, 0, 1);
          }
      }
    return fields;
  }
} // namespace RollingContact
