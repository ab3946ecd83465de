#include <rolling_contact/wheelset/running_gear.h>

#include <algorithm>

namespace RollingContact
{
  namespace
  {
    const unsigned int most_rounds = 12;

    /// m and rad, the most that a round moves the frame
    const double largest_move = 2e-3;

    /// of the frame's balances over the axle load: on the way, and at its end
    const double on_the_way = 1e-3, tolerance = 3e-5, least_left = 2e-8;

    const unsigned int most_returns = 4;
  } // namespace

  RunningGear::RunningGear(const Situation          &scene,
                           const WheelsetParameters &parameters,
                           const bool                roughly)
    : parameters(parameters)
    , frame(parameters)
    , largest_left(roughly ? on_the_way : tolerance)
  {
    for (unsigned int i = 0; i < parameters.n_wheelsets(); ++i)
      {
        wheelsets.push_back(std::make_unique<One>(scene, parameters, roughly));
        if (roughly && parameters.is_bogie)
          balance(i).accepted = on_the_way;
      }
    state = at_rest();
  }

  void RunningGear::swap_sides()
  {
    for (const auto &one : wheelsets)
      one->pair.swap_sides();
  }

  RunningState RunningGear::at_rest() const
  {
    RunningState rest;
    rest.wheelsets.resize(n_wheelsets());
    return rest;
  }

  bool RunningGear::settle_wheelsets(RunningState &at, const Settle &settle)
  {
    for (unsigned int i = 0; i < n_wheelsets(); ++i)
      {
        Equilibrium    &one    = balance(i);
        const CurveCase acting = parameters.is_bogie
                                   ? frame.acting_on(i, at.acting, at.frame)
                                   : at.acting;
        if (!settle(one, acting, at.wheelsets[i]))
          {
            reason = one.reason;
            return false;
          }
        at.wheelsets[i] = one.now();
      }
    return true;
  }

  std::optional<Eigen::Matrix2d> RunningGear::frame_derivatives()
  {
    Eigen::Matrix2d result = frame.own();
    for (unsigned int i = 0; i < n_wheelsets(); ++i)
      {
        const auto slopes = balance(i).slopes();
        if (!slopes)
          {
            reason = balance(i).reason;
            return {};
          }
        Eigen::Matrix<double, 3, 2> by_frame =
          Eigen::Matrix<double, 3, 2>::Zero();
        by_frame.topRows<2>() = frame.coupling(i) / parameters.axle_load;
        const Eigen::Matrix<double, 3, 2> followed =
          -slopes->fullPivLu().solve(by_frame);
        result += frame.coupling(i).transpose() * followed.topRows<2>();
      }
    return result / parameters.axle_load;
  }

  bool RunningGear::find(const RunningState &start,
                         const Settle       &settle,
                         const double        least)
  {
    RunningState                   at = start;
    std::optional<Eigen::Matrix2d> slopes;
    Eigen::Vector2d                last, move;
    for (unsigned int round = 0; round < most_rounds; ++round)
      {
        bool is_there = settle_wheelsets(at, settle);
        for (unsigned int k = 0;
             !is_there && round > 0 && least >= tolerance && k < most_returns;
             ++k)
          {
            move /= 2;
            at.frame -= move;
            is_there = settle_wheelsets(at, settle);
          }
        if (!is_there)
          return false;
        if (parameters.is_bogie)
          at.frame_left = frame.residual(at.acting, at.frame, at.wheelsets);
        if (at.frame_left.lpNorm<Eigen::Infinity>() <= least)
          {
            state = at;
            return true;
          }
        if (!slopes)
          slopes = frame_derivatives();
        else
          *slopes += (at.frame_left - last - *slopes * move) *
                     move.transpose() / move.squaredNorm();
        if (!slopes)
          return false;
        last = at.frame_left;
        move = -slopes->fullPivLu().solve(last);
        move *= std::min(1., largest_move / move.lpNorm<Eigen::Infinity>());
        at.frame += move;
      }
    reason = "the frame of the bogie does not come to rest";
    return false;
  }

  bool RunningGear::solve(const RunningState &start)
  {
    return find(
      start,
      [](Equilibrium &one, const CurveCase &acting, const WheelsetState &from) {
        return one.solve(acting, from);
      },
      largest_left);
  }

  bool RunningGear::bracket(const RunningState &start, const double farthest)
  {
    return find(
      start,
      [&](Equilibrium         &one,
          const CurveCase     &acting,
          const WheelsetState &from) {
        return (parameters.is_bogie && one.solve(acting, from)) ||
               one.bracket(acting, from, farthest);
      },
      largest_left);
  }

  void RunningGear::polish()
  {
    const bool is_done = find(
      state,
      [](Equilibrium &one, const CurveCase &acting, WheelsetState from) {
        from.acting = acting;
        one.begin_with(from, one.derivatives());
        return one.polish();
      },
      least_left);
    if (!is_done)
      begin_with(state, this);
  }

  void RunningGear::begin_with(const RunningState &from,
                               const RunningGear  *other)
  {
    state = from;
    for (unsigned int i = 0; i < n_wheelsets(); ++i)
      balance(i).begin_with(from.wheelsets[i],
                            other ? other->wheelsets[i]->balance.derivatives()
                                  : Equilibrium::Derivatives());
  }

  bool RunningGear::carries(const CurveCase &acting)
  {
    const double each = acting.lateral_force / n_wheelsets();
    const bool   does = balance(0).loads_under(each).has_value();
    if (!does)
      reason = balance(0).reason;
    return does;
  }

  std::optional<Eigen::MatrixXd>
  RunningGear::compliance(const std::vector<Eigen::Matrix3d> &derivatives) const
  {
    const unsigned int n     = n_wheelsets();
    Eigen::MatrixXd    whole = Eigen::MatrixXd::Zero(3 * n, 3 * n);
    for (unsigned int i = 0; i < n; ++i)
      whole.block<3, 3>(3 * i, 3 * i) = derivatives[i];
    if (parameters.is_bogie)
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          whole.block<2, 2>(3 * i, 3 * j) -=
            frame.coupling(i) * frame.own().inverse() *
            frame.coupling(j).transpose() / parameters.axle_load;
    const auto solver = whole.fullPivLu();
    if (!solver.isInvertible())
      return {};
    return solver.inverse();
  }

  unsigned int RunningGear::n_states() const
  {
    unsigned int n = 0;
    for (const auto &one : wheelsets)
      n += one->pair.n_states;
    return n;
  }

  unsigned int RunningGear::n_bodies() const
  {
    unsigned int n = 0;
    for (const auto &one : wheelsets)
      n += one->pair.n_bodies();
    return n;
  }

  unsigned int RunningGear::n_steps() const
  {
    unsigned int n = 0;
    for (const auto &one : wheelsets)
      n += one->balance.n_steps;
    return n;
  }
} // namespace RollingContact
