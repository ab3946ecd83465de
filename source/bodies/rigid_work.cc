#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/mapping_q1.h>

#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/bodies/moment_fields.h>
#include <rolling_contact/bodies/rigid_work.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    const unsigned int n_motions = 6; ///< along x, y, z and about them

    Tensor<1, 3> rigid_motion(const unsigned int motion, const Point<3> &point)
    {
      Tensor<1, 3> axis;
      axis[motion % 3] = 1.;
      return motion < 3 ? axis : cross_product_3d(axis, Tensor<1, 3>(point));
    }

    /**
     * Volume around each node, weighted by a bump that ends at a distance.
     */
    std::vector<double> weights(const DoFHandler<3>         &dofs,
                                const std::vector<Point<3>> &positions,
                                const double                 end)
    {
      std::vector<double>                  result(positions.size(), 0.);
      std::vector<types::global_dof_index> numbers(dofs.get_fe().dofs_per_cell);
      for (const auto &cell : dofs.active_cell_iterators())
        {
          if (cell->center().norm() - cell->diameter() / 2 > end)
            continue;
          cell->get_dof_indices(numbers);
          for (const auto i : numbers)
            {
              const double t = std::min(1., positions[i].norm() / end);
              result[i] += cell->measure() * std::pow(1 - t * t, 2);
            }
        }
      return result;
    }

    /**
     * Second derivatives of the surface's height along x, across both and along
     * y, over a distance. Units: 1/m.
     */
    std::array<double, 3> height_derivatives(const BodyShape &shape,
                                             const double     step)
    {
      const auto h = [&](const double x, const double y) {
        return shape.height_as_made(x * step, y * step);
      };
      const double square = step * step;
      return {{(h(1, 0) + h(-1, 0)) / square,
               (h(1, 1) + h(-1, -1) - h(1, -1) - h(-1, 1)) / (4 * square),
               (h(0, 1) + h(0, -1)) / square}};
    }

    /**
     * The work of each moment on each rigid motion.
     */
    DenseMatrix exact_work(const std::array<double, 3> &height)
    {
      const auto &moments = force_moments();
      DenseMatrix work    = DenseMatrix::Zero(n_motions, moments.size());
      for (std::size_t k = 0; k < moments.size(); ++k)
        {
          // the value that the moment takes of 1, x, y and the height
          const auto [c, i, j] = moments[k];
          const bool   along_x = i == 1 && j == 0, along_y = i == 0 && j == 1;
          const double z = i + j == 2 ? height[j] : 0.;
          if (i + j == 0)
            work(c, k) = 1.;
          work(3, k) = c == 1 ? -z : c == 2 ? double(along_y) : 0.;
          work(4, k) = c == 0 ? z : c == 2 ? -double(along_x) : 0.;
          work(5, k) = c == 0   ? -double(along_y)
                       : c == 1 ? double(along_x)
                                : 0.;
        }
      return work;
    }
  } // namespace

  DenseMatrix missing_rigid_work(const DirectBody<3> &body,
                                 const BodyShape     &shape,
                                 const FadingRegion  &fading,
                                 const DenseMatrix   &F)
  {
    const auto           &dofs = body.dof_handler();
    std::vector<Point<3>> positions(dofs.n_dofs());
    DoFTools::map_dofs_to_support_points(MappingQ1<3>(), dofs, positions);
    const auto  weight = weights(dofs, positions, fading.outer);
    DenseMatrix motions(body.n_unknowns(), n_motions), loads = motions;
    for (unsigned int motion = 0; motion < n_motions; ++motion)
      {
        BodyField u    = body.field(std::vector<double>(body.n_unknowns(), 0.));
        BodyField load = u;
        for (std::size_t i = 0; i < positions.size(); ++i)
          {
            u[i]    = rigid_motion(motion, positions[i])[i % 3];
            load[i] = weight[i] * u[i];
          }
        motions.col(motion) = as_vector(body.unknowns_of(u));
        loads.col(motion)   = as_vector(body.unknowns_of(load));
      }
    const double third  = fading.inner / 3;
    DenseMatrix  matrix = motions.transpose() * loads,
                missing = exact_work(height_derivatives(shape, third)) -
                          motions.transpose() * F;
    if (!solve_general(matrix, missing))
      throw std::logic_error("Rigid motions of a body are alike.");
    return loads * missing;
  }
} // namespace RollingContact
