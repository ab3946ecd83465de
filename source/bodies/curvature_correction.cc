#include <deal.II/base/quadrature_lib.h>

#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/bodies/bulk_errors.h>
#include <rolling_contact/bodies/curvature_correction.h>
#include <rolling_contact/bodies/half_space_influence.h>
#include <rolling_contact/bodies/moment_fields.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace RollingContact
{
  namespace
  {
    /**
     * Half of the elements across the patch of the grid on which smooth loads
     * are, and points of the rings around it.
     */
    const int          elements_of_half  = 8;
    const unsigned int points_along_ring = 48, rings = 12;

    using OfLoads = Eigen::RowVectorXd; ///< a value for each load

    /**
     * The surface of a half-space at a point under several loads: tractions,
     * strains along the surface and slopes of it. Units: Pa, 1.
     */
    struct SurfaceState
    {
      std::array<OfLoads, 3> t;
      OfLoads                xx, yy, xy, slope_x, slope_y;
    };

    /**
     * The integrand of curvature_correction() over h.
     */
    DenseMatrix work(const SurfaceState &at, const Material &material)
    {
      const double  G = material.shear_modulus(), nu = material.poisson_ratio;
      const OfLoads sum     = at.xx + at.yy,
                    common  = nu / (1 - nu) * (2 * G * sum + at.t[2]),
                    stretch = ((1 - 2 * nu) / (2 * G) * at.t[2] - nu * sum) /
                              (1 - nu); // u_z,z
      DenseMatrix result = at.t[2].transpose() * stretch;
      result -= (2 * G * at.xx + common).transpose() * at.xx;
      result -= (2 * G * at.yy + common).transpose() * at.yy;
      result -= 4 * G * at.xy.transpose() * at.xy;
      for (const auto &[t, slope] :
           {std::pair(&at.t[0], &at.slope_x), std::pair(&at.t[1], &at.slope_y)})
        {
          result += t->transpose() * (*t / G - *slope);
          result -= slope->transpose() * *t;
        }
      return result;
    }

    /**
     * SmoothForces on the nodes of a grid around the contact point, combined to
     * one for each of force_moments() that has no other of these.
     */
    class SmoothLoads
    {
    public:
      /**
       * @p reach is how far from the contact point displacements are asked for.
       * Units: m.
       */
      SmoothLoads(const Material              &material,
                  const std::array<double, 2> &half_widths,
                  const double                 reach);

      /**
       * What the surface is like at a point of the grid.
       */
      SurfaceState at(const int i, const int j) const;

      std::array<double, 2> size; ///< of elements, m
      std::array<int, 2>    last; ///< points of the grid within reach

    private:
      using Values = Eigen::Matrix<double, 3, Eigen::Dynamic>;

      struct Node
      {
        int    i, j;
        Values force; ///< component by load, N
      };

      void make_nodes();

      Values displacements(const int i, const int j) const;

      const std::size_t   n;
      InfluenceTable      influence;
      std::vector<Node>   nodes;
      std::vector<Values> found; ///< displacements on the grid
    };

    std::array<double, 2> elements_of(const std::array<double, 2> &half_widths)
    {
      return {
        {half_widths[0] / elements_of_half, half_widths[1] / elements_of_half}};
    }

    std::array<int, 2> reached(const std::array<double, 2> &size,
                               const double                 reach)
    {
      return {
        {int(std::ceil(reach / size[0])), int(std::ceil(reach / size[1]))}};
    }

    SmoothLoads::SmoothLoads(const Material              &material,
                             const std::array<double, 2> &half_widths,
                             const double                 reach)
      : size(elements_of(half_widths))
      , last(reached(size, reach))
      , n(force_moments().size())
      , influence(HalfSpaceInfluence(material, size)
                    .table({{last[0] + 2u + elements_of_half,
                             last[1] + 2u + elements_of_half}},
                           {0, 1, 2}))
    {
      make_nodes();
      for (int i = -last[0] - 1; i <= last[0] + 1; ++i)
        for (int j = -last[1] - 1; j <= last[1] + 1; ++j)
          found.push_back(displacements(i, j));
    }

    void SmoothLoads::make_nodes()
    {
      const int                   half = elements_of_half;
      SmoothForces::Positions     positions;
      const std::array<double, 2> half_widths{{half * size[0], half * size[1]}};
      for (int i = 1 - half; i < half; ++i)
        for (int j = 1 - half; j < half; ++j)
          if (i * i + j * j < half * half)
            {
              nodes.push_back({i, j, Values(3, n)});
              positions.push_back({{i * size[0], j * size[1]}});
            }
      const std::size_t  N = nodes.size();
      const SmoothForces smooth(
        positions, std::vector<double>(N, 1.), half_widths, 3, 2);
      DenseMatrix forces(3 * N, n);
      for (std::size_t k = 0; k < n; ++k)
        forces.col(k) =
          Eigen::Map<const Eigen::VectorXd>(smooth.forces()[k].data(), 3 * N);
      DenseMatrix moments =
        shapes_of_moments(positions, {0, 1, 2}).transpose() * forces;
      DenseMatrix to_moments = DenseMatrix::Identity(n, n);
      if (!solve_general(moments, to_moments))
        throw std::logic_error("Smooth loads of the curvature are alike.");
      forces *= to_moments;
      for (std::size_t i = 0; i < N; ++i)
        for (unsigned int c = 0; c < 3; ++c)
          nodes[i].force.row(c) = forces.row(c * N + i);
    }

    SmoothLoads::Values SmoothLoads::displacements(const int i,
                                                   const int j) const
    {
      Values u = Values::Zero(3, n);
      for (const Node &node : nodes)
        {
          Eigen::Matrix3d W;
          for (unsigned int of = 0; of < 3; ++of)
            for (unsigned int by = 0; by < 3; ++by)
              W(of, by) = influence(i - node.i, j - node.j, of, by);
          u.noalias() += W * node.force;
        }
      return u;
    }

    SurfaceState SmoothLoads::at(const int i, const int j) const
    {
      const auto u = [&](const int k, const int l) -> const Values & {
        return found[(k + last[0] + 1) * (2 * last[1] + 3) + l + last[1] + 1];
      };
      const Values along_x = (u(i + 1, j) - u(i - 1, j)) / (2 * size[0]),
                   along_y = (u(i, j + 1) - u(i, j - 1)) / (2 * size[1]);
      SurfaceState state{{OfLoads::Zero(n), OfLoads::Zero(n), OfLoads::Zero(n)},
                         along_x.row(0),
                         along_y.row(1),
                         (along_x.row(1) + along_y.row(0)) / 2,
                         along_x.row(2),
                         along_y.row(2)};
      for (const Node &node : nodes)
        if (node.i == i && node.j == j)
          for (unsigned int c = 0; c < 3; ++c)
            state.t[c] = node.force.row(c) / (size[0] * size[1]);
      return state;
    }

    /**
     * The integrand over h away from all loads, at a point.
     */
    DenseMatrix faded_work(const std::array<double, 2> &at,
                           const FadingRegion          &fading,
                           const Material              &material)
    {
      const auto fields =
        moment_fields(dealii::Point<3>(at[0], at[1], 0.), material);
      const std::size_t n = fields.size();
      SurfaceState state{{OfLoads::Zero(n), OfLoads::Zero(n), OfLoads::Zero(n)},
                         OfLoads(n),
                         OfLoads(n),
                         OfLoads(n),
                         OfLoads(n),
                         OfLoads(n)};
      std::array<OfLoads, 2> u{{OfLoads(n), OfLoads(n)}};
      for (std::size_t m = 0; m < n; ++m)
        {
          const auto &gradient = fields[m].gradient;
          state.xx[m]          = gradient[0][0];
          state.yy[m]          = gradient[1][1];
          state.xy[m]          = (gradient[0][1] + gradient[1][0]) / 2;
          state.slope_x[m]     = gradient[2][0];
          state.slope_y[m]     = gradient[2][1];
          u[0][m]              = fields[m].value[0];
          u[1][m]              = fields[m].value[1];
        }
      const double r = std::hypot(at[0], at[1]), chi = fading.at(r),
                   G = material.shear_modulus(), nu = material.poisson_ratio,
                   share = fading.first_order_at(r),
                   // of share chi^2 along the distance
        along = 2 * share * chi * fading.slope(r) +
                chi * chi * fading.first_order_slope(r),
                   slope_x = along * at[0] / r, slope_y = along * at[1] / r;
      const OfLoads common  = 2 * G * nu / (1 - nu) * (state.xx + state.yy),
                    along_x = slope_x * (2 * G * state.xx + common) +
                              slope_y * 2 * G * state.xy,
                    along_y = slope_x * 2 * G * state.xy +
                              slope_y * (2 * G * state.yy + common);
      return share * chi * chi * work(state, material) -
             (u[0].transpose() * along_x + u[1].transpose() * along_y);
    }

    /**
     * The integral over h away from all loads, between two distances.
     */
    DenseMatrix work_of_rings(const BodyShape    &shape,
                              const Material     &material,
                              const FadingRegion &fading,
                              const double        from,
                              const double        to)
    {
      const std::size_t       n   = force_moments().size();
      DenseMatrix             sum = DenseMatrix::Zero(n, n);
      const dealii::QGauss<1> along(rings);
      for (unsigned int k = 0; k < rings; ++k)
        for (unsigned int l = 0; l < points_along_ring; ++l)
          {
            const double r = from + along.point(k)[0] * (to - from),
                         angle =
                           2 * dealii::numbers::PI * l / points_along_ring,
                         area = along.weight(k) * (to - from) * 2 *
                                dealii::numbers::PI * r / points_along_ring,
                         x = r * std::cos(angle), y = r * std::sin(angle);
            sum += shape.height_as_made(x, y) * area *
                   faded_work({{x, y}}, fading, material);
          }
      return sum;
    }
  } // namespace

  DenseMatrix curvature_correction(const BodyShape             &shape,
                                   const Material              &material,
                                   const std::array<double, 2> &half_widths,
                                   const FadingRegion          &fading,
                                   const double                 grid_reach)
  {
    const std::size_t n   = force_moments().size();
    DenseMatrix       sum = DenseMatrix::Zero(n, n);
    const double      reach =
      std::min(fading.inner,
               grid_reach * std::max(half_widths[0], half_widths[1]));
    const SmoothLoads loads(material, half_widths, reach);
    for (int i = -loads.last[0]; i <= loads.last[0]; ++i)
      for (int j = -loads.last[1]; j <= loads.last[1]; ++j)
        {
          const double x = i * loads.size[0], y = j * loads.size[1];
          if (std::hypot(x, y) < reach)
            sum += shape.height_as_made(x, y) * loads.size[0] * loads.size[1] *
                   work(loads.at(i, j), material);
        }
    const double outer = fading.first_order().outer;
    for (double from = reach, to; from < outer; from = to)
      {
        to = from < fading.inner ? std::min(2 * from, fading.inner) : outer;
        sum += work_of_rings(shape, material, fading, from, to);
      }
    return (sum + sum.transpose()) / 2;
  }
} // namespace RollingContact
