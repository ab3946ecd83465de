#include <deal.II/lac/vector.h>

#include <boost/test/unit_test.hpp>

#include "complaint.h"
#include "reduced_run.h"
#include "vibrating_pair.h"

#include <rolling_contact/time/hub_motion.h>

#include <cmath>

using namespace RollingContact;

/** Bodies by their modes whose hub is moved by the approach. */
BOOST_AUTO_TEST_SUITE(hub_motion)

namespace
{
  DrivingFunctions driven_by(const std::optional<TimeFunction> &approach)
  {
    const TimeFunction none(0.);
    return {{}, approach, none, none, none, none, {}, {}, {}, {}};
  }

  DrivingFunctions driven_by(const std::string &approach)
  {
    return driven_by(TimeFunction("Time/Approach", approach, ""));
  }
} // namespace

BOOST_AUTO_TEST_CASE(a_parabola_has_one_acceleration)
{
  const auto fall = driven_by("1e-4 + 0.02 * t + 3 * t^2");
  for (unsigned int k = 0; k < 10; ++k)
    BOOST_TEST(hub_acceleration_within(fall, k * 1e-3, 1e-3) == 6.,
               boost::test_tools::tolerance(1e-6));
  // steps that are halved in between
  BOOST_TEST(hub_acceleration_within(fall, 4e-3, 5e-4) == 6.,
             boost::test_tools::tolerance(1e-6));
  BOOST_TEST(hub_acceleration_within(driven_by("1e-4"), 1., 1e-3) == 0.);
  BOOST_TEST(hub_acceleration_within(driven_by(std::nullopt), 1., 1e-3) == 0.);
}

BOOST_AUTO_TEST_CASE(the_acceleration_is_that_of_the_middle_of_a_step)
{
  const auto wave = driven_by("1e-3 * sin(40 * t)");
  double     errors[2];
  for (unsigned int k = 0; k < 2; ++k)
    {
      const double h = 1e-3 / (1 << k), t = 20e-3;
      errors[k] =
        hub_acceleration_within(wave, t, h) + 1.6 * std::sin(40 * (t + h / 2));
    }
  BOOST_TEST(std::abs(errors[1]) < 1e-3);
  BOOST_TEST(std::log2(errors[0] / errors[1]) == 2.,
             boost::test_tools::tolerance(0.05));
}

/** Bodies that are caught by a hub that stops, or moved by one that starts. */
BOOST_AUTO_TEST_CASE(kinks_of_the_approach_change_the_velocity_once)
{
  const double h = 1e-3;
  for (const double at : {1.2e-3, 2e-3, 5.5e-3, 6.9e-3})
    {
      const auto ramp = driven_by(
        TimeFunction("Time/Approach",
                     {{0., 0.}, {at, 0.5 * at}, {at + 1., 0.5 * at + 0.2}}));
      double change = 0.;
      for (unsigned int k = 0; k < 12; ++k)
        change += h * hub_acceleration_within(ramp, k * h, h);
      BOOST_TEST(change == 0.2 - 0.5, boost::test_tools::tolerance(1e-9));
    }
}

/**
 * One mode on a hub that accelerates: the displacement relative to the hub is
 * that of a mass on a spring under the load -g a.
 */
BOOST_AUTO_TEST_CASE(a_mode_follows_its_hub)
{
  ReducedPair pair;
  pair.K_m = pair.C_m = DenseMatrix::Zero(1, 1);
  pair.Phi            = DenseMatrix::Zero(1, 1);
  pair.W_res          = DenseMatrix::Zero(1, 1);
  pair.n_wheel_modes  = 1;
  const double omega = 2000., rate = 700., mass = 3.; // kg
  pair.K_m(0, 0)   = omega * omega;
  pair.Phi(0, 0)   = 1 / std::sqrt(mass);
  pair.W_res(0, 0) = 1e-9;
  // approach 1e-5 (1 - cos(rate t)), so that a = 1e-5 rate^2 cos(rate t)
  const auto driving = driven_by("1e-5 * (1 - cos(700 * t))");
  const auto error   = [&](const unsigned int n) {
    ReducedMotion motion(pair);
    motion.set_hub_inertia({-std::sqrt(mass)});
    const double h = 5e-3 / n;
    motion.set_time_step(h);
    double worst = 0., balance = 0.;
    for (unsigned int k = 0; k < n; ++k)
      {
        motion.begin_step(true, hub_acceleration_within(driving, k * h, h));
        balance += std::abs(motion.end_step({0.}).balance_error);
        const double t = (k + 1) * h,
                     u = -1e-5 * rate * rate / (omega * omega - rate * rate) *
                         (std::cos(rate * t) - std::cos(omega * t));
        worst = std::max(worst,
                         std::abs(motion.state().eta[0] / std::sqrt(mass) - u));
      }
    BOOST_TEST(balance <
               1e-11 * (motion.energy().kinetic + motion.energy().strain));
    return worst;
  };
  const double coarse = error(500), fine = error(1000);
  BOOST_TEST(fine < 1e-3 * 1e-5 * rate * rate / (omega * omega));
  BOOST_TEST(std::log2(coarse / fine) == 2.,
             boost::test_tools::tolerance(0.05));

  ReducedMotion motion(pair);
  BOOST_TEST(contains(complaint([&]() {
                        motion.set_hub_inertia({1., 2.});
                      }),
                      "2 values, the bodies have 1 modes"));
}

/** Modal masses for motions along z: together the mass that is not held. */
BOOST_AUTO_TEST_CASE(modes_have_the_mass_of_the_wheel)
{
  const VibratingPair::Eigenvalues<2> pair(
    [](SceneParameters &scene) {
      VibratingPair::disc_on_pad(scene);
      scene.wheel.lateral_radius       = 0.;
      scene.mesh.elements_across_patch = 6;
      scene.contact.approach           = 5e-5;
      scene.contact.creepages.x        = 0.05;
    },
    60e3);
  const std::vector<double> g     = pair.rolling->hub_inertia();
  const auto               *wheel = pair.bodies->body(Side::wheel);
  const std::vector<double> rise  = wheel->body->uniform(1, 1.);
  std::vector<double>       moved(rise.size());
  wheel->M.multiply(rise, moved);
  const std::size_t n_wheel = pair.bodies->n_modes(Side::wheel);
  double            sum     = 0.;
  for (std::size_t k = 0; k < n_wheel; ++k)
    sum += g[k] * g[k];
  BOOST_TEST(sum == dot(moved, rise), boost::test_tools::tolerance(0.05));
  BOOST_TEST(sum < dot(moved, rise));
  for (std::size_t k = n_wheel; k < g.size(); ++k)
    BOOST_TEST(g[k] == 0.);
}

BOOST_AUTO_TEST_SUITE_END()
