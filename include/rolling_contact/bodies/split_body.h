#ifndef rolling_contact_bodies_split_body_h
#define rolling_contact_bodies_split_body_h

#include <rolling_contact/bodies/direct_body.h>
#include <rolling_contact/bodies/patch_correction.h>

namespace RollingContact
{
  /**
   * A body whose compliance is split: that of a half-space in closed form, on
   * nodes that are on no mesh, and what the finite, held body adds, which is
   * smooth at the patch and known by 18 moments from a mesh that does not know
   * the patch,
   *   W = W_hs + Phi S Phi^T,
   * Phi the values x^i y^j/(i! j!) of force_moments() at the nodes. S is that
   * of two meshes, extrapolated, and what the curvature under the nodes adds.
   * It gives no displacements away from the contact, and has no motion in time.
   */
  class SplitBody final : public DirectBody<3>
  {
  public:
    /**
     * The body knows of a patch no more than the nodes whose compliance is
     * asked for, so that it serves all patches.
     */
    SplitBody(const std::shared_ptr<const BodyShape> &shape,
              const Material                         &material,
              const FadingRegion                     &fading,
              const BodyModel                        &model);

    /**
     * Whether it is a body of this kind.
     */
    bool is_one_of(const BodyShape    &other_shape,
                   const Material     &other_material,
                   const FadingRegion &other_fading,
                   const BodyModel    &other_model) const
    {
      return shape->is_twin_of(other_shape) && material == other_material &&
             fading.inner == other_fading.inner && model == other_model;
    }

    /**
     * Not a body of which anything but the contact is known.
     */
    const DirectBody<3> *with_factor() const override
    {
      return nullptr;
    }

    /**
     * Find S.
     */
    void analyse() override;

    /**
     * The nodes are those of equal boxes, the same distances apart all over.
     */
    DenseMatrix compliance(const std::vector<SurfaceNode>  &nodes,
                           const std::vector<unsigned int> &components,
                           const SparseRows                &P) override;

    /**
     * What a mesh of larger elements changes, extrapolated; what the highest
     * moments do, over the ratio of body and patch by which the next ones are
     * smaller; and a share of what the curvature under the patch does.
     */
    std::vector<DenseMatrix> compliance_errors(
      const std::vector<SurfaceNode>         &nodes,
      const std::vector<unsigned int>        &components,
      const std::vector<std::vector<double>> &forces) const override;

    /** Nothing, as its factor went when S was known. */
    void release_solver() override
    {}

    /** Throws std::logic_error, as it has no mass. */
    std::unique_ptr<BodyDynamics>
    in_time(const ThetaScheme               &scheme,
            const MassKind                   mass,
            const std::vector<SurfaceNode>  &nodes,
            const std::vector<unsigned int> &components) override;

    std::string description() const override;

  private:
    const std::shared_ptr<const BodyShape> shape;
    const FadingRegion                     fading;
    DenseMatrix                            S, change; ///< without curvature
  };
} // namespace RollingContact

#endif
