#include <deal.II/base/numbers.h>

#include <rolling_contact/bodies/half_space_influence.h>

#include <cmath>

namespace RollingContact
{
  namespace
  {
    /**
     * ln(y + r), r^2 = x^2 + y^2, without cancellation; 0 where it is infinite,
     * as it has a factor there that is 0.
     */
    double ln_sum(const double y, const double x)
    {
      const double r = std::hypot(x, y);
      if (r == 0. || (y < 0. && x == 0.))
        return 0.;
      return y >= 0. ? std::log(y + r)
                     : 2 * std::log(std::abs(x)) - std::log(r - y);
    }

    /*
     * Kernels integrated twice along x and twice along y.
     */

    double of_inverse(const double x, const double y)
    {
      const double r = std::hypot(x, y);
      return 0.5 * x * y * y * ln_sum(x, y) + 0.5 * y * x * x * ln_sum(y, x) -
             r * r * r / 6;
    }

    double of_yy(const double x, const double y)
    {
      const double r = std::hypot(x, y);
      return r * r * r / 6 + 0.5 * x * x * (y * ln_sum(y, x) - r);
    }

    double of_xy(const double x, const double y)
    {
      const double r = std::hypot(x, y);
      return -(x * y * r / 3 + x * x * x * ln_sum(y, x) / 6 +
               y * y * y * ln_sum(x, y) / 6);
    }

    /**
     * x/r^2 is the real part of d/dx ln(x + i y): the real part of
     * -(x + i y)^3 ln(x + i y) / 6, with the angle between -pi/2 and pi/2,
     * whose jump at x = 0 the last term takes away.
     */
    double of_x(const double x, const double y)
    {
      const double r = std::hypot(x, y);
      if (r == 0. || x == 0.)
        return 0.;
      return -((x * x * x - 3 * x * y * y) * std::log(r) -
               (3 * x * x * y - y * y * y) * std::atan(y / x)) /
               6 +
             dealii::numbers::PI / 12 * std::copysign(std::abs(y * y * y), x);
    }

    /**
     * Influence of a hat, in parts of the kernels.
     */
    struct Hat
    {
      double inverse = 0., yy = 0., xy = 0., x = 0., y = 0.;

      Hat(const double                 at_x,
          const double                 at_y,
          const std::array<double, 2> &size)
      {
        const double areas = std::pow(size[0] * size[1], 2);
        for (const int i : {-1, 0, 1})
          for (const int j : {-1, 0, 1})
            {
              const double weight =
                             (i == 0 ? -2 : 1) * (j == 0 ? -2 : 1) / areas,
                           corner_x = at_x + i * size[0],
                           corner_y = at_y + j * size[1];
              inverse += weight * of_inverse(corner_x, corner_y);
              yy += weight * of_yy(corner_x, corner_y);
              xy += weight * of_xy(corner_x, corner_y);
              x += weight * of_x(corner_x, corner_y);
              y += weight * of_x(corner_y, corner_x);
            }
      }
    };
  } // namespace

  Eigen::Matrix3d HalfSpaceInfluence::at(const double x, const double y) const
  {
    const Hat    hat(x, y, size);
    const double nu = material.poisson_ratio,
                 k  = 1 / (2 * dealii::numbers::PI * material.shear_modulus()),
                 coupling = k / 2 * (1 - 2 * nu);
    Eigen::Matrix3d W;
    W << k * (hat.inverse - nu * hat.yy), k * nu * hat.xy, coupling * hat.x, //
      k * nu * hat.xy, k * ((1 - nu) * hat.inverse + nu * hat.yy),
      coupling * hat.y, //
      -coupling * hat.x, -coupling * hat.y, k * (1 - nu) * hat.inverse;
    return W;
  }

  InfluenceTable
  HalfSpaceInfluence::table(const std::array<std::size_t, 2> &n,
                            const std::vector<unsigned int>  &components) const
  {
    return InfluenceTable(n, [&](const int i, const int j) {
      return DenseMatrix(at(i * size[0], j * size[1])(components, components));
    });
  }
} // namespace RollingContact
