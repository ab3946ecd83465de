#include <boost/math/tools/roots.hpp>

#include <rolling_contact/base/text.h>
#include <rolling_contact/wheelset/equilibrium.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  std::optional<WheelsetState> Equilibrium::at_shift(const CurveCase &acting,
                                                     const double     shift,
                                                     const WheelsetState &start)
  {
    WheelsetState from = start;
    from.place.shift   = shift;
    return newton_or_held(acting, all(false), from, 0.3 * enough);
  }

  bool Equilibrium::bracket(const CurveCase     &acting,
                            const WheelsetState &start,
                            const double         farthest)
  {
    if (wheelset.shift || wheelset.yaw)
      return false;
    jacobian.reset();
    auto inner = at_shift(acting, start.place.shift, start);
    if (!inner)
      return false;
    // a wheelset that is pushed to the right goes there
    const double direction = inner->residual[0] > 0. ? 1. : -1.;
    double       step      = 5e-5;
    auto         outer     = inner;
    while (outer->residual[0] * direction > 0.)
      {
        if (std::abs(outer->place.shift - start.place.shift) > farthest)
          return false;
        auto next =
          at_shift(acting, outer->place.shift + direction * step, *outer);
        if (!next)
          {
            step /= 4;
            if (step < 1e-6)
              return false;
            continue;
          }
        inner = outer;
        outer = next;
        step  = std::min(1.5 * step, 4e-4);
      }
    WheelsetState best =
      std::abs(inner->residual[0]) < std::abs(outer->residual[0]) ? *inner
                                                                  : *outer;
    bool       lost = false;
    const auto left = [&](const double shift) {
      const auto found = at_shift(acting, shift, best);
      if (!found)
        {
          lost = true;
          return 0.;
        }
      if (std::abs(found->residual[0]) < std::abs(best.residual[0]))
        best = *found;
      return std::abs(found->residual[0]) < 0.5 * enough ? 0.
                                                         : found->residual[0];
    };
    std::uintmax_t rounds = 40;
    boost::math::tools::toms748_solve(
      left,
      std::min(inner->place.shift, outer->place.shift),
      std::max(inner->place.shift, outer->place.shift),
      direction > 0. ? inner->residual[0] : outer->residual[0],
      direction > 0. ? outer->residual[0] : inner->residual[0],
      [](const double a, const double b) { return std::abs(a - b) < 1e-11; },
      rounds);
    jacobian.reset();
    if (lost || best.largest_residual() > std::max(accepted, enough))
      {
        if (!lost)
          reason = "the lateral forces jump by " +
                   significant(best.largest_residual(), 2) +
                   " of the axle load at a shift of " +
                   millimetres(best.place.shift, 6);
        return false;
      }
    state = best;
    return true;
  }
} // namespace RollingContact
