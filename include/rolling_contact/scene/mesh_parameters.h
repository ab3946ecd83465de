#ifndef rolling_contact_scene_mesh_parameters_h
#define rolling_contact_scene_mesh_parameters_h

#include <optional>

namespace RollingContact
{
  class Entries;

  /**
   * What part of the rim of the patch gets smaller elements.
   */
  enum class RimEdges
  {
    leading,
    both
  };

  /**
   * What a level refines.
   */
  enum class LevelMarking
  {
    adaptive,
    uniform
  };

  /**
   * What the compliance of the contact nodes is made of.
   */
  enum class Compliance
  {
    automatic,
    finite_elements,
    split, ///< a half-space, and what the body adds: see SplitBody
    /** Half-spaces alone wherever nodes can be on them, for states on the way
     * to others. */
    half_spaces
  };

  /**
   * Section `Mesh`: element sizes, measured in the patch of the Hertz estimate.
   */
  struct MeshParameters
  {
    void declare(Entries &entries);

    /**
     * True if the mesh is to follow the leading edge it finds.
     */
    bool aligned() const
    {
      return !patch_offset;
    }

    /**
     * The given offset, 0 when aligned. Units: elements.
     */
    double offset() const
    {
      return patch_offset.value_or(0.);
    }

    /**
     * Growth of the element size in scenes of so many dimensions: the one given
     * or, as elements are many more in 3D, 0.1 in 2D and 0.4 in 3D.
     */
    double growth_in(const unsigned int dimension) const
    {
      return growth.value_or(dimension == 2 ? 0.1 : 0.4);
    }

    /**
     * Largest error bound of the force that the mesh is chosen for, over mu N;
     * none: the mesh is that of the other entries. With it, the number of
     * elements is the least and the growth the largest, unless they are not
     * given.
     */
    std::optional<double> target_error;
    unsigned int          elements_across_patch   = 48;
    unsigned int          elements_across_patch_y = 0;
    unsigned int          least_elements_y        = 0; ///< 0: automatic

    /** Least size of elements that the smallest of several patches asks for,
     * over that of the whole. Not an entry. */
    double finest_share = 0.;
    /** None: aligned. Units: elements. */
    std::optional<double> patch_offset   = 0.;
    double                candidate_zone = 0.;
    double                zone_depth     = 0.75;
    std::optional<double> growth; ///< none: see growth_in()
    unsigned int          rim_levels          = 0;
    RimEdges              rim_edges           = RimEdges::leading;
    unsigned int          adaptive_levels     = 0;
    LevelMarking          level_marking       = LevelMarking::adaptive;
    Compliance            compliance          = Compliance::finite_elements;
    unsigned int          contact_node_budget = 2000;
    double                target_change       = 1e-3;

    /**
     * Throws InputError if the target of the error cannot be one.
     */
    void check() const;

  private:
    void declare_patch(Entries &entries);

    void declare_zone(Entries &entries);
  };
} // namespace RollingContact

#endif
