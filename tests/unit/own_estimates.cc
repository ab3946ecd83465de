#include "scene_run.h"

#include <rolling_contact/contact/halved_problem.h>
#include <rolling_contact/results/error_bounds.h>
#include <rolling_contact/results/estimated_bounds.h>
#include <rolling_contact/solvers/newton_system.h>
#include <rolling_contact/state/estimate_errors.h>

#include <cmath>
#include <numeric>

using namespace RollingContact;

BOOST_AUTO_TEST_SUITE(own_estimates)

namespace
{
  /**
   * A wheel on a rail of the same steel under a load: bodies of unlike size,
   * whose free-rolling creepage is not zero.
   */
  void set_line_contact(SceneParameters &scene)
  {
    scene.wheel.radius               = 0.46;
    scene.rail.shape                 = "block";
    scene.rail.radius                = 0.;
    scene.rail.block_depth           = 0.07;
    scene.contact.normal_load        = 94e3;
    scene.contact.creepages.x        = 0.001;
    scene.mesh.elements_across_patch = 24;
    scene.mesh.growth                = 0.1;
    scene.output.body_fields         = false;
    scene.solver.controls.tolerance  = 1e-11;
    scene.contact.approach.reset();
  }

  /**
   * A state with its estimate.
   */
  template <int dim>
  struct EstimatedRun : public SceneInMemory
  {
    explicit EstimatedRun(const std::function<void(SceneParameters &)> &change,
                          const bool reference = false)
    {
      set_line_contact(scene);
      change(scene);
      if (reference)
        {
          scene.mesh.elements_across_patch *= dim == 2 ? 4 : 2;
          scene.mesh.growth = dim == 2 ? 0.025 : 0.4;
        }
      scene.check();
      StateDemands demands;
      demands.pair.bulk_errors = true;
      steady = solve_steady_state<dim>(situation(), demands, context);
      BOOST_TEST(steady.solver.converged);
      estimate_errors(situation(), steady);
    }

    ErrorBounds bounds() const
    {
      return error_bounds(situation(), steady);
    }

    SteadyState<dim> steady;
  };

  using Change = std::function<void(SceneParameters &)>;

  /** How far the forces of two states are apart, each over mu N. */
  template <int dim>
  double force_error(const EstimatedRun<dim> &run,
                     const EstimatedRun<dim> &reference)
  {
    const Resultants &one = run.steady.result, &other = reference.steady.result;
    return std::hypot(one.force_x / one.friction_force -
                        other.force_x / other.friction_force,
                      one.force_y / one.friction_force -
                        other.force_y / other.friction_force);
  }

  /**
   * The scenes whose force was 1.3 to 5.5 times outside of a bound that did not
   * know what friction does to the share of the growth.
   */
  template <int dim>
  double check_force(const Change &change, const double most = 10.)
  {
    const EstimatedRun<dim> run(change), reference(change, true);
    const double            error = force_error(run, reference),
                 bound            = *run.bounds().force;
    BOOST_TEST_MESSAGE("error " << error << ", bound " << bound);
    BOOST_TEST(error <= bound);
    BOOST_TEST(bound < most * error);
    return error;
  }
} // namespace

/**
 * With little friction, the bulk's share of the force goes as 1 / mu.
 */
BOOST_AUTO_TEST_CASE(know_what_little_friction_makes_of_a_coarse_bulk)
{
  check_force<2>([](SceneParameters &scene) {
    scene.contact.friction_coefficient = 0.034;
    scene.contact.creepages.x          = -7.4e-5;
    scene.mesh.elements_across_patch   = 40;
    scene.mesh.growth                  = 0.42;
  });
  check_force<2>([](SceneParameters &scene) {
    scene.contact.friction_coefficient = 0.05;
    scene.contact.creepages.x          = 1e-4;
    scene.mesh.growth                  = 0.8;
  });
}

BOOST_AUTO_TEST_CASE(of_the_bulk_answer_to_friction)
{
  double before = 0.;
  for (const double mu : {0.4, 0.2, 0.1})
    {
      const EstimatedRun<2> run([&](SceneParameters &scene) {
        scene.contact.friction_coefficient = mu;
        scene.contact.creepages.x          = 0.002 * mu;
        scene.mesh.growth                  = 0.8;
      });
      const double          bulk =
        run.steady.estimate->bulk->force / run.steady.result.friction_force;
      if (before > 0.)
        BOOST_TEST(bulk == 2 * before, boost::test_tools::tolerance(0.3));
      before = bulk;
    }
}

/**
 * Where all nodes slide, no change of displacements changes the force.
 */
BOOST_AUTO_TEST_CASE(of_the_bulk_vanish_in_full_slip)
{
  const EstimatedRun<2> run([&](SceneParameters &scene) {
    scene.contact.creepages.x = 0.05;
    scene.mesh.growth         = 0.8;
  });
  BOOST_TEST(run.steady.estimate->load_on_turning_slip.value() > 0.);
  BOOST_TEST(run.steady.estimate->bulk->force <
             1e-9 * run.steady.result.friction_force);
  // friction is mu N whatever the mesh, and this is known
  BOOST_TEST(*run.bounds().force < 1e-5);
}

/**
 * A stick zone smaller than an element is not overlooked: the force is inside
 * of its bound from partial slip over saturation to full slip.
 */
BOOST_AUTO_TEST_CASE(know_that_a_stick_zone_may_hide_between_nodes)
{
  unsigned int n_hidden = 0;
  for (const double part : {0.94, 0.96, 0.98, 0.99, 1., 1.02, 1.1})
    {
      const Change change = [&](SceneParameters &scene) {
        scene.contact.creepages.x        = part * 0.3 * 4.89e-3 / 0.46;
        scene.mesh.elements_across_patch = 10;
      };
      const EstimatedRun<2> run(change), reference(change, true);
      const double          error = force_error(run, reference);
      BOOST_TEST_MESSAGE(
        part << ": load "
             << run.steady.estimate->load_on_turning_slip.value_or(-1)
             << ", error " << error << ", bound " << *run.bounds().force);
      BOOST_TEST(error <= *run.bounds().force);
      n_hidden += run.steady.estimate->load_on_turning_slip && error > 1e-5;
    }
  BOOST_TEST(n_hidden > 0u);
}

/**
 * A slender patch that slides everywhere under spin, as that of a flange: long
 * elements say little of its force, which every second node tells.
 */
BOOST_AUTO_TEST_CASE(know_that_a_slender_patch_slides_everywhere)
{
  const Change change = [](SceneParameters &scene) {
    scene.dimension                  = 3;
    scene.wheel.lateral_radius       = 0.015;
    scene.rail.lateral_radius        = 0.05;
    scene.rail.block_length          = 0.3;
    scene.rail.block_depth           = 0.15;
    scene.wheel.width                = 0.06;
    scene.rail.width                 = 0.06;
    scene.contact.normal_load        = 40e3;
    scene.contact.creepages          = {0.004, -0.006, 0.8};
    scene.mesh.elements_across_patch = 10;
    scene.mesh.growth                = 0.8;
  };
  const EstimatedRun<3> run(change), reference(change, true);
  const double          error = force_error(run, reference);
  BOOST_TEST_MESSAGE("error " << error << ", bound " << *run.bounds().force);
  BOOST_TEST(run.steady.estimate->load_on_turning_slip.value() > 0.);
  BOOST_TEST(error <= *run.bounds().force);
  BOOST_TEST(*run.bounds().force < 0.01);
}

/**
 * Friction that falls with the sliding speed, in a patch that hardly sticks
 * under spin: every second node tells less than what is wrong.
 */
BOOST_AUTO_TEST_CASE(know_that_falling_friction_hides_from_every_second_node)
{
  const Change change = [](SceneParameters &scene) {
    scene.dimension                    = 3;
    scene.wheel.radius                 = 0.375148555;
    scene.rail.shape                   = "disc";
    scene.rail.radius                  = 0.520515487;
    scene.wheel.lateral_radius         = 1.21922051;
    scene.rail.lateral_radius          = 1.21922051;
    scene.wheel.width                  = 0.1;
    scene.rail.width                   = 0.1;
    scene.contact.normal_load          = 25649.5928;
    scene.contact.creepages            = {0., 0., 1.80656897};
    scene.contact.friction_coefficient = 0.193838073;
    scene.contact.speed                = 35.3154768;
    scene.contact.friction_law         = "exponential";
    scene.contact.kinetic_friction     = 0.0991168651;
    scene.contact.friction_decay_speed = 0.184398519;
    scene.mesh.elements_across_patch   = 8;
    scene.mesh.growth                  = 0.612989312;
    scene.mesh.patch_offset            = -0.0166195092;
  };
  BOOST_TEST(check_force<3>(change, 1.5) > 0.01);
}

/**
 * Under an approach the load lacks what the bulk does.
 */
BOOST_AUTO_TEST_CASE(bound_the_load_under_an_approach)
{
  for (const double growth : {0.1, 0.4, 1.2})
    {
      const Change change = [&](SceneParameters &scene) {
        scene.contact.normal_load.reset();
        scene.contact.approach = 0.12e-3;
        scene.mesh.growth      = growth;
      };
      const EstimatedRun<2> run(change), reference(change, true);
      const double          error = std::abs(run.steady.result.normal_force /
                                      reference.steady.result.normal_force -
                                    1);
      BOOST_TEST_MESSAGE("error " << error << ", bound "
                                  << *run.bounds().normal_force);
      BOOST_TEST(error <= *run.bounds().normal_force);
      BOOST_TEST(*run.bounds().normal_force < 5 * error);
    }
}

BOOST_AUTO_TEST_CASE(fall_with_the_elements_across_the_patch)
{
  const auto across = [](const unsigned int elements) {
    const EstimatedRun<2> run([&](SceneParameters &scene) {
      scene.mesh.elements_across_patch = elements;
    });
    BOOST_TEST(run.steady.estimate->n_positions == 2);
    return run.steady.estimate->across.force / run.steady.result.friction_force;
  };
  const double coarse = across(24), fine = across(96);
  BOOST_TEST(coarse < 0.02);
  BOOST_TEST(fine < coarse / 6);
}

/**
 * Smaller elements at the rim are spread over the larger grid.
 */
BOOST_AUTO_TEST_CASE(are_made_on_refined_rims)
{
  const EstimatedRun<2> run(
    [&](SceneParameters &scene) { scene.mesh.rim_levels = 2; });
  BOOST_TEST(run.steady.estimate->n_positions == 2);
  BOOST_TEST(run.steady.estimate->across.force <
             0.02 * run.steady.result.friction_force);
}

/**
 * What the linearised contact says of small changes of displacements is what
 * the contact does; of the gap but for what the constants of the edge law,
 * which it leaves as they are, follow the pressure.
 */
BOOST_AUTO_TEST_CASE(answer_as_the_contact_does)
{
  const EstimatedRun<2> run(
    [](SceneParameters &scene) { scene.mesh.elements_across_patch = 48; });
  const ContactProblem &problem = run.steady.problem;
  const unsigned int    N       = problem.n_nodes();
  ContactState          weights = open_state(problem);
  for (unsigned int i = 0; i < N; ++i)
    weights.traction(0, i) = problem.operators.areas()[i];
  const auto answers =
    NewtonSystem(problem, run.scene.solver.controls, run.steady.state)
      .sensitivities({weights});
  BOOST_TEST(answers.size() == 1u);
  const double size   = 1e-9; // m
  const auto   change = [&](const unsigned int i) {
    const double a = run.steady.result.half_width_x;
    return size * std::cos(problem.operators.positions()[i][0] / a + 0.4);
  };
  for (const bool normal : {false, true})
    {
      ContactProblem changed  = problem;
      double         expected = 0.;
      if (!normal)
        changed.loads.free_displacement = NodalField(N, 1);
      for (unsigned int i = 0; i < N; ++i)
        {
          (normal ? changed.loads.gap[i]
                  : changed.loads.free_displacement(0, i)) += change(i);
          expected += change(i) * answers[0][normal ? N + i : i];
        }
      ContactState state = run.steady.state;
      make_contact_solver("automatic", run.scene.solver.controls)
        ->solve(changed, state);
      const double found =
        resultants(changed, state).force_x - run.steady.result.force_x;
      BOOST_TEST_MESSAGE((normal ? "gap: " : "slip: ")
                         << found << " N, expected " << expected);
      BOOST_TEST(found == expected,
                 boost::test_tools::tolerance(normal ? 0.2 : 0.01));
    }
}

namespace
{
  /**
   * Circumstances of a state of twins, of so little mesh error that what is
   * asked for shows.
   */
  BoundCircumstances of_twins(const int dim)
  {
    BoundCircumstances found;
    found.dim      = dim;
    found.n        = 16.;
    found.friction = 0.3;
    return found;
  }

  /**
   * The bound of a force that changes by so much, over mu N, on every second
   * node and from the level before.
   */
  ErrorBounds bounds_with_level(const double halving, const LevelChange level)
  {
    ErrorEstimate estimate;
    estimate.n_positions       = 4;
    estimate.across.force      = halving;
    estimate.from_level_before = level;
    estimate.bulk              = ValueChanges();
    Resultants result;
    result.normal_force = result.friction_force = result.half_width_x =
      result.max_pressure                       = 1.;
    return estimated_bounds(of_twins(3), estimate, result);
  }

  double bound_with_level(const double halving, const double level)
  {
    return *bounds_with_level(halving, {level, 0.}).force;
  }
} // namespace

/**
 * The level before is believed where it says little, but not that the state is
 * exact, and where it says much more than every second node.
 */
BOOST_AUTO_TEST_CASE(take_what_the_last_level_changed_for_what_it_is)
{
  BOOST_TEST(bound_with_level(6e-3, 1e-9) == bound_with_level(6e-3, 1e-3));
  BOOST_TEST(bound_with_level(6e-3, 1e-9) < bound_with_level(6e-3, 4e-3));
  const auto tolerance = boost::test_tools::tolerance(1e-9);
  BOOST_TEST(bound_with_level(1e-3, 2e-2) == 2.6e-2, tolerance);
  BOOST_TEST(*bounds_with_level(1e-3, {0., 0.1}).max_pressure == 0.13,
             tolerance);
}

/**
 * Where every node slides the change on every second node counts in full, with
 * an eighth of the load on slip that turns, and never more than what is known
 * of the mesh.
 */
BOOST_AUTO_TEST_CASE(take_sliding_for_what_every_second_node_says)
{
  ErrorEstimate estimate;
  estimate.n_positions          = 4;
  estimate.load_on_turning_slip = 40.;
  estimate.bulk                 = ValueChanges();
  Resultants result;
  result.normal_force   = 10e3;
  result.friction_force = 3e3;
  result.half_width_x = result.max_pressure = result.dissipation = 1.;
  const auto bound = [&](const double change) {
    estimate.across.force = change;
    return *estimated_bounds(of_twins(3), estimate, result).force;
  };
  const auto tolerance = boost::test_tools::tolerance(1e-9);
  BOOST_TEST(bound(3.) == 1e-3 + 40. / 8 / 10e3, tolerance);
  BOOST_TEST(bound(6.) - bound(3.) == 1e-3, tolerance);
  BOOST_TEST(bound(3e3) == *error_bounds(of_twins(3)).force, tolerance);
}

/**
 * The error of upwind 1 comes near to what is known of it, whatever every
 * second node says.
 */
BOOST_AUTO_TEST_CASE(know_that_upwind_1_is_as_bad_as_it_is)
{
  BoundCircumstances found = of_twins(2);
  found.kind               = SlipOperatorKind::upwind_1;
  ErrorEstimate estimate;
  estimate.n_positions  = 2;
  estimate.across.force = 1e-6;
  estimate.bulk         = ValueChanges();
  Resultants result;
  result.normal_force = result.friction_force = result.half_width_x =
    result.max_pressure = result.dissipation = 1.;
  BOOST_TEST(*estimated_bounds(found, estimate, result).force ==
               *error_bounds(found).force,
             boost::test_tools::tolerance(1e-9));
}

/**
 * Edges left to upwind 2 have its error, by their share.
 */
BOOST_AUTO_TEST_CASE(know_which_edges_are_left_to_upwind_2)
{
  for (const int dim : {2, 3})
    {
      BoundCircumstances found = of_twins(dim);
      const double       none  = *error_bounds(found).force;
      found.on_upwind_2        = 0.25;
      const double quarter     = *error_bounds(found).force;
      found.on_upwind_2        = 0.;
      found.kind               = SlipOperatorKind::upwind_2;
      const double all         = *error_bounds(found).force;
      BOOST_TEST(quarter - none == 0.25 * all,
                 boost::test_tools::tolerance(1e-6));
    }
}

/**
 * Elements of the zone of contact shift the slip as well, which little friction
 * makes a larger part of the force.
 */
BOOST_AUTO_TEST_CASE(know_that_little_friction_enlarges_errors)
{
  BoundCircumstances found = of_twins(2);
  const auto         bound = [&](const double friction) {
    found.friction = friction;
    return *error_bounds(found).force;
  };
  BOOST_TEST(bound(0.11) == bound(0.6));
  BOOST_TEST(bound(0.02) == 5 * bound(0.1), boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(take_smooth_forces_for_what_they_are)
{
  const SmoothForces::Positions at{
    {{-1, 0}}, {{-0.5, 0.3}}, {{0, -0.4}}, {{0.5, 0.2}}, {{0.8, 0.1}}};
  const SmoothForces smooth(at, {1, 2, 1, 2, 1}, {{1.1, 0.6}}, 2);
  BOOST_TEST(smooth.forces().size() == 6u);
  std::vector<double> sum(2 * at.size(), 0.);
  for (std::size_t k = 0; k < smooth.forces().size(); ++k)
    for (std::size_t i = 0; i < sum.size(); ++i)
      sum[i] += (k + 1.) * smooth.forces()[k][i];
  const auto amounts = smooth.amounts(at, sum);
  for (unsigned int k = 0; k < 6; ++k)
    BOOST_TEST(amounts[k] == k + 1., boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_SUITE_END()
