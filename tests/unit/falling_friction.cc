#include <boost/test/unit_test.hpp>

#include "half_plane.h"
#include "response_check.h"

#include <rolling_contact/contact/invariants.h>
#include <rolling_contact/contact/patch_area.h>
#include <rolling_contact/contact/uniqueness.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace RollingContact;
using namespace HalfPlane;

/** Friction that falls with the sliding speed, in contact space. */
BOOST_AUTO_TEST_SUITE(falling_friction)

namespace
{
  const double kinetic = 0.4; ///< over mu

  ContactProblem falling(const Options     &options,
                         const double       decay_speed,
                         const std::string &law   = "exponential",
                         const double       speed = 1.)
  {
    ContactProblem problem     = half_plane_problem(options);
    problem.loads.friction_law = make_friction_law(law, kinetic, decay_speed);
    problem.loads.speed        = speed;
    return problem;
  }

  /**
   * From mu_s everywhere or, as if all slid fast, from mu_k.
   */
  Solution solve_from(const ContactProblem &problem, const double share)
  {
    Solution solution;
    solution.state.friction.assign(problem.n_nodes(), share * mu);
    solution.report = make_contact_solver("automatic", SolverControls())
                        ->solve(problem, solution.state);
    solution.result = resultants(problem, solution.state);
    return solution;
  }

  double distance(const std::vector<double> &x, const std::vector<double> &y)
  {
    double largest = 0.;
    for (std::size_t i = 0; i < x.size(); ++i)
      largest = std::max(largest, std::abs(x[i] - y[i]));
    return largest;
  }

  Options upstream(const double creepage, const unsigned int n_elements = 48)
  {
    Options options;
    options.kind       = SlipOperatorKind::upwind_2;
    options.creepage   = creepage;
    options.n_elements = n_elements;
    return options;
  }

  /**
   * The slip from nothing but the half-plane's compliance and a difference over
   * three nodes: s = s_0 + (3 u_i - 4 u_(i-1) + u_(i-2)) / (2 h).
   */
  std::vector<double> slip_by_hand(const Options             &options,
                                   const ContactProblem      &problem,
                                   const std::vector<double> &traction)
  {
    const int           n = problem.n_nodes();
    const double        h = 2. / options.n_elements;
    std::vector<double> u(n, 0.), s(n, options.creepage * mu);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        u[i] += half_plane(i, j, h) * h * traction[j];
    for (int i = 2; i < n; ++i)
      s[i] += (3 * u[i] - 4 * u[i - 1] + u[i - 2]) / (2 * h);
    return s;
  }

  double exponential(const double speed, const double decay_speed)
  {
    return mu * (kinetic + (1 - kinetic) * std::exp(-speed / decay_speed));
  }
} // namespace

BOOST_AUTO_TEST_CASE(laws_are_those_published)
{
  // Polach 2005, dry: mu_0 ((1 - A) exp(-B v) + A)
  const double mu_0 = 0.55, A = 0.4, B = 0.6;
  const auto   polach   = make_friction_law("exponential", A, 1 / B);
  const auto   rational = make_friction_law("rational", A, 1 / B);
  for (const double v : {0., 1e-9, 0.1, 1., 10., 1e3})
    {
      BOOST_TEST(std::abs(mu_0 * (1 - polach->drop(v)) -
                          mu_0 * ((1 - A) * std::exp(-B * v) + A)) < 1e-15);
      BOOST_TEST(std::abs(mu_0 * (1 - rational->drop(v)) -
                          mu_0 * (A + (1 - A) / (1 + B * v))) < 1e-15);
    }
  // CONTACT: half of the drop at the speed s_h
  BOOST_TEST(std::abs(polach->drop(std::log(2.) / B) - (1 - A) / 2) < 1e-15);
  BOOST_TEST(std::abs(rational->drop(1 / B) - (1 - A) / 2) < 1e-15);
  BOOST_TEST(make_friction_law("constant", A, 1 / B).get() == nullptr);
}

BOOST_AUTO_TEST_CASE(slopes_and_steepest_falls)
{
  for (const char *name : {"exponential", "rational"})
    {
      const auto law = make_friction_law(name, kinetic, 0.7);
      for (const double v : {0.01, 0.5, 3.})
        {
          const double h = 1e-4 * v;
          BOOST_TEST(std::abs((law->drop(v + h) - law->drop(v - h)) /
                                (2 * h * law->slope(v)) -
                              1) < 1e-6);
          double steepest = 0.; // from sliding at v to any other speed
          for (double w = 1e-5; w < 100.; w *= 1.003)
            if (std::abs(w - v) > 0.01 * v)
              steepest =
                std::max(steepest, (law->drop(v) - law->drop(w)) / (v - w));
          BOOST_TEST(
            std::abs(steepest / law->steepest_fall(1 - law->drop(v), v) - 1) <
            1e-4);
        }
      for (const double carried : {1., 0.9, 0.6})
        {
          double steepest = 0.; // from sticking with this traction
          for (double w = 1e-6; w < 100.; w *= 1.001)
            steepest = std::max(steepest, (carried - 1 + law->drop(w)) / w);
          BOOST_TEST(std::abs(steepest / law->steepest_fall(carried, 0.) - 1) <
                     1e-5);
        }
      BOOST_TEST(law->steepest_fall(0.39, 0.) <= 0.);
    }
}

BOOST_AUTO_TEST_CASE(in_full_slip_every_node_carries_the_law_at_its_own_slip)
{
  const double         decay   = 0.3;
  const Options        options = upstream(2.);
  const ContactProblem problem = falling(options, decay);
  const Solution       found   = solve(problem);
  BOOST_TEST(found.report.converged);
  const auto s = slip_by_hand(options, problem, found.state.traction.values());
  double     least = 1., most = 0.;
  for (unsigned int i = 0; i < problem.n_nodes(); ++i)
    if (found.state.pressure[i] > 0.)
      {
        const double mu_i = exponential(s[i], decay);
        least             = std::min(least, mu_i);
        most              = std::max(most, mu_i);
        BOOST_TEST(s[i] > 0.);
        BOOST_TEST(std::abs(found.state.traction(0, i) +
                            mu_i * found.state.pressure[i]) < 1e-9);
      }
  BOOST_TEST(most - least > 0.05 * mu); // not all of one mu
}

BOOST_AUTO_TEST_CASE(another_method_on_the_same_compliance)
{
  // extragradient with mu of every trial: no active sets, no held mu
  const double decay = 0.3, rho = 0.3;
  for (const double creepage : {0.2, 0.5, 0.8})
    {
      const Options        options = upstream(creepage, 24);
      const ContactProblem problem = falling(options, decay);
      const Solution       found   = solve(problem);
      BOOST_TEST(found.report.converged);
      std::vector<double> q(problem.n_nodes(), 0.);
      const auto          step = [&](const std::vector<double> &at) {
        const auto          s = slip_by_hand(options, problem, at);
        std::vector<double> next(q);
        for (unsigned int i = 0; i < problem.n_nodes(); ++i)
          {
            const double bound =
              exponential(std::abs(s[i]), decay) * found.state.pressure[i];
            next[i] = std::max(-bound, std::min(bound, q[i] - rho * s[i]));
          }
        return next;
      };
      double change = 1.;
      for (unsigned int k = 0; k < 20000 && change > 1e-13; ++k)
        {
          const auto next = step(step(q));
          change          = distance(next, q);
          q               = next;
        }
      BOOST_TEST(distance(q, found.state.traction.values()) < 1e-9);
    }
}

BOOST_AUTO_TEST_CASE(coarse_half_planes_come_near_a_fine_one)
{
  for (const SlipOperatorKind kind :
       {SlipOperatorKind::upwind_2, SlipOperatorKind::calibrated})
    for (const double creepage : {0.3, 0.7})
      {
        Options options        = upstream(creepage, 384);
        options.kind           = SlipOperatorKind::calibrated;
        const double converged = force(solve(falling(options, 0.5)));
        options.kind           = kind;
        options.n_elements     = 48;
        double largest         = 0.;
        for (const double offset : {0., 0.25, 0.5, 0.75})
          {
            options.offset = offset;
            largest        = std::max(largest,
                               std::abs(force(solve(falling(options, 0.5))) -
                                        converged));
          }
        BOOST_TEST(largest <
                   (kind == SlipOperatorKind::calibrated ? 1e-3 : 1e-2));
      }
}

BOOST_AUTO_TEST_CASE(limits_of_the_law_are_constant_friction)
{
  for (const double creepage : {0.3, 1.5})
    {
      Options options;
      options.creepage           = creepage;
      ContactProblem problem     = half_plane_problem(options);
      const Solution constant    = solve(problem);
      problem.loads.speed        = 7.;
      problem.loads.friction_law = make_friction_law("rational", 1., 1e-3);
      const Solution no_drop     = solve(problem);
      BOOST_TEST((no_drop.state.traction == constant.state.traction));
      BOOST_TEST(no_drop.state.pressure == constant.state.pressure);
      problem.loads.friction_law = make_friction_law("exponential", 0.2, 1e15);
      const Solution slow_drop   = solve(problem);
      BOOST_TEST(distance(slow_drop.state.traction.values(),
                          constant.state.traction.values()) < 1e-13);
      problem.loads.friction_law = make_friction_law("exponential", 0.2, 1e-3);
      problem.loads.speed        = 0.;
      BOOST_TEST((solve(problem).state.traction == constant.state.traction));
    }
}

BOOST_AUTO_TEST_CASE(speeds_enter_by_their_ratio_and_units_not_at_all)
{
  Options options;
  options.creepage   = 0.6;
  const Solution one = solve(falling(options, 0.4, "rational", 2.)),
                 ten = solve(falling(options, 4., "rational", 20.));
  BOOST_TEST(
    distance(one.state.traction.values(), ten.state.traction.values()) < 1e-12);
  options.length_unit        = 1e3;
  options.pressure_unit      = 1e-6;
  const Solution millimetres = solve(falling(options, 400., "rational", 2e3));
  BOOST_TEST(std::abs(force(one) - force(millimetres)) < 1e-11);
  BOOST_TEST(one.report.friction_rounds == millimetres.report.friction_rounds);
}

BOOST_AUTO_TEST_CASE(the_residual_judges_mu_at_the_own_slip)
{
  const ContactProblem problem  = falling(upstream(0.7), 0.3);
  ContactState         state    = solve(problem).state;
  const auto           residual = [&](const ContactState &of) {
    return natural_residual(problem, tangential_problem(problem, of), of)
      .worst();
  };
  BOOST_TEST(residual(state) <= 1e-10);
  BOOST_TEST(invariants(problem, state).worst().second <= 1e-10);
  // another mu held does not matter once it is let go
  std::fill(state.friction.begin(), state.friction.end(), mu);
  BOOST_TEST(residual(state) <= 1e-10);
  ContactProblem constant     = problem;
  constant.loads.friction_law = nullptr;
  const ContactState coulomb  = solve(constant).state;
  BOOST_TEST(residual(coulomb) > 1e-2);
  BOOST_TEST(invariants(problem, coulomb).cone > 1e-2);
}

BOOST_AUTO_TEST_CASE(less_friction_at_a_node_lets_all_slide_as_predicted)
{
  for (const double rate : {0., 1.})
    {
      ContactProblem problem = half_plane_problem(upstream(0.4));
      problem.operators.set_time_scaling({1., rate});
      BOOST_TEST(error_of_response(problem, solve(problem).state) < 1e-5);
    }
}

BOOST_AUTO_TEST_CASE(energy_closes_and_the_sawtooth_stays_small)
{
  Options options;
  options.n_elements = 96;
  for (const double creepage : {0.3, 0.7, 1.5})
    {
      options.creepage     = creepage;
      const Solution found = solve(falling(options, 0.4));
      BOOST_TEST(found.report.converged);
      BOOST_TEST(found.result.dissipation > 0.);
      BOOST_TEST(found.result.energy_error() < 0.01);
      // against constant friction, whose sawtooth is that of the edges
      ContactProblem constant = half_plane_problem(options);
      const auto     sawtooth = [](const Solution &of) {
        double      largest = 0.;
        const auto &q       = of.state.traction.values();
        for (std::size_t i = 1; i + 1 < q.size(); ++i)
          largest =
            std::max(largest,
                     std::abs(q[i + 1] - 2 * q[i] + q[i - 1]) / (4 * mu));
        return largest;
      };
      BOOST_TEST(sawtooth(found) < sawtooth(solve(constant)) + 0.03);
    }
}

namespace
{
  /**
   * Nodes that know nothing of each other, as in a step so short that only the
   * rate counts: s = s_0 + rate W H q node by node.
   */
  ContactProblem separate_nodes(const double rigid_slip)
  {
    Options        options = upstream(1., 12);
    ContactProblem problem = falling(options, 0.02);
    DenseMatrix    W       = problem.operators.W().dense();
    for (std::size_t j = 0; j < problem.n_nodes(); ++j)
      for (std::size_t i = 0; i < problem.n_nodes(); ++i)
        W(i, j) = i == j ? 1. : 0.;
    problem.operators.set_compliance(std::move(W));
    problem.operators.set_time_scaling({0., 1.});
    problem.loads.creepages = {rigid_slip, 0., 0.};
    return problem;
  }
} // namespace

/** One node: the ratio reaches 1 exactly where a second solution appears. */
BOOST_AUTO_TEST_CASE(two_solutions_of_a_step_and_the_warning_come_together)
{
  unsigned int n_two = 0, n_one = 0;
  for (double rigid_slip = 1e-3; rigid_slip < 0.08; rigid_slip *= 1.01)
    {
      const ContactProblem problem = separate_nodes(rigid_slip);
      const Solution       stick   = solve_from(problem, 1.),
                     slide         = solve_from(problem, kinetic);
      BOOST_TEST(stick.report.converged);
      BOOST_TEST(slide.report.converged);
      const double difference = distance(stick.state.traction.values(),
                                         slide.state.traction.values()),
                   ratio      = uniqueness(problem, stick.state).ratio,
                   other      = uniqueness(problem, slide.state).ratio;
      BOOST_TEST_CONTEXT("rigid slip " << rigid_slip << ": " << difference
                                       << ", ratios " << ratio << " " << other)
      {
        if (difference > 1e-6)
          {
            ++n_two;
            BOOST_TEST(ratio > 0.999);
            BOOST_TEST(other > 0.999);
          }
        else if (ratio < 1.)
          ++n_one;
        // where one is found, the ratio can only be above 1 for a third one
        // between, next to where two of them meet
        if (difference <= 1e-6)
          BOOST_TEST(ratio < 1.05);
      }
    }
  BOOST_TEST(n_two > 10u);
  BOOST_TEST(n_one > 10u);
}

namespace
{
  /**
   * The different states found from four starts: mu_s, mu_k, either of them in
   * front of the middle.
   */
  std::vector<ContactState>
  states_from_many_starts(const ContactProblem &problem)
  {
    std::vector<ContactState> states;
    for (const std::array<double, 2> share : {std::array<double, 2>{{1., 1.}},
                                              {{kinetic, kinetic}},
                                              {{1., kinetic}},
                                              {{kinetic, 1.}}})
      {
        ContactState state;
        for (const auto &position : problem.operators.positions())
          state.friction.push_back(mu * share[position[0] > 0.]);
        if (!make_contact_solver("automatic", SolverControls())
               ->solve(problem, state)
               .converged)
          continue;
        if (std::none_of(states.begin(), states.end(), [&](const auto &other) {
              return distance(other.traction.values(),
                              state.traction.values()) < 1e-6;
            }))
          states.push_back(state);
      }
    return states;
  }
} // namespace

/** Steady rolling: several states from several starts where the law is steep.
 */
BOOST_AUTO_TEST_CASE(several_steady_states_and_the_warning_come_together)
{
  double lowest_of_several = 1e9, highest_of_one = 0.;
  for (const unsigned int n_elements : {24, 48})
    for (const double decay : {10., 1., 0.3, 0.2, 0.12, 0.08, 0.06, 0.03, 0.01})
      for (const double creepage : {0.05, 0.1, 0.3, 0.5, 0.7, 1., 2.})
        {
          const ContactProblem problem =
            falling(upstream(creepage, n_elements), decay);
          const auto states = states_from_many_starts(problem);
          BOOST_TEST(!states.empty());
          for (const ContactState &state : states)
            {
              const double ratio = uniqueness(problem, state).ratio;
              if (states.size() > 1)
                lowest_of_several = std::min(lowest_of_several, ratio);
              else
                highest_of_one = std::max(highest_of_one, ratio);
              if (decay >= mu) // as steep as saturation creepage is large
                BOOST_TEST(ratio < Uniqueness::limit);
            }
        }
  BOOST_TEST_MESSAGE("lowest ratio of several states " << lowest_of_several
                                                       << ", highest of one "
                                                       << highest_of_one);
  BOOST_TEST(lowest_of_several > Uniqueness::limit);
  BOOST_TEST(lowest_of_several < 1.5);
  BOOST_TEST(highest_of_one < 3.);
}

/** Without inertia a step half as long has twice the ratio. */
BOOST_AUTO_TEST_CASE(short_steps_without_inertia_have_large_ratios)
{
  double previous = 0.;
  for (const double step : {0.04, 0.02, 0.01})
    {
      ContactProblem problem = falling(upstream(3e4), 1e3);
      problem.operators.set_time_scaling({1., 1 / step});
      const Solution found = solve(problem);
      BOOST_TEST(found.report.converged);
      BOOST_TEST(patch_areas(problem, found.state).stick == 0.);
      const double ratio = uniqueness(problem, found.state).ratio;
      if (previous > 0.)
        BOOST_TEST(std::abs(ratio / previous - 2.) < 0.2);
      previous = ratio;
    }
}

/** Friction that rises with the speed leaves one state, however steep it is. */
BOOST_AUTO_TEST_CASE(friction_that_rises_has_no_ratio)
{
  ContactProblem problem     = half_plane_problem(upstream(0.5));
  problem.loads.speed        = 1.;
  problem.loads.friction_law = make_friction_law("exponential", 1.3, 1.);
  const Solution found       = solve(problem);
  BOOST_TEST(found.report.converged);
  BOOST_TEST(uniqueness(problem, found.state).ratio == 0.);
}

BOOST_AUTO_TEST_CASE(steep_laws_converge_or_say_so)
{
  unsigned int n_failed = 0;
  for (const char *law : {"exponential", "rational"})
    for (const double decay : {0.1, 0.01, 0.001})
      for (const double creepage : {0.1, 0.5, 1., 4.})
        for (const double rate : {0., 1., 10.})
          {
            Options options        = upstream(creepage, 24);
            options.kind           = SlipOperatorKind::calibrated;
            ContactProblem problem = falling(options, decay, law);
            problem.operators.set_time_scaling({1., rate});
            const Solution found = solve(problem);
            n_failed += !found.report.converged;
            BOOST_TEST(found.report.converged ==
                       (found.report.residual.worst() <= 1e-10));
            BOOST_TEST(found.report.converged == found.report.reason.empty());
          }
  BOOST_TEST(n_failed <= 1u);
}

BOOST_AUTO_TEST_SUITE_END()
