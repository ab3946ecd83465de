#include <rolling_contact/evolution/running_surfaces.h>
#include <rolling_contact/surfaces/wear_deposit.h>
#include <rolling_contact/surfaces/worn_profile.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /// m, of points: several for each line of nodes
    const double largest_distance = 0.1e-3;
  } // namespace

  RunningSurfaces::RunningSurfaces(const std::vector<Side>     &sides,
                                   const std::array<double, 2> &radii,
                                   const double                 tape_circle)
    : radii(radii)
    , tape_circle(tape_circle)
  {
    for (const Side &side : sides)
      this->sides.push_back(
        {{Profiles::subdivided(side[0], largest_distance),
          Profiles::subdivided(side[1], largest_distance)}});
    make_pairs();
  }

  bool RunningSurfaces::has_curves(const std::vector<Side> &curves) const
  {
    const auto are_equal = [](const auto &a, const auto &b) {
      return std::equal(a.points().begin(),
                        a.points().end(),
                        b.points().begin(),
                        b.points().end(),
                        [](const auto &one, const auto &other) {
                          return one.y == other.y && one.z == other.z;
                        });
    };
    return std::equal(sides.begin(),
                      sides.end(),
                      curves.begin(),
                      curves.end(),
                      [&](const Side &a, const Side &b) {
                        return are_equal(a[0], b[0]) && are_equal(a[1], b[1]);
                      });
  }

  RunningSurfaces RunningSurfaces::with(const std::vector<Side> &curves) const
  {
    RunningSurfaces other = *this;
    other.sides           = curves;
    other.make_pairs();
    return other;
  }

  void RunningSurfaces::make_pairs()
  {
    const auto pair_of = [&](const unsigned int wheel) {
      const Side &side = sides[side_of(wheel)];
      return std::make_shared<const Profiles::WheelOnRail>(side[0],
                                                           side[1],
                                                           radii[wheel],
                                                           tape_circle);
    };
    both[0] = pair_of(0);
    both[1] = sides.size() == 1 ? both[0] : pair_of(1);
  }

  RunningSurfaces::Amounts RunningSurfaces::nothing() const
  {
    Amounts none;
    for (const Side &side : sides)
      none.push_back({{std::vector<double>(side[0].points().size(), 0.),
                       std::vector<double>(side[1].points().size(), 0.)}});
    return none;
  }

  std::vector<double> RunningSurfaces::depths(const Amounts     &amounts,
                                              const std::size_t  side,
                                              const unsigned int body) const
  {
    return Profiles::depths_of(sides[side][body], amounts[side][body]);
  }

  double RunningSurfaces::largest_depth(const Amounts     &amounts,
                                        const std::size_t  side,
                                        const unsigned int body) const
  {
    double largest = 0.;
    for (const double depth : depths(amounts, side, body))
      largest = std::max(largest, std::abs(depth));
    return largest;
  }

  double RunningSurfaces::largest_depth(const Amounts &amounts) const
  {
    double largest = 0.;
    for (std::size_t side = 0; side < sides.size(); ++side)
      for (unsigned int body = 0; body < 2; ++body)
        largest = std::max(largest, largest_depth(amounts, side, body));
    return largest;
  }

  double RunningSurfaces::misplaced_depth(const Amounts &difference,
                                          const Amounts &amounts) const
  {
    const auto sum_of = [](const std::vector<double> &values) {
      double sum = 0.;
      for (const double value : values)
        sum += std::abs(value);
      return sum;
    };
    double largest = 0.;
    for (std::size_t side = 0; side < sides.size(); ++side)
      for (unsigned int body = 0; body < 2; ++body)
        {
          const double all = sum_of(amounts[side][body]);
          if (all > 0.)
            largest = std::max(largest,
                               sum_of(difference[side][body]) / all *
                                 largest_depth(amounts, side, body));
        }
    return largest;
  }

  RunningSurfaces RunningSurfaces::worn(const Amounts &amounts) const
  {
    std::vector<Side> next = sides;
    for (std::size_t side = 0; side < sides.size(); ++side)
      for (unsigned int body = 0; body < 2; ++body)
        next[side][body] = Profiles::worn(sides[side][body],
                                          wheel_and_rail[body],
                                          amounts[side][body]);
    return with(next);
  }

  RunningSurfaces::Amounts sum(RunningSurfaces::Amounts        a,
                               const double                    factor,
                               const RunningSurfaces::Amounts &b)
  {
    for (std::size_t side = 0; side < a.size(); ++side)
      for (unsigned int body = 0; body < 2; ++body)
        for (std::size_t k = 0; k < a[side][body].size(); ++k)
          a[side][body][k] += factor * b[side][body][k];
    return a;
  }
} // namespace RollingContact
