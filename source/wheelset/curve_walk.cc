#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/wheelset/curve_walk.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    const double       growth = 1.6, shrinking = 3.;
    const double       smallest_share = 1e-3; ///< of the way
    const double       far_away       = 4e-3; ///< m, of a bracketed shift
    const unsigned int most_failures  = 12;
    const double       passing        = 1e-3; ///< residual

    std::string name_of(const CurveCase &acting)
    {
      return acting.curvature == 0.
               ? "straight track"
               : "R = " + significant(1 / acting.curvature, 4) + " m";
    }
  } // namespace

  void CurveWalk::begin()
  {
    const RunningState rest = gear.at_rest();
    if (!gear.solve(rest) && !gear.bracket(rest, 2 * far_away))
      throw ConvergenceError(
        "Wheelset on straight track without forces: " + gear.reason + ".");
    last = {gear.now()};
  }

  RunningState CurveWalk::predicted(const CurveCase &acting) const
  {
    RunningState start = last.back();
    start.acting       = acting;
    if (last.size() < 2)
      return start;
    const RunningState &one = last[0], &two = last[1];
    const double        before = two.acting.curvature - one.acting.curvature,
                 next          = acting.curvature - two.acting.curvature;
    if (before == 0.)
      return start;
    const double share = std::clamp(next / before, 0., 2.);
    const auto   go_on =
      [&](double &value, const double from, const double most) {
        value += std::clamp(share * (value - from), -most, most);
      };
    for (unsigned int i = 0; i < start.wheelsets.size(); ++i)
      {
        WheelsetPlace       &place = start.wheelsets[i].place;
        const WheelsetPlace &from  = one.wheelsets[i].place;
        go_on(place.shift, from.shift, 1e-3);
        go_on(place.yaw, from.yaw, 2e-3);
        go_on(place.excess, from.excess, 1e-3);
        for (unsigned int k = 0; k < 2; ++k)
          go_on(place.rails[k], from.rails[k], 5e-4);
      }
    for (unsigned int k = 0; k < 2; ++k)
      go_on(start.frame[k], one.frame[k], 2e-3);
    return start;
  }

  bool CurveWalk::step_to(const CurveCase &acting)
  {
    if (!gear.solve(predicted(acting)))
      return false;
    last.push_back(gear.now());
    if (last.size() > 2)
      last.erase(last.begin());
    return true;
  }

  void CurveWalk::go_to(const CurveCase &target, const double residual)
  {
    if (!gear.carries(target))
      throw ConvergenceError("Wheelset, " + name_of(target) + ": " +
                             gear.reason + '.');
    const CurveCase from = last.back().acting;
    const double    way  = std::abs(target.curvature - from.curvature);
    double          step = way > 0. ? std::min(1., curvature_step / way) : 1.;
    unsigned int    n_failures = 0;
    for (double share = 0.; share < 1.;)
      {
        const double    next   = std::min(1., share + step);
        const CurveCase acting = CurveCase::between(from, target, next);
        gear.ask_for(next < 1. ? passing : residual);
        bool done = step_to(acting);
        if (!done && (step < 30 * smallest_share || n_failures >= 3))
          {
            RunningState start = last.back();
            start.acting       = acting;
            done               = gear.bracket(start, far_away);
            if (done)
              last = {gear.now()};
          }
        if (done)
          {
            share = next;
            step *= growth;
            n_failures = 0;
            continue;
          }
        step /= shrinking;
        if (++n_failures > most_failures || step < smallest_share)
          throw ConvergenceError(
            "Wheelset, " + name_of(target) +
            ": no equilibrium was found beyond " +
            name_of(CurveCase::between(from, target, share)) +
            " on the way from straight track, where its shift is " +
            millimetres(last.back().wheelsets[0].place.shift, 4) +
            " and its yaw " +
            significant(1e3 * last.back().wheelsets[0].place.yaw, 4) +
            " mrad: " + gear.reason +
            (gear.balance(0).is_free()
               ? ". A free wheelset has none in narrow curves; give "
                 "Wheelset/Yaw stiffness."
               : "."));
        // what was found last, and derivatives there
        gear.begin_with(last.back());
      }
    if (way > 0.)
      curvature_step = std::max(curvature_step, std::min(step, 1.) * way);
  }
} // namespace RollingContact
