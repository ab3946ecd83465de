#include <rolling_contact/base/text.h>
#include <rolling_contact/bodies/curvature_correction.h>
#include <rolling_contact/bodies/half_space_influence.h>
#include <rolling_contact/bodies/moment_fields.h>
#include <rolling_contact/bodies/split_body.h>
#include <rolling_contact/bodies/split_vibration.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace RollingContact
{
  namespace
  {
    /**
     * Elements over the radius within which the half-space fades out, seven of
     * them where it does if loads leave room for that. Those of the second mesh
     * are twice as large, which makes its cells those of the first put
     * together.
     */
    const double elements_of_radius = 10., coarser = 2.;

    /**
     * Elements over that radius of bodies with cells of their own, which are
     * halved until they are smaller: on average as small as those of others.
     */
    const double elements_of_own_cells = 7.;

    /**
     * Growth of the elements away from there, and in true sections, whose cells
     * are many as it is.
     */
    const double growth = 0.8, growth_of_sections = 1.5;

    /**
     * The region within which the half-space fades out in the second set of
     * fields of a true section, over that of the first: cells are larger beside
     * it, as those of a coarser mesh would be.
     */
    const double smaller = 0.7;

    /**
     * Half-widths of the patch for which both are compared, over the inner
     * radius. Loads on it are within the smaller region.
     */
    const double compared_patch = 0.25;

    /**
     * What second order in the curvature may add, over what first order does.
     */
    const double of_second_order_in_curvature = 1. / 3;

    /**
     * Factor of the errors where the fading region passes edges of true
     * sections: forces on 24 to 40 elements differed from those of finite
     * elements by up to twice the error without it.
     */
    const double beyond_edges = 2.5;

    /**
     * Elements alike around the contact point and larger ones beyond, which do
     * not know the patch.
     */
    Grading<3> grading_of(const BodyShape    &shape,
                          const FadingRegion &fading,
                          const double        larger)
    {
      Grading<3> grading;
      grading.element_size_x = grading.element_size_y =
        larger * fading.outer /
        (shape.has_own_cells() ? elements_of_own_cells : elements_of_radius);
      grading.zone_x = grading.zone_y = grading.zone_depth = fading.outer / 2;
      grading.growth   = fading.may_be_steep() ? growth_of_sections : growth;
      grading.is_alone = true;
      return grading;
    }

    /**
     * Half-widths of the patch over how far the nodes that may touch reach.
     */
    const double patch_over_nodes = 0.85;

    using Positions = std::vector<std::array<double, 2>>;

    Positions
    positions_of(const std::vector<ElasticBody<3>::SurfaceNode> &nodes)
    {
      Positions positions;
      for (const auto &node : nodes)
        positions.push_back({{node.position[0], node.position[1]}});
      return positions;
    }

    /**
     * The grid that the nodes are on: distances of neighbours, half-widths of
     * the patch on it, and how far the farthest node is. Units: m.
     */
    struct NodeGrid
    {
      explicit NodeGrid(const Positions &positions)
      {
        for (unsigned int d = 0; d < 2; ++d)
          {
            std::vector<double> at;
            for (const auto &position : positions)
              at.push_back(position[d]);
            std::sort(at.begin(), at.end());
            const double all = at.back() - at.front();
            element_size[d]  = all;
            half_widths[d]   = patch_over_nodes * all / 2;
            for (std::size_t i = 1; i < at.size(); ++i)
              if (const double step = at[i] - at[i - 1]; step > 1e-6 * all)
                element_size[d] = std::min(element_size[d], step);
          }
        for (const auto &[x, y] : positions)
          farthest = std::max(farthest, std::hypot(x, y));
      }

      std::array<double, 2> element_size, half_widths;
      double                farthest = 0.;
    };

    /**
     * Moments of several sets of nodal forces, by columns.
     */
    DenseMatrix moments_of(const Positions                        &positions,
                           const std::vector<unsigned int>        &components,
                           const std::vector<std::vector<double>> &forces)
    {
      DenseMatrix f(components.size() * positions.size(), forces.size());
      for (std::size_t k = 0; k < forces.size(); ++k)
        f.col(k) = as_vector(forces[k]);
      return shapes_of_moments(positions, components).transpose() * f;
    }

    /**
     * Moments of displacement under moments of force, by work alone.
     */
    DenseMatrix moments_of(DirectBody<3> &body, const FadedFields &fields)
    {
      return fields.F.transpose() * body.solve(fields.F) + fields.Q;
    }

    /**
     * How the moments @p of_mesh change where the half-space fades out nearer
     * to the contact, on the same mesh, extrapolated: nothing if the body is
     * resolved.
     */
    DenseMatrix change_of_region(DirectBody<3>      &body,
                                 const BodyShape    &shape,
                                 const FadingRegion &fading,
                                 const DenseMatrix  &of_mesh)
    {
      const FadingRegion nearer{smaller * fading.inner,
                                smaller * fading.outer,
                                smaller * fading.steep_from};
      const double       half_width     = compared_patch * fading.inner;
      const auto         with_curvature = [&](const FadingRegion &region,
                                      const DenseMatrix  &moments) {
        return DenseMatrix(moments +
                           curvature_correction(shape,
                                                body.elasticity().core,
                                                {{half_width, half_width}},
                                                region));
      };
      return (with_curvature(fading, of_mesh) -
              with_curvature(
                nearer, moments_of(body, FadedFields(body, shape, nearer)))) /
             (1 / (smaller * smaller) - 1);
    }
  } // namespace

  SplitBody::SplitBody(const std::shared_ptr<const BodyShape> &shape,
                       const Material                         &material,
                       const FadingRegion                     &fading,
                       const BodyModel                        &model,
                       const bool                              vibrates,
                       const bool                              is_half_space)
    : DirectBody<3>(shape,
                    material,
                    1.,
                    grading_of(*shape, fading, is_half_space ? coarser : 1.),
                    vibrates,
                    model)
    , shape(shape)
    , fading(fading)
    , vibrates(vibrates)
    , is_half_space(is_half_space)
  {}

  void SplitBody::analyse()
  {
    if (S_of_mesh.size() > 0 || is_half_space)
      return;
    FadedFields of_mesh(*this, *shape, fading);
    S_of_mesh = moments_of(*this, of_mesh);
    if (fading.may_be_steep())
      change = change_of_region(*this, *shape, fading, S_of_mesh);
    else
      {
        DirectBody<3> larger(shape,
                             materials,
                             1.,
                             grading_of(*shape, fading, coarser),
                             true,
                             model);
        change = (S_of_mesh -
                  moments_of(larger, FadedFields(larger, *shape, fading))) /
                 (coarser * coarser - 1);
      }
    if (vibrates)
      {
        fields  = std::move(of_mesh);
        inertia = FadedInertia(*this, fading);
      }
    else
      release_factor();
  }

  DenseMatrix SplitBody::compliance(const std::vector<SurfaceNode>  &nodes,
                                    const std::vector<unsigned int> &components,
                                    const SparseRows                &P)
  {
    if (P.size() > 0)
      throw std::logic_error("A split body has the nodes of the interface.");
    analyse();
    return influence_on(positions_of(nodes), components).dense();
  }

  std::optional<GridInfluence>
  SplitBody::grid_influence(const std::vector<SurfaceNode>  &nodes,
                            const std::vector<unsigned int> &components)
  {
    if (vibrates)
      return {};
    analyse();
    return influence_on(positions_of(nodes), components);
  }

  GridInfluence
  SplitBody::influence_on(const Positions                 &positions,
                          const std::vector<unsigned int> &components) const
  {
    const NodeGrid    grid(positions);
    const NodesOnGrid nodes = nodes_on_grid(positions, grid.element_size);
    const std::size_t n     = force_moments().size();
    GridInfluence     influence{
      nodes,
      HalfSpaceInfluence(materials.core, grid.element_size)
        .table({{nodes.n[0] + 2, nodes.n[1] + 2}}, components),
      shapes_of_moments(positions, components).transpose(),
      DenseMatrix::Zero(n, n),
      {},
      {}};
    if (!is_half_space)
      influence.of_shapes =
        S_of_mesh + change +
        curvature_correction(*shape, materials.core, grid.half_widths, fading);
    for (const ForceMoment &moment : force_moments())
      {
        influence.shape_is_normal.push_back(moment.component == 2);
        influence.shape_is_no_strain.push_back(moment.degree() == 0);
      }
    return influence;
  }

  std::vector<DenseMatrix> SplitBody::compliance_errors(
    const std::vector<SurfaceNode>         &nodes,
    const std::vector<unsigned int>        &components,
    const std::vector<std::vector<double>> &forces) const
  {
    if (is_half_space)
      return {DenseMatrix::Zero(forces.size(), forces.size())};
    const auto        positions = positions_of(nodes);
    const DenseMatrix moments   = moments_of(positions, components, forces),
                      of_curvature =
                        curvature_correction(*shape,
                                             materials.core,
                                             NodeGrid(positions).half_widths,
                                             fading);
    DenseMatrix highest = S_of_mesh + change;
    const auto &all     = force_moments();
    for (std::size_t k = 0; k < all.size(); ++k)
      for (std::size_t l = 0; l < all.size(); ++l)
        if (all[k].degree() < 2 && all[l].degree() < 2)
          highest(k, l) = 0.;
    const double factor = fading.may_be_steep() ? beyond_edges : 1.;
    const auto   work   = [&](const DenseMatrix &of_moments) {
      return DenseMatrix(factor * moments.transpose() * of_moments * moments);
    };
    return {work(change),
            work(NodeGrid(positions).farthest / fading.outer * highest),
            work(of_second_order_in_curvature * of_curvature)};
  }

  void SplitBody::require_vibrating() const
  {
    if (!vibrates)
      throw std::logic_error("Of this split body only the contact is known.");
  }

  std::vector<BodyField>
  SplitBody::recover(const std::vector<SurfaceNode>         &nodes,
                     const std::vector<unsigned int>        &components,
                     const std::vector<std::vector<double>> &forces)
  {
    require_vibrating();
    const DenseMatrix m = moments_of(positions_of(nodes), components, forces),
                      x = solve(fields.F * m) + inertia.at_nodes * m;
    std::vector<BodyField> displacements;
    for (std::size_t k = 0; k < forces.size(); ++k)
      displacements.push_back(field(column_of(x, k)));
    return displacements;
  }

  std::unique_ptr<ContactVibration>
  SplitBody::vibration_of(const std::vector<SurfaceNode>  &nodes,
                          const std::vector<unsigned int> &components) const
  {
    require_vibrating();
    const auto positions = positions_of(nodes);
    return std::make_unique<SplitVibration>(
      SplitCompliance{fields,
                      inertia,
                      S_of_mesh,
                      change,
                      shapes_of_moments(positions, components),
                      influence_on(positions, components).dense()},
      model.damping);
  }

  std::unique_ptr<BodyDynamics>
  SplitBody::in_time(const ThetaScheme &,
                     const MassKind,
                     const std::vector<SurfaceNode> &,
                     const std::vector<unsigned int> &)
  {
    throw std::logic_error("A split body has no motion in time.");
  }

  std::string SplitBody::description() const
  {
    return "half-space in closed form and 18 moments of a mesh with " +
           std::to_string(n_unknowns()) + " unknowns, faded out from " +
           significant(1e3 * fading.inner, 3) + " to " +
           significant(1e3 * fading.outer, 3) + " mm.";
  }
} // namespace RollingContact
