#include <deal.II/lac/vector.h>

#include <boost/test/unit_test.hpp>

#include "time_run.h"

#include <rolling_contact/base/text.h>

#include <array>
#include <cmath>

using namespace RollingContact;

BOOST_AUTO_TEST_SUITE(order_in_time)

namespace
{
  /** What two discs have done: forces over mu N and heat after each step. */
  struct History
  {
    double                             step = 0., lag = 0.;
    std::vector<std::array<double, 2>> forces;
    std::vector<double>                heat;
  };

  using Change = std::function<void(SceneParameters &)>;

  template <int dim>
  History history(const Change &change, const double step, const double end)
  {
    TimeRun<dim> run([&](SceneParameters &scene) {
      change(scene);
      scene.time.time_step = step;
    });
    History      result;
    result.step = step;
    double heat = 0.;
    for (long k = 0; k < std::lround(end / step); ++k)
      {
        run.march(1);
        heat += run.last.friction;
        result.lag             = run.last.force_lag;
        const Resultants &now  = run.stepper->current().result;
        const double      size = 0.3 * now.normal_force;
        result.forces.push_back({{now.force_x / size, now.force_y / size}});
        result.heat.push_back(heat);
      }
    return result;
  }

  /** By the parabola through the next three of values at h, 2h, ... - lag. */
  template <typename Value>
  double interpolated(const History &of, const double time, const Value &value)
  {
    const double place = (time + of.lag) / of.step - 1;
    const long   last  = of.forces.size() - 1,
               middle  = std::min(std::max(std::lround(place), 1l), last - 1);
    const double s     = place - middle;
    return s * (s - 1) / 2 * value(middle - 1) + (1 - s * s) * value(middle) +
           s * (s + 1) / 2 * value(middle + 1);
  }

  /** Root mean square of the error of the forces. */
  double force_error(const History &run, const History &exact)
  {
    double sum = 0.;
    for (std::size_t k = 0; k < run.forces.size(); ++k)
      for (unsigned int c = 0; c < 2; ++c)
        sum +=
          std::pow(run.forces[k][c] - interpolated(exact,
                                                   (k + 1) * run.step - run.lag,
                                                   [&](const long i) {
                                                     return exact.forces[i][c];
                                                   }),
                   2);
    return std::sqrt(sum / run.forces.size());
  }

  double heat_error(const History &run, const History &exact)
  {
    return std::abs(run.heat.back() / exact.heat.back() - 1);
  }
} // namespace

/**
 * Without inertia, by BDF2, with and without the edge law.
 */
BOOST_AUTO_TEST_CASE(massless_rolling_is_of_second_order)
{
  for (const auto slip_operator :
       {SlipOperatorKind::upwind_2, SlipOperatorKind::calibrated})
    {
      const Change change = [=](SceneParameters &scene) {
        oscillates(scene);
        scene.contact.slip_operator = slip_operator;
      };
      const double  end    = 1.6e-3;
      const History exact  = history<2>(change, 2e-6, end);
      const History coarse = history<2>(change, 32e-6, end),
                    fine   = history<2>(change, 16e-6, end);
      const double force   = std::log2(force_error(coarse, exact) /
                                     force_error(fine, exact)),
                   heat    = std::log2(heat_error(coarse, exact) /
                                    heat_error(fine, exact));
      BOOST_TEST_MESSAGE("errors " << force_error(coarse, exact) << ' '
                                   << force_error(fine, exact) << " orders "
                                   << force << ' ' << heat);
      BOOST_TEST(force > 1.8);
      BOOST_TEST(heat > 1.8);
    }
}

/**
 * From rest, where the first step is one of Euler's rule.
 */
BOOST_AUTO_TEST_CASE(start_up_is_of_second_order)
{
  const Change change = [](SceneParameters &scene) {
    scene.contact.creepages.x = 0.001;
    scene.time.initial_state  = InitialState::rest;
  };
  const double  end   = 1.28e-3;
  const History exact = history<2>(change, 2e-6, end);
  const auto    error = [&](const double step) {
    return std::abs(history<2>(change, step, end).forces.back()[0] -
                    exact.forces.back()[0]);
  };
  const double coarse = error(64e-6), fine = error(32e-6);
  BOOST_TEST_MESSAGE("errors " << coarse << ' ' << fine);
  BOOST_TEST(std::log2(coarse / fine) > 1.8);
}

/**
 * With inertia and theta = 0.5 forces act in the middle of a step, friction
 * with the slip there. The creepage begins so smoothly that no wave has a kink.
 */
BOOST_AUTO_TEST_CASE(rolling_with_inertia_is_of_second_order)
{
  const Change change = [=](SceneParameters &scene) {
    oscillates(scene);
    scene.time.inertia    = true;
    scene.time.creepage_x = "0.001 + 0.0008 * sin(2 * pi * 1000 * t)^4";
  };
  const double  end    = 0.8e-3;
  const History exact  = history<2>(change, 1e-6, end);
  const History coarse = history<2>(change, 16e-6, end),
                fine   = history<2>(change, 8e-6, end);
  BOOST_TEST(fine.lag == 4e-6, boost::test_tools::tolerance(1e-12));
  const double force = std::log2(force_error(coarse, exact) /
                                 force_error(fine, exact)),
               heat =
                 std::log2(heat_error(coarse, exact) / heat_error(fine, exact));
  BOOST_TEST_MESSAGE("errors " << force_error(coarse, exact) << ' '
                               << force_error(fine, exact) << " orders "
                               << force << ' ' << heat);
  BOOST_TEST(force > 1.8);
  BOOST_TEST(heat > 1.8);
}

/**
 * In 3D the direction of friction turns.
 */
BOOST_AUTO_TEST_CASE(turning_friction_with_inertia_is_of_second_order)
{
  const Change change = [](SceneParameters &scene) {
    oscillates(scene);
    scene.time.inertia        = true;
    scene.contact.creepages.y = 0.003;
    scene.time.creepage_x     = "0.004 * sin(2 * pi * 2e3 * t)";
  };
  const double  end    = 0.16e-3;
  const History exact  = history<3>(change, 0.5e-6, end);
  const History coarse = history<3>(change, 8e-6, end),
                fine   = history<3>(change, 4e-6, end);
  const double force =
    std::log2(force_error(coarse, exact) / force_error(fine, exact));
  BOOST_TEST_MESSAGE("errors " << force_error(coarse, exact) << ' '
                               << force_error(fine, exact) << " order "
                               << force);
  BOOST_TEST(force > 1.8);
}

/**
 * A shift in one step, then rest: nothing of it goes on, and its heat is that
 * of its own step.
 */
BOOST_AUTO_TEST_CASE(what_jumps_does_not_go_on)
{
  TimeRun<2> run([](SceneParameters &scene) {
    scene.contact.creepages.x = 1.;
    scene.contact.speed       = 1e-3;
    scene.time.initial_state  = InitialState::rest;
    scene.time.creepage_x     = "if(t < 2.5e-4, 150, 0)";
  });
  const auto forces = run.march(2);
  BOOST_TEST(forces[1] < -0.3);
  BOOST_TEST(forces[1] > -0.95);
  const double stored = run.stepper->bodies().stored_energy();
  for (unsigned int k = 0; k < 3; ++k)
    {
      BOOST_TEST(run.march(1)[0] == forces[1],
                 boost::test_tools::tolerance(1e-3));
      BOOST_TEST(std::abs(run.last.friction) < 1e-4 * stored);
    }
}

/**
 * Steps of changing length: halves and doubles of each other.
 */
BOOST_AUTO_TEST_CASE(steps_of_changing_length_are_of_second_order)
{
  const double end        = 1.6e-3;
  const auto   force_with = [&](const double step, const bool changing) {
    TimeRun<2> run([&](SceneParameters &scene) {
      oscillates(scene);
      scene.time.time_step = step;
    });
    double     time = 0.;
    for (unsigned int k = 0; time < end * (1 - 1e-9); ++k)
      {
        const double h = changing && k % 3 != 0 ? step / 2 : step;
        run.stepper->advance(time, h);
        time += h;
      }
    return run.force_x();
  };
  const double exact  = force_with(2e-6, false);
  const double coarse = std::abs(force_with(64e-6, true) - exact),
               fine   = std::abs(force_with(32e-6, true) - exact);
  BOOST_TEST_MESSAGE("errors " << coarse << ' ' << fine);
  BOOST_TEST(std::log2(coarse / fine) > 1.8);
}

BOOST_AUTO_TEST_SUITE_END()
