#ifndef rolling_contact_results_target_error_h
#define rolling_contact_results_target_error_h

#include <rolling_contact/results/error_bounds.h>
#include <rolling_contact/scene/pair_spec.h>

#include <vector>

namespace RollingContact
{
  /**
   * The states of an analysis that a target error is meant for, beyond the one
   * its scene describes.
   */
  struct TargetDemands
  {
    /** One of them has spin. */
    bool spin = false;
    /** Half-widths of their patches, largest and smallest, over that of the
     * patch the mesh is made for. */
    std::vector<double> patches{1.};

    /** Whether the state of the scene, which is solved first, is all. */
    bool is_one_state() const
    {
      return !spin && patches.size() == 1;
    }
  };

  /**
   * A mesh that keeps a target, and the bounds expected of the worst state on
   * it.
   */
  struct TargetMesh
  {
    unsigned int elements = 0; ///< across the patch
    double       growth   = 0.;
    ErrorBounds  bounds;
  };

  /**
   * Finds the mesh for `Mesh/Target error` from the bounds of the error, before
   * anything is meshed, and again when a state turned out to be another than
   * expected: its patch smaller, its edges not settled, its waves larger. Of a
   * single state the bound that it estimates itself counts, which in 3D is
   * hoped to be below the expected one; on the last of the meshes nothing is
   * hoped.
   */
  class TargetError
  {
  public:
    TargetError(const PairSpec &scene, const TargetDemands &demands);

    /**
     * The mesh that takes least time among those that keep the target. Throws
     * InputError, with what to change, if there is none.
     */
    TargetMesh cheapest_mesh() const;

    /**
     * The bounds of the worst state, going by one that was solved on the @p
     * mesh.
     */
    template <int dim>
    ErrorBounds bounds_on(const TargetMesh       &mesh,
                          const SteadyState<dim> &steady) const;

    /**
     * The next cheapest_mesh() is for states like this one, or the worst of its
     * kind if it is @p the_last.
     */
    template <int dim>
    void learn(const TargetMesh       &mesh,
               const SteadyState<dim> &steady,
               const bool              the_last);

  private:
    /**
     * The bounds of the worst state, or those without one.
     */
    ErrorBounds worst_bounds(const BoundCircumstances &found) const;

    /**
     * What is expected on a mesh of so many elements across the patch.
     */
    BoundCircumstances expected(const unsigned int elements,
                                const double       growth) const;

    template <int dim>
    BoundCircumstances found_on(const TargetMesh       &mesh,
                                const SteadyState<dim> &steady) const;

    /**
     * The bounds that a state on the @p mesh has itself.
     */
    template <int dim>
    ErrorBounds own_bounds(const TargetMesh       &mesh,
                           const SteadyState<dim> &steady) const;

    [[noreturn]] void reject(const TargetMesh &best) const;

    const PairSpec      scene;
    const TargetDemands demands;
    const double        target;
    const PatchEstimate patch;
    BoundCircumstances  known;
    double              length;     ///< of the patch over the estimated one
    double              waves = 1.; ///< over those of the estimated patch
    /** What a state's own bound was over the expected one. */
    double raised = 1.;
    bool   hopes; ///< for an own bound below the expected one
  };
} // namespace RollingContact

#endif
