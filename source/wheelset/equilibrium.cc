#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/wheelset/equilibrium.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /// one of a scaled unknown, and the most that a step takes of it
    const double shift_scale = 1e-3, yaw_scale = 1e-3, excess_scale = 1e-4;
    const Eigen::Vector4d largest_steps(0.3, 1., 5., 0.3);

    /// scaled, for derivatives by differences
    const Eigen::Vector4d differences_of(0.02, 0.02, 0.2, 0.02);

    /// of a step, and differences where those fail over the usual ones
    const unsigned int most_halvings = 6;
    const unsigned int few_steps     = 4; ///< that bring it closer by a fifth
    const double       nearly_closed = 1e-4; ///< over the axle load
    const double       finer         = 0.05;

    /// over the axle load: from where steps that are cut to this share do not
    /// lead, and what an edge changes
    const double largest_at_start = 0.3, smallest_first = 0.2,
                 largest_jump = 1e-2;

    /// of central differences: m, rad, 1, 1, 1/m, and m of the rails
    const double small_motions[] = {1e-5, 1e-5, 1e-5, 1e-5, 1.3e-5, 1e-5};

    /// where a force or moment is the unknown: over the axle load
    const double force_scale = 1e-2;

    /**
     * The first three balances by what moves, with rails that go where the
     * fourth one leads; as they are with rigid rails, by which nothing changes.
     */
    template <int n>
    Eigen::Matrix<double, 3, n>
    with_rails_following(const Eigen::Matrix<double, 4, n> &by_motions,
                         const Eigen::Vector4d             &by_rails)
    {
      Eigen::Matrix<double, 3, n> result = by_motions.template topRows<3>();
      if (by_rails[3] != 0.)
        result -= by_rails.head<3>() * by_motions.row(3) / by_rails[3];
      return result;
    }
  } // namespace

  WheelsetState WheelsetState::mirrored() const
  {
    WheelsetState other = *this;
    other.acting        = acting.mirrored();
    other.place         = place.mirrored();
    other.lateral_force = -lateral_force;
    other.yaw_moment    = -yaw_moment;
    other.wheels        = {{wheels[1].mirrored(), wheels[0].mirrored()}};
    other.residual = {-residual[0], -residual[1], residual[2], residual[3]};
    return other;
  }

  Equilibrium::Equilibrium(WheelPair &pair, const WheelsetParameters &wheelset)
    : pair(pair)
    , wheelset(wheelset)
    , lateral_stiffness(wheelset.is_bogie ? wheelset.hunting.lateral_stiffness
                                          : 0.)
    , rail_stiffness(wheelset.rail_stiffness.value_or(0.))
    , scales(wheelset.shift ? force_scale * wheelset.axle_load : shift_scale,
             wheelset.yaw ? force_scale * wheelset.axle_load : yaw_scale,
             excess_scale,
             shift_scale)
    , limits(wheelset.shift ? 10. : largest_steps[0],
             wheelset.yaw ? 10. : largest_steps[1],
             largest_steps[2],
             largest_steps[3])
  {}

  Equilibrium::Active Equilibrium::all(const bool with_shift) const
  {
    Active result{1, 2};
    if (with_shift)
      result.insert(result.begin(), 0);
    if (rail_stiffness > 0.)
      result.push_back(3);
    return result;
  }

  Equilibrium::Unknowns Equilibrium::unknowns_of(const WheelsetState &at) const
  {
    return Unknowns(wheelset.shift ? at.acting.lateral_force : at.place.shift,
                    wheelset.yaw ? at.yaw_moment : at.place.yaw,
                    at.place.excess,
                    (at.place.rails[0] - at.place.rails[1]) / 2)
      .cwiseQuotient(scales);
  }

  std::optional<std::array<double, 2>>
  Equilibrium::loads_under(const double force)
  {
    const double W       = wheelset.axle_load,
                 carried = pair.radius() * force / (2 * pair.half_base()) +
                           wheelset.load_transfer;
    if (W / 2 - std::abs(carried) < 1e-3 * W)
      {
        reason = "the lateral force of " + significant(force, 4) +
                 " N and the load transfer lift a wheel off its rail";
        return {};
      }
    return std::array<double, 2>{{W / 2 + carried, W / 2 - carried}};
  }

  std::optional<WheelsetState> Equilibrium::evaluate(const CurveCase &acting,
                                                     const Unknowns  &x,
                                                     const double     aside)
  {
    throw_if_interrupted();
    const double  W = wheelset.axle_load;
    WheelsetState at;
    at.acting = acting;
    if (wheelset.shift)
      at.acting.lateral_force = scales[0] * x[0];
    at.place = {wheelset.shift.value_or(scales[0] * x[0]),
                wheelset.yaw.value_or(scales[1] * x[1]),
                scales[2] * x[2],
                aside};
    at.yaw_moment =
      wheelset.yaw ? scales[1] * x[1]
                   : wheelset.yaw_stiffness * (acting.frame_yaw - at.place.yaw);
    at.lateral_force =
      at.acting.lateral_force - lateral_stiffness * at.place.shift;
    if (rail_stiffness > 0.)
      {
        const double both  = at.lateral_force / (2 * rail_stiffness),
                     apart = scales[3] * x[3];
        at.place.rails     = {{both + apart, both - apart}};
      }
    const auto loads = loads_under(at.lateral_force);
    if (!loads)
      return {};
    try
      {
        at.wheels = pair.solve(at.place, acting.curvature, *loads);
      }
    catch (const InputError &error)
      {
        reason = error.what();
        return {};
      }
    catch (const ConvergenceError &error)
      {
        reason = error.what();
        return {};
      }
    const TrackForces &right = at.wheels[0].forces, &left = at.wheels[1].forces;
    at.residual = {right.force_y + left.force_y + at.lateral_force,
                   right.moment_z + left.moment_z +
                     at.place.on_rail(0) * right.force_x +
                     at.place.on_rail(1) * left.force_x + at.yaw_moment,
                   right.axle_torque + left.axle_torque - acting.axle_torque,
                   rail_stiffness > 0. ? (right.force_y - left.force_y) / 2 +
                                           rail_stiffness * scales[3] * x[3]
                                       : 0.};
    at.residual /= W;
    return at;
  }

  bool Equilibrium::differences(const CurveCase     &acting,
                                const Active        &active,
                                const WheelsetState &at,
                                const double         size)
  {
    const Unknowns x = unknowns_of(at);
    if (!jacobian)
      jacobian = Eigen::Matrix4d::Identity();
    // towards the middle of the track, away from flanges
    for (const unsigned int j : active)
      {
        const double h     = j == 0 && x[0] > 0. ? -size * differences_of[j]
                                                 : size * differences_of[j];
        Unknowns     moved = x;
        moved[j] += h;
        const auto there = evaluate(acting, moved);
        if (!there)
          return false;
        jacobian->col(j) = (there->residual - at.residual) / h;
      }
    return true;
  }

  std::optional<Eigen::Matrix3d> Equilibrium::slopes()
  {
    if (!jacobian && !differences(state.acting, all(), state, 1.))
      jacobian.reset();
    if (!jacobian)
      return {};
    const Eigen::Matrix4d whole =
      *jacobian * scales.cwiseInverse().asDiagonal();
    return with_rails_following<3>(whole.leftCols<3>(), whole.col(3));
  }

  std::optional<WheelsetState>
  Equilibrium::newton(const CurveCase     &acting,
                      const Active        &active,
                      const WheelsetState &start,
                      const double         least,
                      const unsigned int   most_steps)
  {
    const unsigned int n    = active.size();
    const auto         part = [&](const Eigen::VectorXd &whole) {
      Eigen::VectorXd result(n);
      for (unsigned int i = 0; i < n; ++i)
        result[i] = whole[active[i]];
      return result;
    };
    const auto not_closer_than = [&](const Eigen::VectorXd &left) {
      reason = "the balances do not come closer than " +
               significant(left.lpNorm<Eigen::Infinity>(), 2) +
               " of the axle load";
      return std::optional<WheelsetState>();
    };
    closest.reset();
    auto &at = closest;
    at       = evaluate(acting, unknowns_of(start));
    if (!at)
      return {};
    std::vector<double> norms; // of what is left
    bool                is_new = false;
    double              size   = 1.; // of differences
    for (unsigned int k = 0; k < most_steps; ++k)
      {
        Eigen::VectorXd f = part(at->residual);
        if (f.lpNorm<Eigen::Infinity>() <= least)
          return at;
        norms.push_back(f.norm());
        if (k >= few_steps && norms[k] > nearly_closed &&
            norms[k] > 0.8 * norms[k - few_steps])
          return not_closer_than(f);
        if (!jacobian)
          {
            if (!differences(acting, active, *at, size))
              return {};
            is_new = true;
          }
        Eigen::MatrixXd J(n, n);
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            J(i, j) = (*jacobian)(active[i], active[j]);
        Eigen::VectorXd step = -J.fullPivLu().solve(f);
        if (!step.allFinite())
          return {};
        double share = 1.;
        for (unsigned int i = 0; i < n; ++i)
          share =
            std::min(share,
                     limits[active[i]] / std::max(std::abs(step[i]), 1e-300));
        // a flange that is far in the rail
        if (k == 0 && !wheelset.shift && share < smallest_first &&
            f.lpNorm<Eigen::Infinity>() > largest_at_start)
          {
            reason = "the balances are off by " +
                     significant(at->largest_residual(), 2) +
                     " of the axle load where the search would begin";
            return {};
          }
        bool is_closer = false;
        for (unsigned int halved = 0; halved < most_halvings && !is_closer;
             ++halved, share /= 2)
          {
            ++n_steps;
            const Unknowns x = unknowns_of(*at);
            Unknowns       d = Unknowns::Zero();
            for (unsigned int i = 0; i < n; ++i)
              d[active[i]] = share * step[i];
            const auto trial = evaluate(acting, x + d);
            if (!trial)
              continue;
            const Eigen::Vector4d change = trial->residual - at->residual;
            *jacobian +=
              (change - *jacobian * d) * d.transpose() / d.squaredNorm();
            is_closer =
              part(trial->residual).norm() < (1 - 0.1 * share) * f.norm();
            if (is_closer)
              at = trial;
            else if (!is_new)
              break;
          }
        if (is_closer)
          {
            is_new = false;
            continue;
          }
        if (is_new && size == 1.)
          size = finer; // beside a corner of the forces
        else if (is_new)
          {
            return not_closer_than(f);
          }
        jacobian.reset();
      }
    if (part(at->residual).lpNorm<Eigen::Infinity>() <= least)
      return at;
    reason = "the balances are not closed after " + std::to_string(most_steps) +
             " steps";
    return {};
  }

  std::optional<WheelsetState>
  Equilibrium::newton_or_held(const CurveCase     &acting,
                              const Active        &active,
                              const WheelsetState &start,
                              const double         least)
  {
    auto found = newton(acting, active, start, least, 15);
    if (found)
      return found;
    // forces jump where an edge does, by so little
    jacobian.reset();
    for (const unsigned int balance : active)
      if (closest && std::abs(closest->residual[balance]) > largest_jump)
        return {};
    pair.hold_edges(true);
    found = newton(acting, active, start, least, 15);
    pair.hold_edges(false);
    if (found || !closest)
      return found;
    for (const unsigned int balance : active)
      if (std::abs(closest->residual[balance]) > std::max(accepted, enough))
        return {};
    return closest;
  }

  bool Equilibrium::solve(const CurveCase &acting, const WheelsetState &start)
  {
    const auto found = newton_or_held(acting, all(), start, enough);
    if (found)
      state = *found;
    else
      jacobian.reset();
    return found.has_value();
  }

  bool Equilibrium::polish()
  {
    pair.hold_edges(true);
    auto found = newton(state.acting, all(), state, 1e-8, 12);
    if (!found)
      {
        // derivatives of steps across edges mislead where edges are held
        jacobian.reset();
        found = newton(state.acting, all(), state, 1e-8, 12);
      }
    if (found)
      state = *found;
    pair.hold_edges(false);
    return found.has_value();
  }

  std::optional<Hunting::Derivatives>
  Equilibrium::motion_derivatives(const bool with_velocities)
  {
    if (wheelset.shift || wheelset.yaw)
      return {};
    Eigen::Matrix<double, 4, 6> result = Eigen::Matrix<double, 4, 6>::Zero();
    const Unknowns              x      = unknowns_of(state);
    const auto residual = [&](const unsigned int j, const double change) {
      Unknowns           moved   = x;
      CurveCase          acting  = state.acting;
      const unsigned int unknown = j == 5 ? 3 : j;
      if (j < 3 || j == 5)
        moved[unknown] += change / scales[unknown];
      // the frame does not turn with the wheelset
      if (j == 4)
        acting.curvature += change;
      return evaluate(acting, moved, j == 3 ? change : 0.);
    };
    pair.hold_edges(true);
    bool is_there = true;
    for (unsigned int j = 0; is_there && j < 6; ++j)
      {
        if (j == 5 ? rail_stiffness == 0. : j > 2 && !with_velocities)
          continue;
        const double h     = small_motions[j];
        const auto   above = residual(j, h), below = residual(j, -h);
        is_there = above && below;
        if (is_there)
          result.col(j) = (above->residual - below->residual) / (2 * h);
      }
    pair.hold_edges(false);
    if (!is_there)
      return {};
    return with_rails_following<5>(result.leftCols<5>(), result.col(5));
  }
} // namespace RollingContact
