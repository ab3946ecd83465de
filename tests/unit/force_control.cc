#include <boost/test/unit_test.hpp>

#include "complaint.h"
#include "scene_run.h"
#include "time_run.h"

#include <rolling_contact/analyses/creep_curve_parameters.h>
#include <rolling_contact/contact/friction_limit.h>
#include <rolling_contact/program/analysis_table.h>
#include <rolling_contact/results/error_bounds.h>
#include <rolling_contact/results/reference_2d.h>
#include <rolling_contact/solvers/scaled_forces.h>

#include <array>
#include <cmath>

using namespace RollingContact;

BOOST_AUTO_TEST_SUITE(force_control)

namespace
{
  using Change = std::function<void(SceneParameters &)>;

  const Change nothing = [](SceneParameters &) {};

  std::array<double, 3> forces_of(const Resultants &result)
  {
    return {{result.force_x, result.force_y, result.spin_moment}};
  }

  /** The creepages of a solved state as they are found for its own forces. */
  template <int dim>
  void come_back(const Change    &scene,
                 const Creepages &creepages,
                 const bool       exactly = true)
  {
    const Change loaded = [&](SceneParameters &it) {
      scene(it);
      it.contact.approach.reset();
      it.contact.normal_load        = dim == 2 ? 90e3 : 36e3;
      it.mesh.elements_across_patch = dim == 2 ? 16 : 10;
      it.contact.creepages          = creepages;
    };
    SceneRun<dim> given(loaded, nothing);
    const auto    asked = forces_of(given.steady.result);
    for (unsigned int which = 1; which < (dim == 3 ? 8 : 2); ++which)
      {
        SceneRun<dim>    found(loaded, [&](SceneParameters &it) {
          if (which & 1)
            it.contact.forces.x = asked[0], it.contact.creepages.x = 0.;
          if (which & 2)
            it.contact.forces.y = asked[1], it.contact.creepages.y = 0.;
          if (which & 4)
            it.contact.forces.moment = asked[2], it.contact.creepages.spin = 0.;
        });
        const Creepages &now  = found.steady.problem.loads.creepages;
        const double     mu_N = given.friction_force();
        const auto       bounds =
          creepage_bounds(found.situation(),
                          found.steady,
                          error_bounds(found.situation(), found.steady));
        BOOST_TEST_CONTEXT("components " << which)
        {
          BOOST_TEST_REQUIRE(bounds.size() == (which == 7              ? 3u
                                               : (which & (which - 1)) ? 2u
                                                                       : 1u));
          // the edge law's rounds end at 1e-6; with pressure that answers to
          // friction, states on this mesh are not unique to all digits
          const double tolerance = exactly ? 2e-6 : 1.;
          unsigned int n         = 0;
          const auto   limit = [&](const unsigned int bit, const double one) {
            return which & bit ? std::min(tolerance * one, bounds[n++]) : 1e-15;
          };
          BOOST_TEST(std::abs(now.x - creepages.x) <= limit(1, 5e-3));
          BOOST_TEST(std::abs(now.y - creepages.y) <= limit(2, 5e-3));
          BOOST_TEST(std::abs(now.spin - creepages.spin) <= limit(4, 1.));
          const auto reached = forces_of(found.steady.result);
          for (unsigned int k = 0; k < 2; ++k)
            if (which & (1u << k))
              BOOST_TEST(std::abs(reached[k] - asked[k]) <= 1.01e-9 * mu_N);
          BOOST_TEST(found.steady.solver.force_rounds <= 12u);
        }
      }
  }

  void steel_on_aluminium(SceneParameters &scene)
  {
    standard<2>(scene);
    scene.rail.material.young_modulus = 70e9;
  }
} // namespace

BOOST_AUTO_TEST_CASE(creepages_come_back_from_their_forces)
{
  come_back<2>(standard<2>, {0.0012, 0., 0.});
  come_back<3>(standard<3>, {0.0011, -0.0015, 0.6});
}

BOOST_AUTO_TEST_CASE(creepages_come_back_where_pressure_answers_to_friction)
{
  come_back<2>(steel_on_aluminium, {-0.0012, 0., 0.}, false);
  come_back<3>(
    [](SceneParameters &scene) {
      standard<3>(scene);
      scene.rail.material.young_modulus = 70e9;
    },
    {0.0011, -0.0015, 0.6},
    false);
}

BOOST_AUTO_TEST_CASE(creepages_come_back_where_friction_falls)
{
  come_back<2>(
    [](SceneParameters &scene) {
      standard<2>(scene);
      scene.contact.friction_law         = "exponential";
      scene.contact.kinetic_friction     = 0.2;
      scene.contact.friction_decay_speed = 0.2;
    },
    {0.0012, 0., 0.});
}

BOOST_AUTO_TEST_CASE(the_derivative_is_that_of_differences)
{
  for (const bool coupled : {false, true})
    {
      SceneRun<3> run(standard<3>, [&](SceneParameters &scene) {
        scene.contact.creepages = {0.0011, -0.0015, 0.6};
        if (coupled)
          scene.rail.material.young_modulus = 70e9;
      });
      run.steady.problem.loads.forces = {0., 0., 0.};
      const DenseMatrix derivative    = force_derivative(run.steady.problem,
                                                      run.scene.solver.controls,
                                                      run.steady.state);
      BOOST_TEST_REQUIRE(derivative.rows() == 3u);
      run.steady.problem.loads.forces = {};
      for (unsigned int l = 0; l < 3; ++l)
        {
          const double h      = l == 2 ? 1e-5 : 1e-8;
          const auto   change = [&](const double by) {
            // the edge law's constants are left as they are
            SteadyState<3> moved;
            moved.problem             = run.steady.problem;
            moved.state               = run.steady.state;
            moved.state.holds_scheme  = true;
            Creepages      &creepages = moved.problem.loads.creepages;
            const Creepages unit      = unit_creepage(l);
            creepages                 = {creepages.x + by * unit.x,
                                         creepages.y + by * unit.y,
                                         creepages.spin + by * unit.spin};
            const SolverReport solved =
              make_contact_solver("automatic", run.scene.solver.controls)
                ->solve(moved.problem, moved.state);
            BOOST_TEST(solved.converged);
            return forces_of(resultants(moved.problem, moved.state));
          };
          const auto above = change(h), below = change(-h);
          for (unsigned int k = 0; k < 3; ++k)
            {
              const double scale =
                std::sqrt(derivative(k, k) * derivative(l, l));
              // rows of the edge law change with the pressure
              BOOST_TEST(
                std::abs((above[k] - below[k]) / (2 * h) - derivative(k, l)) <
                (coupled ? 2e-2 : 1e-4) * scale);
            }
        }
    }
}

/** Forces that are rounding alone leave the derivative as it is without any,
 * and small ones are themselves to first order. */
BOOST_AUTO_TEST_CASE(saturation_of_forces_that_are_rounding)
{
  const Saturation saturation(3.);
  for (const double size : {1e-300, 1e-18, 1e-9})
    {
      const DenseMatrix derivative =
        saturation.derivative({0.6 * size, -0.8 * size});
      BOOST_TEST((derivative - DenseMatrix::Identity(2, 2)).norm() < 1e-8);
      BOOST_TEST(saturation.value({0.6 * size, -0.8 * size})[1] == -0.8 * size,
                 boost::test_tools::tolerance(1e-8));
    }
}

BOOST_AUTO_TEST_CASE(carter_backwards)
{
  // the creepage of a force, in closed form; near saturation the discrete
  // force jumps where the last node begins to slide
  for (const double share : {0.1, 0.5, 0.9, 0.99, 0.999})
    {
      SceneRun<2> run(standard<2>, [&](SceneParameters &scene) {
        scene.contact.approach.reset();
        scene.contact.normal_load        = 90e3;
        scene.contact.forces.x           = -share * 0.3 * 90e3;
        scene.mesh.elements_across_patch = 32;
      });
      const auto  carter = reference_2d(run.situation(), run.steady).carter;
      BOOST_TEST_REQUIRE(carter.has_value());
      const double found      = run.steady.problem.loads.creepages.x,
                   a          = run.steady.result.half_width_x,
                   saturation = 0.3 * a / 0.23,
                   exact      = saturation * (1 - std::sqrt(1 - share));
      BOOST_TEST(std::abs(found - exact) <
                 (share < 0.999 ? 0.004 : 0.03) * saturation);
      BOOST_TEST(run.steady.solver.force_rounds <= (share < 0.999 ? 7u : 20u));
      BOOST_TEST(std::abs(run.steady.result.force_x / (0.3 * 90e3) + share) <
                 1e-9);
    }
}

BOOST_AUTO_TEST_CASE(a_creepage_stays_within_its_bound)
{
  for (const double share : {0.3, 0.8, 0.95})
    {
      const auto with = [&](const unsigned int elements) {
        return SceneRun<2>(standard<2>, [&](SceneParameters &scene) {
          scene.contact.approach.reset();
          scene.contact.normal_load        = 90e3;
          scene.contact.forces.x           = -share * 0.3 * 90e3;
          scene.mesh.elements_across_patch = elements;
        });
      };
      const auto coarse = with(12), fine = with(96);
      const auto bounds =
        creepage_bounds(coarse.situation(),
                        coarse.steady,
                        error_bounds(coarse.situation(), coarse.steady));
      BOOST_TEST_REQUIRE(bounds.size() == 1u);
      const double off = std::abs(coarse.steady.problem.loads.creepages.x -
                                  fine.steady.problem.loads.creepages.x);
      BOOST_TEST(off <= bounds[0]);
      BOOST_TEST(bounds[0] < 1000 * off);
    }
}

BOOST_AUTO_TEST_CASE(what_friction_can_carry)
{
  SceneRun<3>  run(standard<3>, [](SceneParameters &scene) {
    scene.mesh.elements_across_patch = 12;
  });
  auto        &problem  = run.steady.problem;
  const auto  &pressure = run.steady.state.pressure;
  const double mu_N = run.friction_force(), a = run.steady.result.half_width_x,
               b       = run.steady.result.half_width_y;
  problem.loads.forces = {0.6 * mu_N, -0.3 * mu_N, {}};
  BOOST_TEST(largest_share_of_forces(problem, pressure) ==
               1 / std::hypot(0.6, 0.3),
             boost::test_tools::tolerance(1e-9));
  // of pure spin, int mu p r, by Hertz with r in an ellipse
  double             exact = 0.;
  const unsigned int n     = 400;
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      {
        const double r = (i + 0.5) / n, angle = 2 * std::acos(-1.) * j / n;
        exact += 1.5 / std::acos(-1.) * std::sqrt(1 - r * r) * r *
                 std::hypot(a * r * std::cos(angle), b * r * std::sin(angle)) *
                 2 * std::acos(-1.) / (double(n) * n);
      }
  problem.loads.forces = {0., {}, exact * mu_N};
  BOOST_TEST(largest_share_of_forces(problem, pressure) == 1.,
             boost::test_tools::tolerance(5e-3));
  // force and moment: no power of sliding is below what they do
  problem.loads.forces = {0.5 * mu_N, 0.2 * mu_N, 0.3 * exact * mu_N};
  const double share   = largest_share_of_forces(problem, pressure);
  double       least   = 1e300;
  for (const double x : {-1., -0.5, -0.1, 0.1, 0.5, 1., 1.3})
    for (const double y : {-1., -0.4, 0., 0.2, 0.4, 0.7})
      for (const double spin : {-500., -200., 0., 50., 100., 200., 400.})
        {
          const double work = mu_N * (0.5 * x + 0.2 * y + 0.3 * exact * spin);
          if (work <= 0.)
            continue;
          const NodalField slip  = rigid_slip(problem.operators, {x, y, spin});
          double           power = 0.;
          for (unsigned int i = 0; i < problem.n_nodes(); ++i)
            power += 0.3 * pressure[i] * problem.operators.areas()[i] *
                     slip.norm_at(i);
          least = std::min(least, power / work);
        }
  BOOST_TEST(share <= least);
  BOOST_TEST(share > 0.97 * least);
}

BOOST_AUTO_TEST_CASE(forces_beyond_friction_are_refused_with_the_largest)
{
  const auto refused = [](const AskedForces &forces, const bool by_load) {
    return complaint([&]() {
      SceneRun<3>(standard<3>, [&](SceneParameters &scene) {
        scene.contact.forces = forces;
        if (by_load)
          {
            scene.contact.approach.reset();
            scene.contact.normal_load = 36e3;
          }
      });
    });
  };
  // before anything is meshed
  BOOST_TEST(contains(refused({8e3, 9e3, {}}, true), "mu N = 10800 N"));
  BOOST_TEST(contains(refused({10.8e3, {}, {}}, true), "mu N = 10800 N"));
  // the load is found first
  const std::string found = refused({8e3, 9e3, {}}, false);
  BOOST_TEST(contains(found, "Longitudinal force = 8000 N"));
  BOOST_TEST(contains(found, "carries less than Longitudinal force = 76"));
  BOOST_TEST(contains(refused({{}, {}, 50.}, false), "Spin moment = 2"));
}

BOOST_AUTO_TEST_CASE(what_does_not_go_together_is_refused)
{
  const auto refused = [](const Change &change) {
    return complaint([&]() {
      SceneParameters scene;
      standard<2>(scene);
      scene.contact.forces.x = 100.;
      change(scene);
      scene.check();
    });
  };
  BOOST_TEST(refused(nothing) == "");
  BOOST_TEST(contains(refused([](SceneParameters &it) {
                        it.contact.creepages.x = 1e-3;
                      }),
                      "Contact/Creepage x = 0.001"));
  BOOST_TEST(
    contains(refused([](SceneParameters &it) { it.contact.forces.y = 1.; }),
             "Lateral force = 1: "));
  BOOST_TEST(contains(refused([](SceneParameters &it) {
                        it.contact.friction_coefficient = 0.;
                      }),
                      "Friction coefficient = 0"));
  BOOST_TEST(
    contains(refused([](SceneParameters &it) { it.mesh.adaptive_levels = 2; }),
             "Mesh/Adaptive levels = 2"));
  BOOST_TEST(contains(refused([](SceneParameters &it) {
                        it.dimension              = 3;
                        it.profiles.wheel_profile = "S1002";
                        it.profiles.rail_profile  = "60E1";
                        it.profiles.surface_kind =
                          Profiles::SurfaceKind::curved;
                        it.contact.forces.y = 10.;
                      }),
                      "Contact surface = curved"));
  BOOST_TEST(contains(refused([](SceneParameters &it) {
                        it.analysis = analysis_kind("accuracy study");
                      }),
                      "accuracy study"));
  BOOST_TEST(
    contains(refused([](SceneParameters &it) {
               it.contact.forces = {};
               it.analysis       = analysis_kind("creep curve");
               it.own<CreepCurveParameters>().creepage_x         = {1e-3};
               it.own<CreepCurveParameters>().longitudinal_force = {10., 20.};
             }),
             "Creep curve/Creepage x and Longitudinal force"));
  BOOST_TEST(contains(refused([](SceneParameters &it) {
                        it.analysis                = analysis_kind("transient");
                        it.time.longitudinal_force = "100*t";
                        it.time.creepage_x         = "1e-3";
                      }),
                      "Time/Longitudinal force = 100*t"));
  BOOST_TEST(contains(refused([](SceneParameters &it) {
                        it.analysis = analysis_kind("transient");
                        it.contact.approach.reset();
                        it.contact.normal_load     = 1e3;
                        it.time.longitudinal_force = "1e3*t";
                      }),
                      "at t = 0.3"));
}

/** By so much creepages change when their forces change by the bound. */
BOOST_AUTO_TEST_CASE(bounds_of_creepages_are_those_of_the_forces_carried_over)
{
  const double part = 0.01, force = -15e3, change = part * 0.3 * 90e3;
  const auto   asked_for = [](const double force) {
    return [=](SceneParameters &scene) {
      scene.contact.approach.reset();
      scene.contact.normal_load = 90e3;
      scene.contact.forces.x    = force;
    };
  };
  const auto found = [&](const double force) {
    return SceneRun<2>(standard<2>, asked_for(force))
      .steady.problem.loads.creepages.x;
  };
  const SceneRun<2> run(standard<2>, asked_for(force));
  ErrorBounds       bounds;
  bounds.force       = part;
  const auto margins = creepage_bounds(run.situation(), run.steady, bounds);
  BOOST_TEST_REQUIRE(margins.size() == 1u);
  BOOST_TEST(margins[0] == (found(force - change) - found(force + change)) / 2,
             boost::test_tools::tolerance(0.05));
}

BOOST_AUTO_TEST_CASE(a_force_is_held_in_time)
{
  TimeRun<2>   run([](SceneParameters &scene) {
    scene.contact.approach.reset();
    scene.contact.normal_load     = 90e3;
    scene.time.longitudinal_force = "-15e3*min(1, t/4e-4)";
  });
  const double h = run.scene.time.time_step;
  for (unsigned int k = 1; k <= 60; ++k)
    {
      run.march(1);
      BOOST_TEST(std::abs(run.stepper->current().result.force_x +
                          15e3 * std::min(1., k * h / 4e-4)) <
                 1.01e-9 * 0.3 * 90e3);
    }
  // what it ends in is the steady state of that force
  SceneRun<2>  steady(standard<2>, [](SceneParameters &scene) {
    scene.contact.approach.reset();
    scene.contact.normal_load = 90e3;
    scene.contact.forces.x    = -15e3;
  });
  const double found = run.stepper->current().problem.loads.creepages.x;
  BOOST_TEST(found == steady.steady.problem.loads.creepages.x,
             boost::test_tools::tolerance(2e-3));
}

/** With inertia reactions act at t + theta h, and asked forces are theirs. */
BOOST_AUTO_TEST_CASE(an_asked_force_acts_when_reactions_do)
{
  for (const double theta : {0.5, 0.7})
    {
      const auto asked = [](const double t) {
        return -15e3 * (1 + 0.2 * std::sin(1e5 * t));
      };
      TimeRun<2>   run([&](SceneParameters &scene) {
        scene.wheel.material.density = scene.rail.material.density = 7800.;
        scene.contact.approach.reset();
        scene.contact.normal_load     = 90e3;
        scene.contact.creepages.x     = 0.;
        scene.time.inertia            = true;
        scene.time.theta              = theta;
        scene.time.initial_state      = InitialState::steady;
        scene.time.time_step          = 2e-6;
        scene.time.longitudinal_force = "-15e3*(1 + 0.2*sin(1e5*t))";
      });
      const double h = run.scene.time.time_step;
      for (unsigned int k = 0; k < 12; ++k)
        {
          run.march(1);
          BOOST_TEST(std::abs(run.stepper->current().result.force_x -
                              asked((k + theta) * h)) < 1e-8 * 0.3 * 90e3);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_force_that_jumps_leaves_no_echo)
{
  // the surfaces jump with it in one step; the creepage after it is that of
  // rolling, not what is left of the jump
  TimeRun<2>          run([](SceneParameters &scene) {
    scene.contact.approach.reset();
    scene.contact.normal_load = 90e3;
    scene.contact.forces.x    = -15e3;
  });
  std::vector<double> creepages;
  for (unsigned int k = 0; k < 8; ++k)
    {
      run.march(1);
      creepages.push_back(run.stepper->current().problem.loads.creepages.x);
    }
  BOOST_TEST(creepages[0] > 2 * creepages[1]);
  for (unsigned int k = 2; k < creepages.size(); ++k)
    {
      BOOST_TEST(creepages[k] > 0.);
      BOOST_TEST(std::abs(creepages[k] - creepages[k - 1]) <
                 0.3 * creepages[k]);
    }
}

BOOST_AUTO_TEST_SUITE_END()
