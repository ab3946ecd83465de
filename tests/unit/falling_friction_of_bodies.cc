#include <deal.II/lac/vector.h>

#include <boost/test/unit_test.hpp>

#include "complaint.h"
#include "response_check.h"
#include "time_run.h"

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/contact/patch_area.h>

#include <cmath>

using namespace RollingContact;

/** Friction that falls with the sliding speed, between meshed bodies. */
BOOST_AUTO_TEST_SUITE(falling_friction_of_bodies)

namespace
{
  /**
   * mu from 0.3 to 0.12.
   */
  void fall(SceneParameters &scene, const double decay_speed)
  {
    scene.contact.friction_law         = "exponential";
    scene.contact.kinetic_friction     = 0.12;
    scene.contact.friction_decay_speed = decay_speed;
  }

  double mu_at(const double speed, const double decay_speed)
  {
    return 0.12 + 0.18 * std::exp(-speed / decay_speed);
  }
} // namespace

/**
 * A creep curve in 3D rises, has a maximum and falls to mu(s_0 V).
 */
BOOST_AUTO_TEST_CASE(the_creep_curve_falls_beyond_saturation)
{
  const double decay = 1., speed = 20.;
  for (const bool lateral : {true, false})
    {
      std::vector<double> ratios;
      for (const double creepage : {0.001, 0.007, 0.02, 0.1})
        {
          const SceneRun<3> run(standard<3>, [&](SceneParameters &scene) {
            fall(scene, decay);
            scene.contact.speed = speed;
            (lateral ? scene.contact.creepages.y : scene.contact.creepages.x) =
              creepage;
          });
          ratios.push_back(run.steady.result.traction_coefficient);
          BOOST_TEST((lateral ? run.force_y() : run.force_x()) < 0.);
          if (creepage >= 0.02)
            BOOST_TEST(std::abs(ratios.back() / mu_at(creepage * speed, decay) -
                                1) < 0.01);
        }
      BOOST_TEST(ratios[0] < ratios[1]);
      BOOST_TEST(ratios[1] > ratios[2]);
      BOOST_TEST(ratios[2] > ratios[3]);
    }
}

/**
 * With spin every node slides its own way: against the slip, with mu of its
 * size.
 */
BOOST_AUTO_TEST_CASE(with_spin_tractions_oppose_the_slip_and_follow_the_law)
{
  const SceneRun<3>     run(standard<3>, [](SceneParameters &scene) {
    fall(scene, 0.5);
    scene.contact.speed          = 20.;
    scene.contact.slip_operator  = SlipOperatorKind::upwind_2;
    scene.contact.creepages.x    = 0.005;
    scene.contact.creepages.spin = 3.;
  });
  const ContactProblem &problem = run.steady.problem;
  const ContactState   &state   = run.steady.state;
  const NodalField      s =
    tangential_problem(problem, state).material_slip(state.traction);
  unsigned int n_slipping = 0;
  for (unsigned int i = 0; i < problem.n_nodes(); ++i)
    {
      const double speed = 20. * s.norm_at(i), p = state.pressure[i];
      if (p <= 0. || speed < 1e-6)
        continue;
      ++n_slipping;
      for (const unsigned int c : {0u, 1u})
        BOOST_TEST(std::abs(state.traction(c, i) +
                            mu_at(speed, 0.5) * p * s(c, i) * 20 / speed) <
                   1e-8 * run.steady.result.max_pressure);
    }
  BOOST_TEST(n_slipping > 10u);
}

/**
 * With spin slipping nodes also turn.
 */
BOOST_AUTO_TEST_CASE(less_friction_at_a_node_lets_all_slide_as_predicted)
{
  const SceneRun<3> run(standard<3>, [](SceneParameters &scene) {
    scene.contact.slip_operator  = SlipOperatorKind::upwind_2;
    scene.contact.creepages.x    = 0.002;
    scene.contact.creepages.spin = 1.;
  });
  BOOST_TEST(patch_areas(run.steady.problem, run.steady.state).stick > 0.);
  BOOST_TEST(error_of_response(run.steady.problem, run.steady.state) < 1e-4);
}

BOOST_AUTO_TEST_CASE(start_up_ends_in_the_steady_state_of_the_law)
{
  for (const auto slip_operator :
       {SlipOperatorKind::calibrated, SlipOperatorKind::upwind_2})
    {
      const auto change = [&](SceneParameters &scene) {
        fall(scene, 0.1);
        scene.contact.creepages.x   = 0.001;
        scene.contact.slip_operator = slip_operator;
      };
      TimeRun<2>        run(change);
      const auto        forces = run.march(200);
      const SceneRun<2> steady(standard<2>, change),
        constant(standard<2>, [&](SceneParameters &scene) {
          change(scene);
          scene.contact.friction_law = "constant";
        });
      BOOST_TEST(std::abs(forces.back() - steady.force_x()) < 1e-4);
      BOOST_TEST(std::abs(constant.force_x() - steady.force_x()) > 5e-3);
    }
}

namespace
{
  void with_inertia(SceneParameters &scene, const double step)
  {
    fall(scene, 1.6667);
    scene.time.inertia          = true;
    scene.time.initial_state    = InitialState::steady;
    scene.time.time_step        = step;
    scene.contact.creepages.x   = 0.001;
    scene.contact.slip_operator = SlipOperatorKind::upwind_2;
  }
} // namespace

/**
 * Steps shorter than a wave needs to cross an element: the ratio goes with the
 * step, and with it the other solutions.
 */
BOOST_AUTO_TEST_CASE(short_steps_with_inertia_have_one_solution)
{
  double previous = 0.;
  for (const double step : {8e-9, 4e-9, 2e-9})
    {
      TimeRun<2> run(
        [&](SceneParameters &scene) { with_inertia(scene, step); });
      run.march(1);
      const double ratio = run.last.several.ratio;
      BOOST_TEST(ratio > 0.);
      if (previous > 0.)
        BOOST_TEST(std::abs(previous / ratio - 2.) < 0.1);
      previous = ratio;
    }
  BOOST_TEST(previous < Uniqueness::limit);
}

BOOST_AUTO_TEST_CASE(energy_balances_and_friction_takes_it)
{
  TimeRun<2> run([](SceneParameters &scene) {
    with_inertia(scene, 1e-6);
    scene.time.creepage_x = "0.001 + 0.0008 * sin(2 * pi * 5000 * t)";
  });
  run.march(200);
  BOOST_TEST(run.worst_balance < 1e-12 * run.largest_energy);
  BOOST_TEST(run.least_friction > -1e-12 * run.largest_energy);
}

/**
 * From a checkpoint to the same digits, with and without inertia.
 */
BOOST_AUTO_TEST_CASE(resumed_steps_are_the_same)
{
  for (const bool inertia : {false, true})
    {
      const auto change = [&](SceneParameters &scene) {
        if (inertia)
          with_inertia(scene, 1e-6);
        else
          fall(scene, 0.1);
        scene.contact.creepages.x = 0.001;
        scene.time.creepage_x     = "0.001 + 2 * t";
      };
      TimeRun<2> whole(change), part(change);
      whole.march(5);
      Checkpoint checkpoint;
      whole.stepper->save(checkpoint);
      checkpoint.progress.step      = whole.n_steps;
      checkpoint.progress.time      = whole.time;
      checkpoint.progress.time_step = whole.scene.time.time_step;
      BOOST_TEST(checkpoint.state.friction.size() ==
                 checkpoint.state.pressure.size());
      part.stepper->set_time_step(checkpoint.progress.time_step);
      part.stepper->restore(checkpoint);
      part.n_steps        = whole.n_steps;
      part.time           = whole.time;
      const auto sticking = [](const auto &run) {
        const auto &contact = run.stepper->current();
        return patch_areas(contact.problem, contact.state).stick;
      };
      BOOST_TEST(sticking(part) == sticking(whole));
      whole.march(3);
      part.march(3);
      const ContactState &a = whole.stepper->current().state,
                         &b = part.stepper->current().state;
      BOOST_TEST((a.traction == b.traction));
      BOOST_TEST(a.friction == b.friction);
    }
}

BOOST_AUTO_TEST_CASE(entries_that_contradict_each_other)
{
  const auto said = [](const std::function<void(SceneParameters &)> &change) {
    SceneParameters scene;
    scene.contact.approach = 1e-4;
    scene.contact.speed    = 1.;
    fall(scene, 1.);
    scene.check();
    change(scene);
    return complaint([&]() { scene.check(); });
  };
  BOOST_TEST(said([](auto &) {}) == "");
  for (const char *law : {"exponential", "rational"})
    {
      const std::string text = said([&](auto &scene) {
        scene.contact.friction_law = law;
        scene.contact.speed.reset();
      });
      BOOST_TEST(contains(text, "Contact/Friction law = " + std::string(law)));
      BOOST_TEST(contains(text, "Contact/Speed"));
    }
  BOOST_TEST(said([](auto &scene) {
               scene.contact.kinetic_friction = 0.4; // rises
             }) == "");
  BOOST_TEST(
    contains(said([](auto &scene) { scene.contact.kinetic_friction = 0.; }),
             "above 0"));
  BOOST_TEST(
    contains(said([](auto &scene) { scene.contact.friction_decay_speed = 0.; }),
             "Contact/Friction decay speed = 0"));
  BOOST_TEST(said([](auto &scene) {
               scene.contact.friction_law = "constant";
               scene.contact.speed.reset();
               scene.contact.kinetic_friction = 0.;
             }) == "");
}

BOOST_AUTO_TEST_SUITE_END()
