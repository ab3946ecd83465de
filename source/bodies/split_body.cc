#include <rolling_contact/base/text.h>
#include <rolling_contact/bodies/curvature_correction.h>
#include <rolling_contact/bodies/half_space_influence.h>
#include <rolling_contact/bodies/moment_fields.h>
#include <rolling_contact/bodies/split_body.h>

#include <stdexcept>

namespace RollingContact
{
  namespace
  {
    /**
     * Elements over the width in which the half-space fades out. Those of the
     * second mesh are twice as large, which makes its cells those of the first
     * put together.
     */
    const double elements_of_fading = 7., coarser = 2.;

    /**
     * What second order in the curvature may add, over what first order does.
     */
    const double of_second_order_in_curvature = 1. / 3;

    /**
     * Elements alike around the contact point and larger ones beyond, which do
     * not know the patch.
     */
    Grading<3> grading_of(const FadingRegion &fading, const double larger)
    {
      Grading<3> grading;
      grading.element_size_x = grading.element_size_y =
        larger * (fading.outer - fading.inner) / elements_of_fading;
      grading.zone_x = grading.zone_y = grading.zone_depth = fading.outer / 2;
      grading.growth                                       = 0.8;
      return grading;
    }

    std::vector<std::array<double, 2>>
    positions_of(const std::vector<ElasticBody<3>::SurfaceNode> &nodes)
    {
      std::vector<std::array<double, 2>> positions;
      for (const auto &node : nodes)
        positions.push_back({{node.position[0], node.position[1]}});
      return positions;
    }
  } // namespace

  SplitBody::SplitBody(const std::shared_ptr<const BodyShape> &shape,
                       const Material                         &material,
                       const std::array<double, 2>            &element_size,
                       const FadingRegion                     &fading,
                       const double                            farthest,
                       const std::array<double, 2>            &half_widths,
                       const BodyModel                        &model)
    : DirectBody<3>(shape, material, 1., grading_of(fading, 1.), true, model)
    , shape(shape)
    , element_size(element_size)
    , fading(fading)
    , farthest(farthest)
    , half_widths(half_widths)
  {}

  void SplitBody::analyse()
  {
    if (S.size() > 0)
      return;
    DirectBody<3> larger(
      shape, material, 1., grading_of(fading, coarser), true, model);
    S      = patch_correction(*this, *shape, fading, farthest);
    change = (S - patch_correction(larger, *shape, fading, farthest)) /
             (coarser * coarser - 1);
    of_curvature = curvature_correction(*shape, material, half_widths, fading);
    S += change + of_curvature;
    release_factor();
  }

  DenseMatrix SplitBody::compliance(const std::vector<SurfaceNode>  &nodes,
                                    const std::vector<unsigned int> &components,
                                    const SparseRows                &P)
  {
    if (P.size() > 0)
      throw std::logic_error("A split body has the nodes of the interface.");
    analyse();
    const auto  positions = positions_of(nodes);
    DenseMatrix W         = HalfSpaceInfluence(material, element_size)
                      .compliance(positions, components);
    const DenseMatrix Phi = shapes_of_moments(positions, components);
    W.noalias() += (Phi * S) * Phi.transpose();
    return W;
  }

  std::vector<DenseMatrix> SplitBody::compliance_errors(
    const std::vector<SurfaceNode>         &nodes,
    const std::vector<unsigned int>        &components,
    const std::vector<std::vector<double>> &forces) const
  {
    DenseMatrix f(components.size() * nodes.size(), forces.size());
    for (std::size_t k = 0; k < forces.size(); ++k)
      f.col(k) =
        Eigen::Map<const Eigen::VectorXd>(forces[k].data(), forces[k].size());
    const DenseMatrix moments =
      shapes_of_moments(positions_of(nodes), components).transpose() * f;
    DenseMatrix highest = S;
    const auto &all     = force_moments();
    for (std::size_t k = 0; k < all.size(); ++k)
      for (std::size_t l = 0; l < all.size(); ++l)
        if (all[k].degree() < 2 && all[l].degree() < 2)
          highest(k, l) = 0.;
    const auto work = [&](const DenseMatrix &of_moments) {
      return DenseMatrix(moments.transpose() * of_moments * moments);
    };
    return {work(change),
            work(farthest / fading.outer * highest),
            work(of_second_order_in_curvature * of_curvature)};
  }

  std::vector<BodyField>
  SplitBody::recover(const std::vector<SurfaceNode> &,
                     const std::vector<unsigned int> &,
                     const std::vector<std::vector<double>> &)
  {
    throw std::logic_error("A split body has no displacements inside.");
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
