#include <rolling_contact/bodies/energy_errors.h>
#include <rolling_contact/contact/operators.h>
#include <rolling_contact/pair/rolling_pair.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  template <int dim>
  void RollingPair<dim>::prepare_bulk_errors()
  {
    errors = {};
    // stresses jump at a cover, and no average of them is better
    if (!demands.bulk_errors || scene.has_covers() ||
        body_pair.body_solver() != BodySolver::direct)
      return;
    std::array<double, 2> reach{};
    for (const auto &node : trace().nodes)
      for (unsigned int d = 0; d < dim - 1; ++d)
        reach[d] = std::max(reach[d], std::abs(node[d]));
    const SparseRows H =
      contact_matrix(trace(), ContactMatrices::lumped, scene.thickness());
    const std::vector<double> areas =
      H.multiply(std::vector<double>(H.size(), 1.));
    errors.smooth = SmoothForces(trace().nodes,
                                 areas,
                                 reach,
                                 components.size(),
                                 body_pair.is_split() ? 2 : 1);
  }

  template <int dim>
  DenseMatrix RollingPair<dim>::bulk_errors_of(const Side side) const
  {
    ElasticBody<dim> &body = *body_pair.body(side);
    if (errors.smooth.forces().empty())
      return {};
    std::vector<std::vector<double>> forces;
    for (const std::vector<double> &load : errors.smooth.forces())
      forces.push_back(forces_on_body(side, load));
    std::vector<DenseMatrix> parts =
      body.compliance_errors(pair_interface.nodes[side], components, forces);
    if (parts.empty())
      parts = energy_errors(body,
                            scene.thickness(),
                            element_size,
                            displacements(side, errors.smooth.forces()));
    if (!demands.whole_bodies())
      body.release_factor();
    const std::size_t n = errors.smooth.forces().size();
    DenseMatrix       all(n, n * parts.size());
    for (std::size_t m = 0; m < parts.size(); ++m)
      all.middleCols(m * n, n) = parts[m];
    return all;
  }

  namespace
  {
    /**
     * Errors of the rail of twins as those of the wheel or the other way round:
     * tangential forces and displacements are opposite.
     */
    DenseMatrix mirrored(DenseMatrix part, const std::size_t n_normal)
    {
      const std::size_t n = part.rows(), n_tangential = n - n_normal;
      part.topRightCorner(n_tangential, n_normal) *= -1;
      part.bottomLeftCorner(n_normal, n_tangential) *= -1;
      return part;
    }
  } // namespace

  template <int dim>
  void RollingPair<dim>::add_bulk_errors(PerSide<DenseMatrix> of_bodies)
  {
    const std::size_t n = errors.smooth.forces().size();
    if (n == 0)
      return;
    for (const Side side : both_sides)
      {
        DenseMatrix &parts = of_bodies[side];
        if (!body_pair.has_own_body(side))
          continue;
        Ranks::broadcast(parts, body_pair.rank_of(side));
        for (std::size_t m = 0; m * n < std::size_t(parts.cols()); ++m)
          {
            if (m == errors.parts.size())
              errors.parts.push_back(DenseMatrix::Zero(n, n));
            const DenseMatrix part = parts.middleCols(m * n, n);
            errors.parts[m] += part;
            if (body_pair.twins())
              errors.parts[m] += mirrored(part, n / components.size());
          }
      }
  }

  template void        RollingPair<2>::prepare_bulk_errors();
  template void        RollingPair<3>::prepare_bulk_errors();
  template DenseMatrix RollingPair<2>::bulk_errors_of(const Side) const;
  template DenseMatrix RollingPair<3>::bulk_errors_of(const Side) const;
  template void        RollingPair<2>::add_bulk_errors(PerSide<DenseMatrix>);
  template void        RollingPair<3>::add_bulk_errors(PerSide<DenseMatrix>);
} // namespace RollingContact
