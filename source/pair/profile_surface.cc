#include <rolling_contact/pair/profile_surface.h>

#include <algorithm>

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

    /**
     * The rail's part in how surfaces that differ come to lie on each other: of
     * like materials a half, of a rigid wheel all.
     */
    double share_of_rail(const PairSpec &scene)
    {
      const auto compliance = [](const BodySpec &body) {
        const double nu = body.material.poisson_ratio;
        return body.rigid ? 0. : (1 - nu * nu) / body.material.young_modulus;
      };
      const double rail = compliance(scene.rail);
      return rail > 0. ? rail / (compliance(scene.wheel) + rail) : 0.;
    }

    /**
     * By how much the wheel's surface is steeper than the rail's at (0, s),
     * upwards towards positive y; 0 where one of them ends. Units: rad.
     */
    double slope_of_gap(const Profiles::ContactFrame &frame, const double s)
    {
      const double step = 1e-5, largest = 0.1;
      const auto   before = frame.gap(0., s - step),
                 after    = frame.gap(0., s + step);
      return before && after
               ? std::clamp((*after - *before) / (2 * step), -largest, largest)
               : 0.;
    }
  } // namespace

  SurfaceFrames surface_frames(const PairSpec                    &scene,
                               const ContactOperators::Positions &at)
  {
    SurfaceFrames frames;
    if (!is_curved(scene))
      return frames;
    const Profiles::ContactFrame &frame = *scene.frame;
    const double                  share = share_of_rail(scene);
    frames.load_angle                   = scene.load_angle();
    for (const auto &[x, s] : at)
      {
        const auto [y, z, angle] = frame.covers(s)
                                     ? frame.surface(s)
                                     : Profiles::SurfacePoint{s, 0., 0.};
        frames.nodes.push_back({y, z, angle - share * slope_of_gap(frame, s)});
      }
    return frames;
  }

  double gap_of_profiles(const PairSpec &scene, const std::array<double, 2> &at)
  {
    return scene.frame->gap(at[0], at[1]).value_or(beyond_surface);
  }

  namespace
  {
    /**
     * The rigid slip of a wheelset that moves, less that of its creepages.
     */
    NodalField slip_of_motion(const PairSpec         &scene,
                              const ContactOperators &operators)
    {
      const Profiles::ContactFrame         &frame = *scene.frame;
      const Profiles::GeneralisedVelocities u = frame.velocities(*scene.motion);
      NodalField slip = rigid_slip(operators, frame.creepages(*scene.motion));
      slip *= -1.;
      for (unsigned int i = 0; i < operators.n_nodes(); ++i)
        {
          const auto [x, s] = operators.positions()[i];
          const auto place =
            frame.place_in_track(x,
                                 s,
                                 operators.frames().is_plane()
                                   ? 0.
                                   : operators.frames().nodes[i].angle);
          slip(0, i) += Profiles::dot(place.along, u);
          if (operators.n_tangential() > 1)
            slip(1, i) += Profiles::dot(place.across, u);
        }
      return slip;
    }
  } // namespace

  NodalField slip_of_profiles(const PairSpec         &scene,
                              const ContactOperators &operators)
  {
    const unsigned int n_tangential = operators.n_tangential();
    if (n_tangential == 0 || (!scene.motion && !is_curved(scene)))
      return {};
    if (scene.motion)
      return slip_of_motion(scene, operators);
    const ContactOperators::Positions &at    = operators.positions();
    const Profiles::ContactFrame      &frame = *scene.frame;
    const double                       flow  = scene.contact.flow();
    NodalField                         slip(at.size(), n_tangential);
    for (unsigned int i = 0; i < at.size(); ++i)
      {
        const auto &[x, s] = at[i];
        slip(0, i)         = flow * frame.slip_beyond_spin(s);
        if (n_tangential > 1 && frame.covers(s))
          slip(1, i) = flow * frame.slip_of_rolling(x, s);
      }
    return slip;
  }
} // namespace RollingContact
