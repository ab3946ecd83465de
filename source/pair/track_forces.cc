#include <rolling_contact/pair/track_forces.h>

#include <cmath>

namespace RollingContact
{
  TrackForces track_forces(const PairSpec       &scene,
                           const ContactProblem &problem,
                           const ContactState   &state)
  {
    const Profiles::ContactFrame &frame = *scene.frame;
    const double       curvature = scene.motion ? scene.motion->curvature : 0.;
    const unsigned int n         = problem.n_nodes(),
                       n_tangential   = problem.n_tangential();
    const std::vector<double> forces  = nodal_forces(problem, state);
    const SurfaceFrames      &surface = problem.operators.frames();
    TrackForces               sum;
    double                    pressed = 0., to_the_side = 0., upwards = 0.;
    for (unsigned int i = 0; i < n; ++i)
      {
        const double along  = n_tangential > 0 ? forces[i] : 0.,
                     across = n_tangential > 1 ? forces[n + i] : 0.,
                     normal = forces[n_tangential * n + i];
        if (along == 0. && across == 0. && normal == 0.)
          continue;
        const auto [x, s]                  = problem.operators.positions()[i];
        const Profiles::PlaceInTrack place = frame.place_in_track(
          x, s, surface.is_plane() ? 0. : surface.nodes[i].angle);
        const auto [X, Y, Z] = place.at;
        const double sine = std::sin(place.slope), c = std::cos(place.slope);
        const double to_the_right = normal * sine,
                     force_y      = c * across + to_the_right,
                     force_z      = sine * across - normal * c;
        pressed += normal;
        to_the_side += to_the_right;
        upwards += normal * c;
        sum.pressure_y += normal * Y;
        sum.force_x -= along + curvature * X * to_the_right;
        sum.force_y += force_y;
        sum.force_z += force_z;
        sum.moment_x += Y * force_z - Z * force_y;
        sum.moment_z +=
          along * place.along[2] + across * place.across[2] + X * to_the_right;
        sum.axle_torque += along * place.along[3] + across * place.across[3];
      }
    if (pressed > 0.)
      sum.pressure_y /= pressed;
    sum.pressure_angle = std::atan2(to_the_side, upwards);
    return sum;
  }
} // namespace RollingContact
