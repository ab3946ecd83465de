#include <boost/test/unit_test.hpp>

#include "stability_bodies.h"

#include <rolling_contact/stability/threshold.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace RollingContact;
using namespace StabilityBodies;

/** Where a growth turns, by functions whose zeros are known. */
BOOST_AUTO_TEST_SUITE(thresholds)

namespace
{
  using Growth = std::function<double(double)>;

  Threshold threshold_of(const Growth          &growth,
                         const ThresholdSearch &search = {})
  {
    return first_threshold(
      growth(0.),
      [&](const double change) -> std::optional<double> {
        return growth(change);
      },
      search);
  }

  void holds(const Threshold &found, const double zero, const double width)
  {
    BOOST_TEST(found.crossed);
    BOOST_TEST(found.known);
    BOOST_TEST(found.before <= zero);
    BOOST_TEST(zero <= found.behind);
    BOOST_TEST(found.behind - found.before <= width * (1 + 1e-6));
  }
} // namespace

BOOST_AUTO_TEST_CASE(a_straight_line_takes_few_states)
{
  for (const double zero : {0.013, 0.25, 0.4, 0.77, 0.999})
    for (const double sign : {1., -1.})
      {
        const Threshold found =
          threshold_of([&](const double t) { return sign * 7 * (zero - t); });
        holds(found, zero, 0.01);
        BOOST_TEST((found.growth_before > 0.) == (sign > 0.));
        BOOST_TEST(std::abs(found.slope() + sign * 7) < 1e-9);
        BOOST_TEST(found.n_states <= 5u);
      }
}

BOOST_AUTO_TEST_CASE(curves_and_jumps_are_enclosed)
{
  const double zero = 0.31;
  // a last node that sticks: the growth jumps to another value
  const double sides[][2] = {{8., -1.3}, {1e-3, -40.}, {40., -1e-3}};
  for (const auto &side : sides)
    {
      const Threshold found = threshold_of(
        [&](const double t) { return t < zero ? side[0] : side[1]; });
      holds(found, zero, 0.01);
      BOOST_TEST(found.n_states < 20u);
    }
  // a curve whose secants all end on one side of its zero, as a line would
  const Threshold bent = threshold_of(
    [&](const double t) { return std::sqrt(2.) - std::sqrt(1 + t / zero); });
  holds(bent, zero, 0.01);
  BOOST_TEST(bent.n_states <= 5u);
  holds(threshold_of([&](const double t) {
          return std::pow(zero / (t + 0.01), 6) -
                 std::pow(zero / (zero + 0.01), 6);
        }),
        zero,
        0.01);
  for (const double width : {0.1, 1e-3, 1e-6})
    {
      const Threshold found = threshold_of(
        [&](const double t) { return std::cos(t / zero) - std::cos(1.); },
        {0.25, 1., width});
      holds(found, zero, width);
      BOOST_TEST(found.n_states < 30u);
    }
  // the first of two that steps tell apart
  holds(threshold_of([](const double t) { return (t - 0.3) * (t - 0.7); }),
        0.3,
        0.01);
}

BOOST_AUTO_TEST_CASE(what_never_turns_or_is_not_known)
{
  const Threshold never = threshold_of([](const double t) { return 1 + t; });
  BOOST_TEST(!never.crossed);
  BOOST_TEST(never.known);
  BOOST_TEST(never.behind == 1.);
  BOOST_TEST(never.n_states == 3u);
  // no growth of exactly zero
  BOOST_TEST(!threshold_of([](double) { return 0.; }).crossed);

  std::vector<double> asked;
  const auto          known_up_to = [&](const double last) {
    asked.clear();
    return first_threshold(1., [&](const double t) -> std::optional<double> {
      asked.push_back(t);
      if (t > last)
        return {};
      return 0.9 - t;
    });
  };
  const Threshold unknown = known_up_to(0.6);
  BOOST_TEST(!unknown.crossed);
  BOOST_TEST(!unknown.known);
  BOOST_TEST(unknown.behind == 1.);
  BOOST_TEST(asked.size() == 3u);
  BOOST_TEST(known_up_to(1.).crossed);
  // an interval without states between two that are known
  const Threshold gap =
    first_threshold(1., [](const double t) -> std::optional<double> {
      if (t > 0.26 && t < 0.49)
        return {};
      return 0.38 - t;
    });
  BOOST_TEST(!gap.crossed);
  BOOST_TEST(!gap.known);
}

/** Modes that follow are as soft as before at rest; the others are as they
 * were. */
BOOST_AUTO_TEST_CASE(fast_modes_follow)
{
  const Grid         grid{5, 3};
  const unsigned int m    = 14;
  ReducedPair        pair = random_pair(grid, m, 6);
  std::swap(pair.K_m(1, 1), pair.K_m(m - 2, m - 2));
  std::vector<double> stiffness;
  for (unsigned int k = 0; k < m; ++k)
    stiffness.push_back(pair.K_m(k, k));
  std::sort(stiffness.begin(), stiffness.end());
  for (const unsigned int n : {0u, 5u, m})
    {
      const double highest =
        std::sqrt(n == 0   ? stiffness[0] / 2
                  : n == m ? stiffness[m - 1] * 2
                           : (stiffness[n - 1] + stiffness[n]) / 2);
      const CondensedPair slow = condensed(pair, highest);
      BOOST_TEST(slow.kept.size() == n);
      BOOST_TEST(slow.pair.n_modes() == n);
      check(slow.pair);
      unsigned int of_wheel = 0;
      for (unsigned int k = 0; k < n; ++k)
        {
          BOOST_TEST(slow.pair.K_m(k, k) ==
                     pair.K_m(slow.kept[k], slow.kept[k]));
          BOOST_TEST(slow.pair.K_m(k, k) < highest * highest);
          of_wheel += slow.kept[k] < pair.n_wheel_modes;
        }
      BOOST_TEST(slow.pair.n_wheel_modes == of_wheel);
      BOOST_TEST(slow.pair.retardation == pair.retardation);
      const DenseMatrix before = static_compliance(pair);
      BOOST_TEST((static_compliance(slow.pair) - before).norm() <
                 1e-12 * before.norm());
      std::vector<double> ones(n, 1.);
      const auto          all = slow.expanded(ones, m);
      BOOST_TEST(all.size() == m);
      for (unsigned int k = 0; k < m; ++k)
        BOOST_TEST(all[k] == (pair.K_m(k, k) < highest * highest ? 1. : 0.));
    }
}

BOOST_AUTO_TEST_SUITE_END()
