#include <rolling_contact/pair/profile_surface.h>

namespace RollingContact
{
  namespace
  {
    const double beyond_surface = 1e-2; // m, gap where a profile has ended

    bool is_curved(const PairSpec &scene)
    {
      return scene.frame &&
             scene.frame->kind() == Profiles::SurfaceKind::curved;
    }
  } // namespace

  SurfaceFrames surface_frames(const PairSpec                    &scene,
                               const ContactOperators::Positions &at)
  {
    SurfaceFrames frames;
    if (!is_curved(scene))
      return frames;
    const Profiles::ContactFrame &frame = *scene.frame;
    frames.load_angle                   = scene.load_angle();
    for (const auto &[x, s] : at)
      {
        const auto [y, z, angle] = frame.covers(s)
                                     ? frame.surface(s)
                                     : Profiles::SurfacePoint{s, 0., 0.};
        frames.nodes.push_back({y, z, angle});
      }
    return frames;
  }

  double gap_of_profiles(const PairSpec &scene, const std::array<double, 2> &at)
  {
    return scene.frame->gap(at[0], at[1]).value_or(beyond_surface);
  }

  NodalField slip_of_profiles(const PairSpec                    &scene,
                              const ContactOperators::Positions &at,
                              const unsigned int                 n_tangential)
  {
    if (n_tangential == 0 ||
        (!scene.profiles.gives_creepages() && !is_curved(scene)))
      return {};
    const Profiles::ContactFrame &frame = *scene.frame;
    const double                  flow  = scene.contact.flow();
    NodalField                    slip(at.size(), n_tangential);
    for (unsigned int i = 0; i < at.size(); ++i)
      {
        const auto &[x, s] = at[i];
        slip(0, i)         = flow * frame.slip_beyond_spin(s);
        if (is_curved(scene) && frame.covers(s))
          slip(1, i) = flow * frame.slip_of_rolling(x, s);
      }
    return slip;
  }
} // namespace RollingContact
