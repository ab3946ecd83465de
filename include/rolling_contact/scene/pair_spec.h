#ifndef rolling_contact_scene_pair_spec_h
#define rolling_contact_scene_pair_spec_h

#include <rolling_contact/base/side.h>
#include <rolling_contact/mesh/body_model.h>
#include <rolling_contact/scene/body_parameters.h>
#include <rolling_contact/scene/contact_parameters.h>
#include <rolling_contact/scene/mesh_parameters.h>
#include <rolling_contact/scene/profile_parameters.h>
#include <rolling_contact/scene/solver_parameters.h>
#include <rolling_contact/scene/surface_parameters.h>
#include <rolling_contact/scene/wear_parameters.h>

#include <memory>

namespace RollingContact
{
  struct SceneParameters;

  /**
   * Whether an elastic body is one of its own wherever profiles touch, as it
   * has the section of its profile or comes from a file; a disc or a block
   * under a profile does not know it.
   */
  bool bodies_follow_profiles(const ProfileParameters &profiles,
                              const BodyParameters    &wheel,
                              const BodyParameters    &rail);

  /**
   * Whether surfaces that are straight across touch in a line from side to side
   * of the narrower body, in 3D and without profiles.
   */
  inline bool touch_in_line(const unsigned int       dimension,
                            const ProfileParameters &profiles,
                            const BodyParameters    &wheel,
                            const BodyParameters    &rail)
  {
    return dimension == 3 && !profiles.in_use() && wheel.lateral_radius == 0. &&
           rail.lateral_radius == 0.;
  }

  /**
   * Two bodies in rolling contact: what they are made of, where they touch,
   * what presses and drags them, and the mesh and the solvers of their contact.
   */
  struct PairSpec
  {
    /**
     * The entries about the pair as they are, without files.
     */
    explicit PairSpec(const SceneParameters &inputs);

    /**
     * The angle of load and approach against the normal of the plane in which
     * bodies touch first, on a curved surface of contact under a vertical load;
     * else 0. Units: rad.
     */
    double load_angle() const;

    /**
     * Find the creepages of the motion, and the normal load that a vertical one
     * has without friction, in the frame of the contact.
     */
    void take_frame_loads();

    /**
     * Whether the undeformed gap is that of the radii of wheel and rail and
     * both are of one material each, so that closed forms have something to
     * say.
     */
    bool has_plain_surfaces() const
    {
      return contact.roughness.empty() && !profiles.in_use() &&
             !touches_in_line() && !surfaces.in_use() &&
             surfaces.friction_share.empty() && !has_covers();
    }

    /** Whether one of the bodies has a cover of another material. */
    bool has_covers() const
    {
      return wheel.has_cover() || rail.has_cover();
    }

    /** See touch_in_line(). */
    bool touches_in_line() const
    {
      return touch_in_line(dimension, profiles, wheel, rail);
    }

    /**
     * Thickness in 2D of the bodies that are not rigid. Units: m.
     */
    double thickness() const
    {
      return wheel.rigid ? rail.thickness : wheel.thickness;
    }

    /**
     * bodies_follow_profiles() of these bodies.
     */
    bool follows_profiles() const
    {
      return bodies_follow_profiles(profiles, wheel, rail);
    }

    const BodySpec &body(const Side side) const
    {
      return side == Side::wheel ? wheel : rail;
    }

    unsigned int dimension;
    BodySolver   body_solver;
    unsigned int body_threads;

    BodySpec          wheel, rail;
    ContactParameters contact; ///< with the creepages and the load that act
    SolverParameters  solver;
    MeshParameters    mesh;
    ProfileParameters profiles;
    SurfaceSpec       surfaces;
    WearParameters    wear;

    /** Frame of the contact on profiles; none where the bodies have shapes. */
    std::shared_ptr<const Profiles::ContactFrame> frame;

    /** How the wheelset moves, where creepages follow from that. */
    std::optional<Profiles::WheelsetMotion> motion;
  };
} // namespace RollingContact

#endif
