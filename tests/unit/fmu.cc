#include <boost/test/unit_test.hpp>

#include "fmu_table.h"

#include <random>

/** What an FMU answers: the table of a wheel, both wheels of a wheelset. */
BOOST_AUTO_TEST_SUITE(fmu)

using namespace FmuTable;

namespace
{
  Coordinates random_within(std::mt19937 &random)
  {
    std::uniform_real_distribution<double> part(0., 1.);
    Coordinates                            point;
    for (std::size_t d = 0; d < n_axes; ++d)
      point[d] =
        axes[d].front() + part(random) * (axes[d].back() - axes[d].front());
    return point;
  }

  double force_error(const Quantities &a, const Quantities &b)
  {
    return std::sqrt(std::pow(a[force_x] - b[force_x], 2) +
                     std::pow(a[force_y] - b[force_y], 2) +
                     std::pow(a[force_z] - b[force_z], 2));
  }
} // namespace

BOOST_AUTO_TEST_CASE(parabolas_are_exact)
{
  const WheelTable table = table_of(smooth);
  std::mt19937     random(1);
  for (unsigned int k = 0; k < 200; ++k)
    {
      const Coordinates point = random_within(random);
      const TableValues found = table.at(point);
      BOOST_TEST(found.inside);
      const Quantities expected = smooth(point);
      for (std::size_t q = 0; q < n_quantities; ++q)
        if (q != force_bound)
          BOOST_TEST(std::abs(found.values[q] - expected[q]) <=
                     1e-9 * (1. + std::abs(expected[q])));
      BOOST_TEST(found.values[force_bound] >=
                 expected[force_bound] * (1 - 1e-12));
    }
}

BOOST_AUTO_TEST_CASE(states_are_exact_and_have_their_own_bound)
{
  const WheelTable  table = table_of(smooth);
  const Coordinates point{{1e-3, 0., 0.01, 60e3, 0.005, -0.02, 0.3}};
  const TableValues found = table.at(point);
  BOOST_TEST(force_error(found.values, smooth(point)) < 1e-8);
  BOOST_TEST(std::abs(found.values[force_bound] - 60.) < 1e-8);
}

BOOST_AUTO_TEST_CASE(the_bound_covers_kinks)
{
  for (const double kink : {-0.004, -0.001, 0.0012, 0.0025, 0.0041})
    {
      const auto law = [&](const Coordinates &x) {
        Quantities found = smooth(x);
        found[force_x] += 40 * x[load_axis] * std::abs(x[along_axis] - kink);
        return found;
      };
      const WheelTable table = table_of(law);
      std::mt19937     random(2);
      double           largest = 0.;
      for (unsigned int k = 0; k < 300; ++k)
        {
          Coordinates point = random_within(random);
          point[along_axis] *= 0.25;
          const TableValues found = table.at(point);
          const double      error = force_error(found.values, law(point));
          largest                 = std::max(largest, error / point[load_axis]);
          BOOST_TEST(error <= found.values[force_bound]);
        }
      BOOST_TEST(largest > 5e-3); // else nothing is tried
    }
}

BOOST_AUTO_TEST_CASE(the_bound_is_narrow_for_one_kink)
{
  // nothing but a kink in one interval, which the straight line is off by at
  // most s (1 - s) of it
  for (const double part : {0.1, 0.3, 0.5, 0.8})
    {
      const double kink = 0.005 * part;
      const auto   law  = [&](const Coordinates &x) {
        Quantities found{};
        found[force_x] = x[load_axis] * std::abs(x[along_axis] - kink);
        return found;
      };
      const WheelTable table = table_of(law);
      for (double t = 0.02; t < 1.; t += 0.02)
        {
          const Coordinates point{{0., 0., 0., 60e3, 0.005 * t, 0., 0.3}};
          const Quantities  found = table.at(point).values;
          BOOST_TEST(force_error(found, law(point)) <=
                     found[force_bound] * (1 + 1e-12));
          BOOST_TEST(found[force_bound] <=
                     60e3 * 2 * 0.005 * t * (1 - t) * 1.01);
        }
    }
}

BOOST_AUTO_TEST_CASE(beyond_the_axes_is_told)
{
  const WheelTable table = table_of(smooth);
  for (std::size_t d = 0; d < n_axes; ++d)
    {
      Coordinates point{{0., 0., 0., 60e3, 0., 0., 0.3}}, end = point;
      end[d]   = axes[d].back();
      point[d] = axes[d].back() * 1.001;
      BOOST_TEST(!table.at(point).inside);
      BOOST_TEST(table.at(end).inside);
      if (d != load_axis)
        BOOST_TEST(force_error(table.at(point).values, table.at(end).values) ==
                   0.);
    }
}

BOOST_AUTO_TEST_CASE(what_is_no_table_is_refused)
{
  const std::string good = model_of(table_of(smooth)).bytes();
  BOOST_TEST(WheelsetModel::of_bytes(good).bytes() == good);
  for (const std::string &bad : {std::string(),
                                 good.substr(0, 20),
                                 good.substr(0, good.size() - 8),
                                 good + "01234567",
                                 good.substr(0, good.size() - 3)})
    BOOST_CHECK_THROW(WheelsetModel::of_bytes(bad), std::invalid_argument);
  std::mt19937 random(3);
  for (unsigned int k = 0; k < 2000; ++k)
    {
      std::string changed = good;
      changed[random() % 800] ^= static_cast<char>(1 + random() % 255);
      try
        {
          WheelsetModel::of_bytes(changed).evaluate(start(), 0.1);
        }
      catch (const std::invalid_argument &)
        {}
    }
}

BOOST_AUTO_TEST_CASE(motions_follow_from_creepages)
{
  const WheelsetModel model = model_of(table_of(smooth));
  const WheelMotion   motion{2e-3, 0.02, -1.002 / radius};
  const WheelMotion   found =
    model.motion(model.creepages(motion, 0.01), motion.turn, 0.01);
  BOOST_TEST(std::abs(found.aside - motion.aside) < 1e-15);
  BOOST_TEST(std::abs(found.about_axle - motion.about_axle) < 1e-14);
  // a cone that rolls freely in a curve, its wheels at different radii
  const double      e = tape_circle, kappa = 0.01;
  const WheelMotion inner{0., kappa, -(1 - e * kappa) / radius};
  BOOST_TEST(std::abs(model.creepages(inner, 0.)[0]) < 1e-15);
}

BOOST_AUTO_TEST_CASE(inputs_of_a_state_have_its_values)
{
  // creepages along are counted from an offset of the shift
  const double        slope = 0.4;
  const WheelsetModel model = model_of(table_of(smooth, slope));
  const Coordinates   point{{2e-3, 1e-3, -0.01, 90e3, 0.005, 0.01, 0.3}};
  const WheelMotion   motion =
    model.motion({{0.3 * point[along_axis] + slope * point[shift_axis],
                   0.3 * point[across_axis]}},
                 point[turn_axis],
                 point[yaw_axis]);
  Inputs inputs            = start();
  inputs[lateral_shift]    = point[shift_axis];
  inputs[yaw]              = point[yaw_axis];
  inputs[lateral_velocity] = 20 * motion.aside;
  inputs[axle_speed]       = 20 * motion.about_axle;
  inputs[curvature]        = 0.5 * motion.turn;
  inputs[yaw_rate]         = 20 * 0.5 * motion.turn;
  inputs[right_load]       = point[load_axis];
  const WheelOutputs found = model.evaluate(inputs, 0.1).wheels[0];
  BOOST_TEST(found.inside);
  BOOST_TEST(force_error(found.values, smooth(point)) < 1e-6);
  BOOST_TEST(std::abs(found.values[force_bound] - 90.) < 1e-3);
}

BOOST_AUTO_TEST_CASE(both_sides_are_mirror_images)
{
  const WheelsetModel model = model_of(table_of(smooth, 0.5));
  Inputs              one   = start();
  one[lateral_shift]        = 7e-4;
  one[yaw]                  = 3e-4;
  one[lateral_velocity]     = 0.01;
  one[yaw_rate]             = 0.02;
  one[curvature]            = 1e-3;
  one[right_load]           = 70e3;
  one[left_rail_y]          = 2e-4;
  one[right_rail_z]         = 1e-4;
  Inputs other              = one;
  for (const Input k :
       {lateral_shift, yaw, lateral_velocity, yaw_rate, curvature})
    other[k] = -one[k];
  std::swap(other[right_load], other[left_load]);
  std::swap(other[right_rail_z], other[left_rail_z]);
  other[right_rail_y] = -one[left_rail_y];
  other[left_rail_y]  = -one[right_rail_y];
  const Outputs a = model.evaluate(one, 0.1), b = model.evaluate(other, 0.1);
  BOOST_TEST(a.roll == -b.roll);
  BOOST_TEST(a.roll != 0.);
  for (unsigned int wheel = 0; wheel < 2; ++wheel)
    for (std::size_t q = 0; q < n_quantities; ++q)
      {
        const bool is_odd = q == force_y || q == moment_x || q == moment_z ||
                            q == place_y || q == contact_angle;
        BOOST_TEST(a.wheels[wheel].values[q] ==
                   (is_odd ? -1 : 1) * b.wheels[1 - wheel].values[q]);
      }
  BOOST_TEST(a.wheels[0].inside);
}

BOOST_AUTO_TEST_CASE(rails_that_move_together_are_a_shift)
{
  const WheelsetModel model   = model_of(table_of(smooth, 0.5));
  Inputs              shifted = start(), moved = start();
  shifted[lateral_shift] = 5e-4;
  moved[right_rail_y] = moved[left_rail_y] = -5e-4;
  const Outputs a                          = model.evaluate(shifted, 0.1),
                b                          = model.evaluate(moved, 0.1);
  for (const unsigned int wheel : {0, 1})
    {
      BOOST_TEST(force_error(a.wheels[wheel].values, b.wheels[wheel].values) <
                 1e-9);
      BOOST_TEST(std::abs(a.wheels[wheel].values[place_y] -
                          b.wheels[wheel].values[place_y] - 5e-4) < 1e-15);
    }
  // one rail that is down rolls the wheelset, as does another shift
  moved                = start();
  moved[right_rail_z]  = 1e-4;
  const Outputs rolled = model.evaluate(moved, 0.1);
  BOOST_TEST(std::abs(rolled.roll - 1e-4 / (2 * tape_circle)) < 1e-15);
  // the contact goes to where the wheel is lower, as by a shift to the left of
  // the right-hand wheel and to the left of the left-hand one
  BOOST_TEST(rolled.wheels[0].values[place_y] > tape_circle + 1e-5);
  BOOST_TEST(rolled.wheels[1].values[place_y] > -tape_circle + 1e-5);
}

BOOST_AUTO_TEST_CASE(wheels_without_load_and_slow_ones)
{
  const WheelsetModel model  = model_of(table_of(smooth));
  Inputs              inputs = start();
  inputs[left_load]          = 0.;
  inputs[speed] = inputs[axle_speed] = 0.;
  const Outputs found                = model.evaluate(inputs, 0.1);
  BOOST_TEST(found.wheels[1].values[force_z] == 0.);
  BOOST_TEST(found.wheels[1].inside);
  BOOST_TEST(!found.wheels[0].inside);
  for (const double value : found.wheels[0].values)
    BOOST_TEST(std::isfinite(value));
  // at half of the least speed it rolls as at that, which is not its own
  inputs[speed]      = 0.05;
  inputs[axle_speed] = -0.1 / radius;
  BOOST_TEST(!model.evaluate(inputs, 0.1).wheels[0].inside);
  BOOST_TEST(model.evaluate(inputs, 0.1).wheels[0].values[force_bound] > 1e300);
  inputs[speed] = 0.1;
  BOOST_TEST(model.evaluate(inputs, 0.1).wheels[0].inside);
}

BOOST_AUTO_TEST_SUITE_END()
