#include <deal.II/lac/vector.h>

#include <boost/test/unit_test.hpp>

#include "time_run.h"

#include <rolling_contact/analyses/step_estimate.h>

#include <cmath>
#include <string>

using namespace RollingContact;

BOOST_AUTO_TEST_SUITE(step_estimate)

namespace
{
  using Change = std::function<void(SceneParameters &)>;

  /** A run with the forces of its steps, and its estimate. */
  struct EstimatedRun : public TimeRun<2>
  {
    EstimatedRun(const Change &change, const unsigned int n, const double end)
      : TimeRun<2>([&](SceneParameters &scene) {
        change(scene);
        scene.time.time_step = end / n;
      })
      , steps{end / n, n}
    {
      stepper->set_time_step(steps.length);
      StepEstimate<2> estimate(situation(), steps, *stepper, context);
      forces.step = steps.length;
      for (unsigned int k = 1; k <= n; ++k)
        {
          TimeRun<2>::march(1);
          const Resultants &result = stepper->current().result;
          estimate.add(k, result);
          forces.forces.push_back(
            {{result.force_x, result.force_y, result.normal_force}});
        }
      forces.lag = last.force_lag;
      bound      = estimate.errors(*stepper);
    }

    /** How far the force at the end is from that of another run, over mu N. */
    double error_of_end(const EstimatedRun &exact) const
    {
      const double begin = (steps.number - 1) * steps.length;
      ForceHistory end{steps.length,
                       {forces.forces.back()},
                       forces.lag - begin};
      return history_errors(end, exact.forces).force_largest /
             scene.contact.friction_coefficient;
    }

    TimeSteps                 steps;
    ForceHistory              forces;
    std::optional<StepErrors> bound;
  };

  /** That the bound is above the error, by at most @p largest times. */
  void check_bound(const Change      &change,
                   const unsigned int n,
                   const double       end,
                   const double       largest)
  {
    const EstimatedRun run(change, n, end), exact(change, 8 * n, end);
    const double       error = run.error_of_end(exact);
    BOOST_TEST_REQUIRE(run.bound.has_value());
    BOOST_TEST_MESSAGE(n << " steps: error " << error << ", bound "
                         << run.bound->force);
    BOOST_TEST(error > 1e-7);
    BOOST_TEST(run.bound->force > error);
    BOOST_TEST(run.bound->force < largest * error);
  }

  void starts_up(SceneParameters &scene)
  {
    scene.contact.creepages.x = 0.001;
    scene.time.initial_state  = InitialState::rest;
  }
} // namespace

/**
 * Half as many steps to the same end, one less than half of an odd number.
 */
BOOST_AUTO_TEST_CASE(longer_steps_end_with_the_run)
{
  for (const unsigned int n : {4, 5, 9, 10, 1001})
    {
      const TimeSteps steps{2e-6, n}, longer = steps_of_twice_the_length(steps);
      BOOST_TEST(longer.number == n / 2);
      BOOST_TEST(longer.length * longer.number == 2e-6 * n,
                 boost::test_tools::tolerance(1e-14));
    }
  const TimeSteps steps{2e-6, 9}, longer = steps_of_twice_the_length(steps);
  const double    ratio = 9. / 4;
  BOOST_TEST(error_of_steps(1., steps, longer) ==
               error_of_steps(1., {1., 10}, {2., 5}) / (ratio - 1),
             boost::test_tools::tolerance(1e-14));
  BOOST_TEST(error_of_steps(1., {1., 10}, {2., 5}) >= 1.);
}

BOOST_AUTO_TEST_CASE(a_smooth_start_up_is_within_the_bound)
{
  for (const unsigned int n : {20, 41})
    check_bound(starts_up, n, 1.28e-3, 30.);
}

BOOST_AUTO_TEST_CASE(an_oscillating_creepage_is_within_the_bound)
{
  for (const double theta : {0.5, 0.7})
    check_bound(
      [=](SceneParameters &scene) {
        oscillates(scene);
        scene.time.inertia = true;
        scene.time.theta   = theta;
      },
      61,
      0.8e-3,
      100.);
  check_bound(oscillates, 50, 1.6e-3, 100.);
}

BOOST_AUTO_TEST_CASE(a_steady_run_has_no_error)
{
  for (const bool inertia : {false, true})
    {
      const EstimatedRun run(
        [=](SceneParameters &scene) {
          oscillates(scene);
          scene.time.creepage_x = "";
          scene.time.inertia    = inertia;
        },
        11,
        1e-4);
      BOOST_TEST_REQUIRE(run.bound.has_value());
      BOOST_TEST(run.bound->force < 1e-8);
      BOOST_TEST(run.bound->load < 1e-8);
    }
}

/**
 * What the run is repeated from is where it began.
 */
BOOST_AUTO_TEST_CASE(the_start_is_the_one_of_the_run)
{
  for (const bool inertia : {false, true})
    {
      TimeRun<2> run([=](SceneParameters &scene) {
        oscillates(scene);
        scene.time.inertia   = inertia;
        scene.time.time_step = 1e-5;
      });
      Checkpoint start;
      run.stepper->save(start);
      const auto first = run.march(20);
      run.stepper->restore(start);
      run.time          = 0.;
      run.n_steps       = 0;
      const auto second = run.march(20);
      for (unsigned int k = 0; k < 20; ++k)
        BOOST_TEST(first[k] == second[k], boost::test_tools::tolerance(1e-12));
    }
}

/**
 * An approach that is too much between two steps of the run, where one of twice
 * the length ends: 9 steps, or 4 of 9/4 of their length.
 */
BOOST_AUTO_TEST_CASE(longer_steps_that_fail_are_told)
{
  const EstimatedRun run(
    [](SceneParameters &scene) {
      starts_up(scene);
      scene.time.approach = "if(abs(t - 4.5e-4) < 1e-5, 3e-3, 0.15e-3)";
    },
    9,
    9e-4);
  BOOST_TEST(!run.bound.has_value());
  BOOST_TEST_REQUIRE(run.log.warnings().size() == 1u);
  BOOST_TEST(run.log.warnings()[0].find("The error of the time step is not "
                                        "known") != std::string::npos);
}

/**
 * All the time of the repetition is that of the estimate, and nothing is said
 * of its steps.
 */
BOOST_AUTO_TEST_CASE(its_cost_is_a_phase)
{
  PhaseTimer timer;
  {
    const PhaseTimer::Scope estimate(timer, Phase::step_estimate);
    const PhaseTimer::Scope solve(timer, Phase::contact_solve);
  }
  const auto rows = timer.rows();
  BOOST_TEST_REQUIRE(rows.size() == 2u);
  BOOST_TEST((rows[0].phase == Phase::step_estimate));
  BOOST_TEST(rows[0].n_calls == 1u);
  std::ostringstream said;
  Log                log(Verbosity::verbose, said, said);
  {
    const Log::Silence silence(log);
    log.message("a step");
    log.detail("a step");
  }
  BOOST_TEST(said.str().empty());
  log.message("the end");
  BOOST_TEST(said.str() == "the end\n");
}

BOOST_AUTO_TEST_CASE(short_runs_have_no_estimate)
{
  const EstimatedRun run(starts_up, 3, 1e-4);
  BOOST_TEST(!run.bound.has_value());
  BOOST_TEST(run.log.warnings().empty());
}

BOOST_AUTO_TEST_SUITE_END()
