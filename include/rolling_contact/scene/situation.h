#ifndef rolling_contact_scene_situation_h
#define rolling_contact_scene_situation_h

#include <rolling_contact/mesh/profile_patch.h>
#include <rolling_contact/scene/pair_spec.h>
#include <rolling_contact/scene/scene_parameters.h>

#include <memory>

namespace RollingContact
{
  /**
   * What a run computes with: the inputs, and the pair that follows from them,
   * with the meshes of its bodies, the frame of its contact, its surfaces, and
   * the load and the creepages that act. Files and the frame are shared by
   * copies.
   */
  struct Situation : public PairSpec
  {
    /**
     * Find what follows from @p inputs, which pass their check(). What depends
     * on entries that are those of an @p earlier situation is taken from that,
     * and no file of it is opened; then check_bodies() is left to the caller.
     * Throws InputError.
     */
    explicit Situation(const SceneParameters &inputs,
                       const Situation       *earlier = nullptr);

    /**
     * Rules for bodies with files or profiles. Throws InputError.
     */
    void check_bodies() const;

    std::shared_ptr<const SceneParameters> inputs;

  private:
    void take_meshes(const Situation *earlier);

    void take_surfaces(const Situation *earlier);

    void take_frame(const Situation *earlier);

    void take_loads();

    /** What presses the bodies where the frame of the contact depends on it. */
    PressedHalfSpaces pressed() const;
  };
} // namespace RollingContact

#endif
