#include <boost/test/unit_test.hpp>

#include "complaint.h"
#include "half_plane.h"
#include "scene_run.h"
#include "time_run.h"

#include <rolling_contact/contact/friction_memory.h>
#include <rolling_contact/results/error_bounds.h>
#include <rolling_contact/time/patch_friction.h>

#include <algorithm>
#include <cmath>

using namespace RollingContact;
using HalfPlane::force;
using HalfPlane::half_plane_problem;
using HalfPlane::solve;

/** Friction with a memory and with a place. */
BOOST_AUTO_TEST_SUITE(friction_memory)

namespace
{
  using Change = std::function<void(SceneParameters &)>;

  HalfPlane::Options upstream(const unsigned int n_elements, const int flow = 1)
  {
    HalfPlane::Options options;
    options.kind       = SlipOperatorKind::upwind_2;
    options.creepage   = 1.5;
    options.n_elements = n_elements;
    options.flow       = flow;
    return options;
  }

  ContactProblem remembering(const HalfPlane::Options &options,
                             const double              length)
  {
    ContactProblem problem      = half_plane_problem(options);
    problem.loads.friction_law  = make_friction_law("exponential", 0.5, 0.2);
    problem.loads.speed         = 1.;
    problem.loads.memory_length = length;
    return problem;
  }
} // namespace

BOOST_AUTO_TEST_CASE(no_memory_and_endless_memory)
{
  const auto   options = upstream(48);
  const double at_once = force(solve(remembering(options, 0.)));
  BOOST_TEST(force(solve(remembering(options, 1e-9))) == at_once,
             boost::test_tools::tolerance(1e-6));
  // of a surface that forgets nothing mu stays what it comes with
  BOOST_TEST(force(solve(remembering(options, 1e6))) ==
               force(solve(half_plane_problem(options))),
             boost::test_tools::tolerance(1e-5));
  const double between = force(solve(remembering(options, 0.2)));
  BOOST_TEST(std::abs(between) > std::abs(at_once) * 1.01);
  BOOST_TEST(std::abs(between) < 0.99);
}

BOOST_AUTO_TEST_CASE(mu_follows_its_equation_along_the_flow)
{
  for (const int flow : {1, -1})
    {
      const double         d        = 0.2;
      const ContactProblem problem  = remembering(upstream(192, flow), d);
      const auto           solution = solve(problem);
      BOOST_TEST(solution.report.converged);
      const TangentialProblem tangential =
        tangential_problem(problem, solution.state);
      const auto   s         = tangential.slip(solution.state.traction);
      const auto  &at        = problem.operators.positions();
      unsigned int n_checked = 0;
      for (unsigned int k = 1; k + 1 < problem.n_nodes(); ++k)
        {
          const unsigned int i      = flow > 0 ? k : problem.n_nodes() - 1 - k,
                             before = i - flow;
          const double speed        = s.norm_at(i);
          if (!(tangential.bound[i] > 0. && tangential.bound[before] > 0.))
            continue;
          ++n_checked;
          // dmu/dx = -(mu - mu_law) |s|/d, centred between two nodes
          const double law =
                         HalfPlane::mu * (0.5 + 0.5 * std::exp(-speed / 0.2)),
                       slope = (tangential.friction[i] -
                                tangential.friction[before]) /
                               std::abs(at[i][0] - at[before][0]),
                       mean = (tangential.friction[i] +
                               tangential.friction[before]) /
                              2;
          BOOST_TEST(std::abs(slope + (mean - law) * speed / d) <
                     0.02 * HalfPlane::mu);
          BOOST_TEST(tangential.friction[i] <= HalfPlane::mu);
          BOOST_TEST(tangential.friction[i] >= 0.5 * HalfPlane::mu);
        }
      BOOST_TEST(n_checked > 180u);
    }
}

/** m of a patch that slides at a given speed v(t), against
 * tau m' = 1 - drop(v) - m by Runge and Kutta. */
BOOST_AUTO_TEST_CASE(one_number_for_the_patch_is_of_second_order_in_the_step)
{
  ContactProblem     problem = remembering(upstream(48), 0.);
  const ContactState state   = solve(problem).state;
  const double       tau = 0.3, end = 2.;
  const auto         target = [&](const double time) {
    problem.loads.creepages.x =
      HalfPlane::mu * (1.6 + 0.5 * std::sin(4 * time));
    return 1 -
           problem.loads.friction_law->drop(mean_sliding_speed(problem, state));
  };
  const double start = target(0.);
  double       exact = start;
  const auto   rate  = [&](const double time, const double m) {
    return (target(time) - m) / tau;
  };
  const unsigned int n_fine = 400;
  const double       fine   = end / n_fine;
  for (unsigned int k = 0; k < n_fine; ++k)
    {
      const double t = k * fine, a = rate(t, exact),
                   b = rate(t + fine / 2, exact + fine / 2 * a),
                   c = rate(t + fine / 2, exact + fine / 2 * b),
                   d = rate(t + fine, exact + fine * c);
      exact += fine / 6 * (a + 2 * b + 2 * c + d);
    }
  BOOST_TEST(std::abs(exact - start) > 0.005);
  std::vector<double> errors;
  for (const unsigned int n : {20, 40})
    {
      target(0.);
      PatchFriction friction(problem, state, tau);
      const auto    before = friction.coefficients_now();
      for (unsigned int k = 1; k <= n; ++k)
        {
          target(k * end / n);
          friction.begin_step(end / n);
          while (!friction.agrees(problem, state))
            {}
          BOOST_TEST(!friction.failed());
          friction.end_step();
        }
      const double m = friction.memory().share;
      errors.push_back(m - exact);
      const auto after = friction.coefficients_now();
      for (std::size_t i = 0; i < after.size(); ++i)
        BOOST_TEST(
          std::abs(after[i] - before[i] - HalfPlane::mu * (m - start)) < 1e-12);
    }
  BOOST_TEST(std::abs(errors[1]) < 1e-3);
  BOOST_TEST(errors[0] / errors[1] == 4., boost::test_tools::tolerance(0.1));
}

BOOST_AUTO_TEST_CASE(the_derivative_is_that_of_differences_of_friction)
{
  ContactProblem      problem = remembering(upstream(24), 0.1);
  std::vector<double> speeds(problem.n_nodes(), 0.);
  for (unsigned int i = 8; i < 30; ++i)
    speeds[i] = 0.05 + 0.01 * ((7 * i) % 5);
  const std::vector<unsigned int> nodes{9, 12, 13, 20, 29};
  for (const bool in_time : {false, true})
    {
      if (in_time)
        {
          problem.loads.step_path = 0.03;
          problem.loads.friction_arriving.assign(problem.n_nodes(), 0.28);
        }
      const DenseMatrix derivative =
        FrictionMemory(problem, speeds).derivative(nodes);
      for (std::size_t l = 0; l < nodes.size(); ++l)
        {
          const double h     = 1e-6;
          auto         above = speeds, below = speeds;
          above[nodes[l]] += h;
          below[nodes[l]] -= h;
          const FrictionMemory up(problem, above), down(problem, below);
          for (std::size_t k = 0; k < nodes.size(); ++k)
            BOOST_TEST(
              std::abs((up.friction()[nodes[k]] - down.friction()[nodes[k]]) /
                         (2 * h) -
                       derivative(k, l)) < 1e-7);
        }
    }
}

BOOST_AUTO_TEST_CASE(the_material_carries_what_it_has)
{
  for (const int flow : {1, -1})
    {
      const ContactProblem problem = half_plane_problem(upstream(24, flow));
      const auto          &at      = problem.operators.positions();
      const double         h       = 2. / 24;
      std::vector<double>  values, entering(problem.n_nodes(), -7.);
      for (const auto &x : at)
        values.push_back(3 + 2 * x[0]);
      const auto one  = moved_with_flow(problem.operators, values, entering, h),
                 part = moved_with_flow(problem.operators,
                                        values,
                                        entering,
                                        0.3 * h);
      for (unsigned int i = 0; i < at.size(); ++i)
        {
          const bool first = flow > 0 ? i == 0 : i + 1 == at.size();
          if (!first)
            BOOST_TEST(std::abs(one[i] - values[i - flow]) < 1e-9);
          BOOST_TEST(
            std::abs(part[i] - (first ? -7. : values[i] - flow * 0.6 * h)) <
            1e-9);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_steady_state_with_memory_stays)
{
  const Change remember = [](SceneParameters &scene) {
    scene.contact.friction_law           = "exponential";
    scene.contact.kinetic_friction       = 0.2;
    scene.contact.friction_decay_speed   = 0.1;
    scene.contact.friction_memory_length = 1e-5;
    scene.contact.creepages.x            = 0.004;
    scene.time.initial_state             = InitialState::steady;
    scene.time.time_step                 = 2e-5;
  };
  TimeRun<2>   run(remember);
  const double before = run.force_x();
  BOOST_TEST(std::abs(before) < 0.92);
  const auto after = run.march(60);
  BOOST_TEST(after.back() == before, boost::test_tools::tolerance(0.02));
  // and is come to from rest
  TimeRun<2> start([&](SceneParameters &scene) {
    remember(scene);
    scene.time.initial_state = InitialState::rest;
  });
  BOOST_TEST(start.march(150).back() == after.back(),
             boost::test_tools::tolerance(0.02));
}

BOOST_AUTO_TEST_CASE(a_share_of_friction)
{
  const auto force_at = [](const std::string &share, const double mu) {
    SceneRun<2> run(standard<2>, [&](SceneParameters &scene) {
      scene.contact.friction_coefficient = mu;
      scene.contact.creepages.x          = 0.002;
      scene.surfaces.friction_share      = share;
    });
    return run.steady.result.force_x;
  };
  BOOST_TEST(force_at("0.5", 0.3) == force_at("", 0.15),
             boost::test_tools::tolerance(1e-9));
  // a strip of grease along the track
  SceneRun<3> strip(standard<3>, [](SceneParameters &scene) {
    scene.contact.creepages.x     = 0.01;
    scene.surfaces.friction_share = "if(y < 0, 0.2, 1)";
  });
  const auto &problem = strip.steady.problem;
  const auto &state   = strip.steady.state;
  for (unsigned int i = 0; i < problem.n_nodes(); ++i)
    if (state.pressure[i] > 1e8)
      BOOST_TEST(state.traction.norm_at(i) / state.pressure[i] ==
                   (problem.operators.positions()[i][1] < 0. ? 0.06 : 0.3),
                 boost::test_tools::tolerance(1e-6));
  // more of it on the left: the traction turns the wheel
  BOOST_TEST(strip.steady.result.spin_moment > 0.);
  BOOST_TEST(!error_bounds(strip.situation(), strip.steady).force.has_value());
}

BOOST_AUTO_TEST_CASE(a_greased_stretch_of_rail_passes)
{
  // it lies behind the contact; the material of the rail flows in +x
  const Change grease = [](SceneParameters &scene) {
    scene.contact.creepages.x     = 0.02;
    scene.time.initial_state      = InitialState::steady;
    scene.surfaces.friction_share = "if(x < -0.012, 0.5, 1)";
  };
  TimeRun<2>   run(grease);
  const double dry = run.force_x();
  BOOST_TEST(dry == -1., boost::test_tools::tolerance(1e-3));
  const auto forces = run.march(25); // 1 mm a step, a is 3.5 mm
  BOOST_TEST(forces[5] == dry, boost::test_tools::tolerance(1e-3));
  BOOST_TEST(forces[11] == -0.75, boost::test_tools::tolerance(0.2));
  BOOST_TEST(forces[20] == -0.5, boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(what_does_not_make_sense_is_refused)
{
  const auto refused = [](const Change &change) {
    return complaint([&]() {
      SceneParameters scene;
      standard<2>(scene);
      change(scene);
      scene.check();
      StateDemands  demands;
      SceneInMemory memory;
      solve_steady_state<2>(Situation(scene), demands, memory.context);
    });
  };
  BOOST_TEST(contains(refused([](SceneParameters &scene) {
                        scene.contact.friction_memory_length = 1e-6;
                      }),
                      "Contact/Friction memory length = 1e-06"));
  BOOST_TEST(contains(refused([](SceneParameters &scene) {
                        scene.surfaces.friction_share = "1.5";
                      }),
                      "from 0 to 1"));
  BOOST_TEST(contains(refused([](SceneParameters &scene) {
                        scene.surfaces.friction_share = "if(y < 0, 0.2, 1)";
                      }),
                      "in 2D there is no y"));
  BOOST_TEST(contains(refused([](SceneParameters &scene) {
                        scene.surfaces.friction_share = "1 + z";
                      }),
                      "Surfaces/Friction share = 1 + z"));
}

BOOST_AUTO_TEST_SUITE_END()
