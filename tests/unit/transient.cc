#include <deal.II/lac/vector.h>

#include <boost/test/unit_test.hpp>

#include "time_run.h"

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/time/march.h>

#include <array>
#include <cmath>

using namespace RollingContact;

BOOST_AUTO_TEST_SUITE(transient)

namespace
{
  void with_inertia(SceneParameters &scene)
  {
    scene.time.inertia          = true;
    scene.time.initial_state    = InitialState::steady;
    scene.time.time_step        = 1e-6;
    scene.contact.creepages.x   = 0.001;
    scene.contact.slip_operator = SlipOperatorKind::upwind_2;
  }
} // namespace

/**
 * Without inertia, rolling at constant creepage ends in the state of the steady
 * solver, with every slip operator.
 */
BOOST_AUTO_TEST_CASE(start_up_ends_in_the_steady_state)
{
  for (const auto slip_operator : {SlipOperatorKind::calibrated,
                                   SlipOperatorKind::upwind_2,
                                   SlipOperatorKind::upwind_1})
    {
      const auto change = [&](SceneParameters &scene) {
        scene.contact.creepages.x   = 0.001;
        scene.contact.slip_operator = slip_operator;
      };
      TimeRun<2>        run(change);
      const auto        forces = run.march(200);
      const SceneRun<2> steady(standard<2>, change);
      BOOST_TEST(std::abs(forces.front()) < 0.3 * std::abs(steady.force_x()));
      BOOST_TEST(std::abs(forces.back() - steady.force_x()) < 1e-4);
    }
}

/**
 * A march takes the steps that are left, ends where the motion has settled, and
 * each observer sees each step with the progress that includes it.
 */
BOOST_AUTO_TEST_CASE(observers_see_each_step_of_a_march)
{
  const auto change = [](SceneParameters &scene) {
    scene.contact.creepages.x = 0.001;
    scene.time.creepage_x     = "0.001 + 2 * t";
  };
  const double        h = 1e-4;
  TimeRun<2>          by_hand(change), marched(change);
  std::vector<double> expected, forces, times;
  for (unsigned int k = 0; k < 4; ++k)
    {
      by_hand.stepper->advance(1e-4 + (2 + k) * h, h);
      expected.push_back(by_hand.force_x());
    }
  TransientProgress progress;
  progress.step        = 2;
  double     distance  = 0.;
  const auto see_force = [&](const StepOutcome &outcome) {
    forces.push_back(marched.force_x());
    distance += std::abs(outcome.speed) * h;
  };
  const auto see_time = [&](const StepOutcome &) {
    BOOST_TEST(times.size() + 1 == forces.size());
    times.push_back(progress.time);
    BOOST_TEST(progress.step == 2 + times.size());
  };
  MarchedSteps steps{{h, 9}, 1e-4, 2};
  steps.settled = [&]() { return times.size() == 4; };
  march(steps, *marched.stepper, progress, {see_force, see_time});
  BOOST_TEST(forces == expected, boost::test_tools::per_element());
  BOOST_REQUIRE(times.size() == 4u);
  BOOST_TEST(times.front() == 1e-4 + 3 * h);
  BOOST_TEST(times.back() == 1e-4 + 6 * h);
  BOOST_TEST(progress.rolled_distance == distance);
  steps.settled      = {};
  steps.steps.number = 7;
  steps.done         = 6;
  march(steps, *marched.stepper, progress, {see_force, see_time});
  BOOST_TEST(times.back() == 1e-4 + 7 * h);
}

/**
 * The steady state as the initial state stays put, with and without inertia, in
 * 2D and 3D.
 */
BOOST_AUTO_TEST_CASE(steady_states_stay_put)
{
  const auto drift = [](auto run) {
    const auto forces = run->march(200);
    double     worst  = 0.;
    for (const double force : forces)
      worst = std::max(worst, std::abs(force - forces.front()));
    BOOST_TEST(std::abs(forces.front()) > 0.1);
    return worst;
  };
  BOOST_TEST(drift(std::make_unique<TimeRun<2>>(with_inertia)) < 1e-8);
  BOOST_TEST(drift(std::make_unique<TimeRun<2>>([](SceneParameters &scene) {
               scene.time.initial_state  = InitialState::steady;
               scene.contact.creepages.x = 0.001;
             })) < 1e-8);
  BOOST_TEST(drift(std::make_unique<TimeRun<3>>([](SceneParameters &scene) {
               with_inertia(scene);
               scene.contact.creepages.y = 0.001;
             })) < 1e-8);
}

/**
 * Without inertia only the rolled distance counts.
 */
BOOST_AUTO_TEST_CASE(massless_rolling_does_not_know_its_speed)
{
  const auto forces_at = [](const double speed) {
    return TimeRun<2>([=](SceneParameters &scene) {
             scene.contact.creepages.x = 0.001;
             scene.contact.speed       = speed;
             scene.time.time_step      = 1e-3 / speed;
           })
      .march(20);
  };
  const auto slow = forces_at(0.01), fast = forces_at(100.);
  for (std::size_t k = 0; k < slow.size(); ++k)
    BOOST_TEST(slow[k] == fast[k], boost::test_tools::tolerance(1e-9));
}

/**
 * With theta = 0.5 nothing but friction takes energy, and the balance closes.
 */
BOOST_AUTO_TEST_CASE(energy_balances_under_oscillating_creepage)
{
  TimeRun<2> run([](SceneParameters &scene) {
    with_inertia(scene);
    scene.time.creepage_x = "0.001 + 0.0005 * sin(2 * pi * 5000 * t)";
  });
  const auto forces = run.march(300);
  BOOST_TEST(*std::max_element(forces.begin(), forces.end()) -
               *std::min_element(forces.begin(), forces.end()) >
             1e-3);
  BOOST_TEST(run.worst_balance < 1e-12 * run.largest_energy);
  BOOST_TEST(run.least_friction > -1e-12 * run.largest_energy);
  BOOST_TEST(run.last.energy.numerical_dissipation == 0.);
}

/**
 * Without inertia the bodies store what pressing them together takes, the
 * integral of the load over the approach: each step takes the mean of the loads
 * at its ends, and nothing is lost.
 */
BOOST_AUTO_TEST_CASE(massless_bodies_store_the_work_of_the_load)
{
  TimeRun<2> run([](SceneParameters &scene) {
    scene.contact.friction_coefficient = 0.;
    scene.time.initial_state           = InitialState::steady;
    scene.time.approach                = "0.15e-3 * (1 + 100 * t)";
    scene.time.time_step               = 1e-4;
  });
  run.march(1);
  for (unsigned int k = 0; k < 5; ++k)
    {
      const double load     = run.stepper->current().result.normal_force,
                   approach = run.stepper->current().state.approach,
                   stored   = run.stepper->bodies().stored_energy();
      run.march(1);
      const double closer = run.stepper->current().state.approach - approach,
                   larger = run.stepper->current().result.normal_force;
      BOOST_TEST(closer == 0.15e-5, boost::test_tools::tolerance(1e-9));
      BOOST_TEST(run.stepper->bodies().stored_energy() - stored ==
                   (load + larger) / 2 * closer,
                 boost::test_tools::tolerance(1e-4));
      BOOST_TEST(run.last.energy.contact_work == (load + larger) / 2 * closer,
                 boost::test_tools::tolerance(1e-4));
      BOOST_TEST(run.last.energy.numerical_dissipation == 0.);
    }
  BOOST_TEST(run.worst_balance < 1e-12 * run.largest_energy);
}

/**
 * Steady rolling without inertia: what the creepage supplies becomes heat.
 */
BOOST_AUTO_TEST_CASE(massless_rolling_heats_by_its_creepage)
{
  TimeRun<2> run([](SceneParameters &scene) {
    scene.contact.creepages.x = 0.001;
    scene.time.initial_state  = InitialState::steady;
  });
  run.march(5);
  const Resultants &result = run.stepper->current().result;
  BOOST_TEST(run.last.friction == std::abs(result.force_x) * 0.001 * 10 * 1e-4,
             boost::test_tools::tolerance(0.06));
  BOOST_TEST(std::abs(run.last.energy.contact_work) < 1e-6 * run.last.friction);
  BOOST_TEST(run.worst_balance < 1e-12 * run.largest_energy);
  TimeRun<2> building([](SceneParameters &scene) {
    scene.contact.creepages.x = 0.001;
    scene.time.initial_state  = InitialState::rest;
  });
  building.march(5); // the strain energy grows by the work of the contact
  BOOST_TEST(building.worst_balance < 1e-12 * building.largest_energy);
}

/**
 * Bodies so light that they are in equilibrium all the time. Reactions act at
 * t + theta h: there an approach that grows has the load of a static contact.
 * The contact law holds at t + (2 - theta) h, or without the shift at t + h:
 * there the approach is found back when the load is given as it was.
 */
BOOST_AUTO_TEST_CASE(loads_and_approaches_given_in_time_are_inverse)
{
  const double theta = 0.75, h = 1e-4;
  const auto   approach_at = [](const double t) {
    return 0.15e-3 * (1 + 50 * t);
  };
  const auto frictionless = [=](SceneParameters &scene) {
    scene.contact.friction_coefficient = 0.;
    scene.time.initial_state           = InitialState::steady;
    scene.time.time_step               = h;
    scene.time.theta                   = theta;
  };
  for (const ContactLaw law : {ContactLaw::shifted, ContactLaw::gap})
    {
      const auto light = [&](SceneParameters &scene) {
        frictionless(scene);
        scene.time.inertia     = true;
        scene.time.contact_law = law;
        for (BodyParameters *body : {&scene.wheel, &scene.rail})
          body->material.density = 1e-3;
      };
      TimeRun<2> pressed([&](SceneParameters &scene) {
        light(scene);
        scene.time.approach = "0.15e-3 * (1 + 50 * t)";
      });
      // parabola through the loads of three steps, to 1e-6
      std::array<double, 3> time{}, load{};
      for (unsigned int k = 0; k < 3; ++k)
        {
          pressed.march(10);
          time[k] = pressed.time - h + theta * h;
          load[k] = pressed.stepper->current().result.normal_force;
        }
      TimeRun<2> still([&](SceneParameters &scene) {
        frictionless(scene);
        scene.time.inertia  = false;
        scene.time.approach = significant(approach_at(time[2]), 17);
      });
      still.march(1);
      BOOST_TEST(load[2] == still.stepper->current().result.normal_force,
                 boost::test_tools::tolerance(1e-5));

      const double slope_1 = (load[1] - load[0]) / (time[1] - time[0]),
                   slope_2 = (load[2] - load[1]) / (time[2] - time[1]),
                   bend    = (slope_2 - slope_1) / (time[2] - time[0]);
      TimeRun<2> loaded([&](SceneParameters &scene) {
        light(scene);
        // of the same patch, so that the meshes are the same
        scene.contact.approach = {};
        scene.contact.normal_load =
          estimate_patch(pressed.situation()).normal_force;
        scene.time.normal_load =
          significant(load[0], 17) + " + (t - " + significant(time[0], 17) +
          ") * (" + significant(slope_1, 17) + " + (t - " +
          significant(time[1], 17) + ") * " + significant(bend, 17) + ")";
      });
      loaded.march(25);
      const double ahead = law == ContactLaw::shifted ? (1 - theta) * h : 0.;
      BOOST_TEST(loaded.stepper->current().state.approach ==
                   approach_at(loaded.time + ahead),
                 boost::test_tools::tolerance(1e-4));
    }
}

/**
 * A disc dropped on a block rebounds: what it had of energy it keeps but for
 * the shocks of the nodes, and it leaves.
 */
BOOST_AUTO_TEST_CASE(a_dropped_disc_rebounds)
{
  for (const ContactLaw law : {ContactLaw::shifted, ContactLaw::gap})
    {
      TimeRun<2>   run([&](SceneParameters &scene) {
        scene.time.inertia                 = true;
        scene.time.contact_law             = law;
        scene.wheel.hub                    = Hub::free;
        scene.wheel.radius                 = 0.05;
        scene.wheel.hub_radius             = 0.01;
        scene.rail.shape                   = "block";
        scene.rail.radius                  = 0.;
        scene.rail.block_length            = 0.3;
        scene.rail.block_depth             = 0.1;
        scene.contact.approach             = 0.04e-3;
        scene.contact.friction_coefficient = 0.;
        scene.time.approach                = "-1e-6";
        scene.time.initial_velocity        = -1.;
        scene.time.time_step               = 0.5e-6;
      });
      const double initial = run.stepper->bodies().stored_energy();
      run.march(60);
      BOOST_TEST(run.stepper->current().result.normal_force > 1000.);
      run.march(240);
      BOOST_TEST(run.stepper->current().result.normal_force == 0.);
      BOOST_TEST(run.n_impacts > 10u);
      const double kept = run.stepper->bodies().stored_energy() / initial;
      // the gap law can give energy, the shifted one cannot
      BOOST_TEST(kept <= 1 + (law == ContactLaw::shifted ? 1e-12 : 1e-3));
      BOOST_TEST(kept > 0.99);
      BOOST_TEST(run.worst_balance < 1e-12 * initial);
    }
}

/**
 * A column whose hub accelerates towards the rail lags behind it: at rest in
 * the accelerated frame its tip is displaced by -rho a L^2 / (2 E).
 */
BOOST_AUTO_TEST_CASE(bodies_feel_the_acceleration_of_their_hub)
{
  const double acceleration = 1000., length = 0.1;
  for (const MassKind mass : {MassKind::lumped, MassKind::consistent})
    {
      TimeRun<2> run([&](SceneParameters &scene) {
        scene.time.inertia                 = true;
        scene.time.mass                    = mass;
        scene.time.theta                   = 1.;
        scene.time.time_step               = 5e-5;
        scene.time.approach                = "-1e-3 + 0.5 * 1000 * t^2";
        scene.rail.rigid                   = true;
        scene.wheel.shape                  = "block";
        scene.wheel.radius                 = 0.;
        scene.wheel.block_length           = 0.1;
        scene.wheel.block_depth            = length;
        scene.wheel.material.poisson_ratio = 0.;
        scene.contact.friction_coefficient = 0.;
        scene.contact.approach             = 0.05e-3;
        scene.mesh.elements_across_patch   = 8;
      });
      run.march(18);
      const Material &steel = run.scene.wheel.material;
      const auto      field =
        run.stepper->bodies().displacement(Side::wheel,
                                           run.stepper->current().problem,
                                           run.stepper->current().state);
      const auto [lowest, highest] =
        std::minmax_element(field.begin(), field.end());
      const double tip = -steel.density * acceleration * length * length /
                         (2 * steel.young_modulus);
      BOOST_TEST(*lowest == tip, boost::test_tools::tolerance(1e-3));
      BOOST_TEST(*highest < 1e-3 * std::abs(tip));
    }
}

/**
 * A step that cannot be solved is halved as often as allowed, then the run
 * stops and says when and why.
 */
BOOST_AUTO_TEST_CASE(hopeless_steps_are_halved_then_refused)
{
  TimeRun<2> run([](SceneParameters &scene) {
    scene.contact.creepages.x            = 0.001;
    scene.time.maximum_halvings          = 2;
    scene.solver.solver                  = "fixed point";
    scene.solver.controls.max_iterations = 2;
    scene.time.initial_state             = InitialState::rest;
  });
  BOOST_CHECK_EXCEPTION(run.march(1),
                        ConvergenceError,
                        [](const ConvergenceError &error) {
                          const std::string text = error.what();
                          return text.find("t = ") != std::string::npos &&
                                 text.find("2.5e-05") != std::string::npos;
                        });
  BOOST_TEST(run.said.str().find("halved") != std::string::npos);
}

/**
 * Half-space limit (a tiny load), circular patch, full adhesion: the force
 * after q of rolling over that of steady rolling, an independent computation
 * (nu = 0.3): lateral .291, .527, .824 at q/a = 0.5, 1, 2.
 */
BOOST_AUTO_TEST_CASE(adhesion_builds_up_as_in_a_half_space)
{
  const double a      = 4.046e-5;
  const auto   change = [&](SceneParameters &scene) {
    for (BodyParameters *body : {&scene.wheel, &scene.rail})
      body->lateral_radius = 0.46;
    scene.contact.approach           = {};
    scene.contact.normal_load        = 0.036;
    scene.contact.creepages.y        = 1e-9;
    scene.mesh.elements_across_patch = 10;
    scene.time.time_step             = 0.;
    scene.time.step_length           = a / 40;
  };
  TimeRun<3>        run(change);
  const SceneRun<3> steady(standard<3>, change);
  const double      radius = steady.steady.result.half_width_x;
  run.scene.time.time_step = a / 40 / run.scene.contact.rolling_speed();
  double q                 = 0.;
  for (const auto &point : {std::make_pair(0.5, 0.291),
                            std::make_pair(1., 0.527),
                            std::make_pair(2., 0.824)})
    {
      double force = 0.;
      while (q < point.first * radius)
        {
          run.march(1);
          force = run.stepper->current().result.force_y /
                  steady.steady.result.force_y;
          q += a / 40;
        }
      BOOST_TEST(std::abs(force / point.second - 1) < 0.025);
      BOOST_TEST_MESSAGE("q/a " << q / radius << " F/F_steady " << force);
    }
}

BOOST_AUTO_TEST_SUITE_END()
