#ifndef rolling_contact_bodies_split_body_h
#define rolling_contact_bodies_split_body_h

#include <rolling_contact/bodies/direct_body.h>
#include <rolling_contact/bodies/faded_fields.h>

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
   * S comes from the fields chi u_hs of half-spaces under each moment, which
   * fade out within the body, and from u_c, what the body adds to them, a field
   * that is smooth where the load is, so that elements which do not know the
   * patch are enough:
   *   S_kl = F_k K^-1 F_l + F_k(chi u_hs,l),
   * F of FadedFields, with curvature_correction() under the patch. A body that
   * vibrates keeps its factor, and its modes are those of the same mesh; others
   * give no displacements away from the contact. It has no motion in time.
   */
  class SplitBody final : public DirectBody<3>
  {
  public:
    /**
     * The body knows of a patch no more than the nodes whose compliance is
     * asked for, so that it serves all patches. @p is_half_space: nothing is
     * added to the half-space.
     */
    SplitBody(const std::shared_ptr<const BodyShape> &shape,
              const Material                         &material,
              const FadingRegion                     &fading,
              const BodyModel                        &model,
              const bool                              vibrates,
              const bool                              is_half_space = false);

    /**
     * Whether it is a body of this kind.
     */
    bool is_one_of(const BodyShape    &other_shape,
                   const Material     &other_material,
                   const FadingRegion &other_fading,
                   const BodyModel    &other_model,
                   const bool          other_vibrates,
                   const bool          is_other_half_space) const
    {
      return shape->is_same_as(other_shape) &&
             materials.core == other_material &&
             fading.inner == other_fading.inner && model == other_model &&
             vibrates == other_vibrates && is_half_space == is_other_half_space;
    }

    /**
     * Unless it vibrates, nothing but the contact is known of the body.
     */
    const DirectBody<3> *with_factor() const override
    {
      return vibrates ? this : nullptr;
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
     * W by its parts, unless the body vibrates.
     */
    std::optional<GridInfluence>
    grid_influence(const std::vector<SurfaceNode>  &nodes,
                   const std::vector<unsigned int> &components) override;

    /**
     * What a mesh of larger elements changes, extrapolated; what the highest
     * moments do, over the ratio of body and patch by which the next ones are
     * smaller; and a share of what the curvature under the patch does.
     */
    std::vector<DenseMatrix> compliance_errors(
      const std::vector<SurfaceNode>         &nodes,
      const std::vector<unsigned int>        &components,
      const std::vector<std::vector<double>> &forces) const override;

    /** Throws std::logic_error unless the body vibrates. */
    std::vector<BodyField>
    recover(const std::vector<SurfaceNode>         &nodes,
            const std::vector<unsigned int>        &components,
            const std::vector<std::vector<double>> &forces) override;

    /** Throws std::logic_error unless the body vibrates, which must outlive
     * what is returned. */
    std::unique_ptr<ContactVibration>
    vibration_of(const std::vector<SurfaceNode>  &nodes,
                 const std::vector<unsigned int> &components) const override;

    /** Nothing, as its factor is small or went when S was known. */
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
    void require_vibrating() const;

    GridInfluence
    influence_on(const std::vector<std::array<double, 2>> &positions,
                 const std::vector<unsigned int>          &components) const;

    const std::shared_ptr<const BodyShape> shape;
    const FadingRegion                     fading;
    const bool                             vibrates, is_half_space;
    /** S without curvature, as the mesh has it, and what others add to it. */
    DenseMatrix  S_of_mesh, change;
    FadedFields  fields; ///< if it vibrates, as inertia
    FadedInertia inertia;
  };
} // namespace RollingContact

#endif
