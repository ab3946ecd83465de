#include <boost/test/unit_test.hpp>

#include "complaint.h"
#include "stability_bodies.h"

#include <rolling_contact/contact/resultants.h>
#include <rolling_contact/time/patch_friction.h>

#include <functional>

using namespace RollingContact;
using namespace StabilityBodies;

/** Linearised contact, beside the contact solvers. */
BOOST_AUTO_TEST_SUITE(stability_contact)

namespace
{
  RollingState state_on(const Grid            &grid,
                        const Creepages       &creepages,
                        const SlipOperatorKind kind,
                        const int              flow,
                        const bool             alike)
  {
    DenseMatrix        W = half_space(grid, 80e9, 0.3);
    const Eigen::Index n = grid.n_nodes(), t = grid.n_tangential() * n;
    if (alike) // pressures do not move the surfaces along
      W.topRightCorner(t, n).setZero(), W.bottomLeftCorner(n, t).setZero();
    RollingState rolling{
      rolling_problem(grid, W, 0.4, creepages, 3.1e-5, kind, flow), {}};
    const ContactOperators &built = rolling.problem.operators;
    rolling.problem.operators     = ContactOperators(
      built.positions(), built.H(), W, built.slip_operator(), {!alike});
    rolling.solve();
    return rolling;
  }

  RollingState
  half_space_state(const Grid            &grid,
                   const Creepages       &creepages,
                   const SlipOperatorKind kind = SlipOperatorKind::upwind_2,
                   const int              flow = 1)
  {
    return state_on(grid, creepages, kind, flow, false);
  }

  /**
   * The state after the bodies moved by @p size times a motion and a rate of
   * motion of their own.
   */
  RollingState moved_rolling(const RollingState        &rolling,
                             const std::vector<double> &motion,
                             const std::vector<double> &velocity,
                             const double               size)
  {
    RollingState      moved = rolling;
    ContactLoads     &loads = moved.problem.loads;
    const std::size_t N     = moved.problem.n_nodes(),
                      T     = moved.problem.n_tangential();
    loads.free_displacement = loads.free_slip = NodalField(N, T);
    for (std::size_t i = 0; i < N; ++i)
      {
        loads.gap[i] += size * motion[T * N + i];
        for (std::size_t c = 0; c < T; ++c)
          {
            loads.free_displacement(c, i) = size * motion[c * N + i];
            loads.free_slip(c, i)         = size * velocity[c * N + i] / speed;
          }
      }
    if (rolling.state.scheme.empty())
      moved.solve();
    else
      moved.solve_holding_scheme();
    BOOST_TEST(moved.converged);
    return moved;
  }

  std::vector<double> moved_state(const RollingState        &rolling,
                                  const std::vector<double> &motion,
                                  const std::vector<double> &velocity,
                                  const double               size)
  {
    const RollingState  moved = moved_rolling(rolling, motion, velocity, size);
    std::vector<double> unknowns = moved.state.traction.values();
    unknowns.insert(unknowns.end(),
                    moved.state.pressure.begin(),
                    moved.state.pressure.end());
    return unknowns;
  }

  /**
   * Largest difference of the linear contact from the solver's answers to
   * motions, over the largest answer.
   */
  double difference_from_solver(const RollingState    &rolling,
                                const FrictionResponse friction)
  {
    const LinearContact contact =
      linear_contact(rolling.problem, rolling.state, at_speed(friction));
    BOOST_TEST(contact.n_border() == 0u);
    const std::size_t N = contact.n_nodes, T = contact.n_tangential,
                      n = contact.touching.size();
    std::mt19937                     generator(3);
    std::normal_distribution<double> normal;
    double                           worst = 0.;
    for (unsigned int sample = 0; sample < 4; ++sample)
      {
        std::vector<double> motion((T + 1) * N), velocity((T + 1) * N);
        for (std::size_t k = 0; k < motion.size(); ++k)
          {
            motion[k]   = sample == 1 ? 0. : 1e-9 * normal(generator);
            velocity[k] = sample == 0 ? 0. : 1e-5 * normal(generator);
          }
        // the edge law looks at how smooth the bodies are
        if (!rolling.state.scheme.empty())
          {
            const auto  &at = rolling.problem.operators.positions();
            const double a = normal(generator), b = normal(generator),
                         turn = normal(generator);
            for (std::size_t k = 0; k < motion.size(); ++k)
              {
                const auto  &x      = at[k % N];
                const double smooth = a + turn * std::cos(400 * x[0] + k / N) +
                                      b * std::sin(300 * x[0] - 200 * x[1]);
                motion[k]   = sample == 1 ? 0. : 1e-10 * smooth;
                velocity[k] = sample == 0 ? 0. : 1e-6 * smooth;
              }
          }
        // (N_u W forces + N_r) dx = -N_u motion - N_v velocity
        DenseMatrix M = contact.N_u * (rolling.problem.operators.W().dense() *
                                       contact.forces);
        M += contact.N_r;
        Eigen::VectorXd dx =
          -contact.N_u * as_vector(motion) - contact.N_v * as_vector(velocity);
        BOOST_TEST_REQUIRE(solve_general(M, dx));
        const auto above = moved_state(rolling, motion, velocity, 1.),
                   below = moved_state(rolling, motion, velocity, -1.);
        double largest = 0., error = 0.;
        for (std::size_t c = 0; c <= T; ++c)
          for (std::size_t k = 0; k < n; ++k)
            {
              const std::size_t at     = c * N + contact.touching[k];
              const double      change = (above[at] - below[at]) / 2;
              largest                  = std::max(largest, std::abs(change));
              error = std::max(error, std::abs(change - dx(c * n + k, 0)));
            }
        worst = std::max(worst, error / largest);
      }
    return worst;
  }
} // namespace

BOOST_AUTO_TEST_CASE(the_linear_contact_is_the_derivative_of_the_solver)
{
  const Grid line{9, 1}, plane{7, 5};
  for (const int flow : {1, -1})
    for (const double creepage : {0.02, 4e-4})
      for (const auto kind :
           {SlipOperatorKind::upwind_1, SlipOperatorKind::upwind_2})
        {
          const RollingState state =
            half_space_state(line, {creepage, 0., 0.}, kind, flow);
          BOOST_TEST(state.converged);
          const auto contact =
            linear_contact(state.problem, state.state, at_speed());
          BOOST_TEST((contact.n_slip() == contact.touching.size()) ==
                     (creepage > 0.01));
          BOOST_TEST(contact.n_slip() > 0u);
          BOOST_TEST(difference_from_solver(state, FrictionResponse::constant) <
                     1e-6);
        }
  for (const Creepages &creepages :
       {Creepages{0.01, -0.02, 1.}, Creepages{4e-4, -6e-4, 0.3}})
    {
      const RollingState state = half_space_state(plane, creepages);
      const auto         contact =
        linear_contact(state.problem, state.state, at_speed());
      BOOST_TEST((contact.n_slip() == contact.touching.size()) ==
                 (creepages.spin > 0.5));
      BOOST_TEST(contact.n_slip() > 0u);
      BOOST_TEST(difference_from_solver(state, FrictionResponse::constant) <
                 1e-5);
    }
}

/** With the scheme held, the edge law answers as its linearisation says. */
BOOST_AUTO_TEST_CASE(the_edge_law_is_linearised_as_it_is_solved)
{
  const auto check = [](const Grid      &grid,
                        const Creepages &creepages,
                        const int        flow,
                        const bool       alike) {
    const RollingState state =
      state_on(grid, creepages, SlipOperatorKind::calibrated, flow, alike);
    BOOST_TEST(state.converged);
    BOOST_TEST(state.problem.operators.coupling().exists == !alike);
    BOOST_TEST(!state.state.scheme.empty());
    const auto contact = linear_contact(state.problem, state.state, at_speed());
    BOOST_TEST(contact.n_slip() > 0u);
    BOOST_TEST(contact.n_slip() < contact.touching.size());
    BOOST_TEST(difference_from_solver(state, FrictionResponse::constant) <
               1e-5);
  };
  for (const bool alike : {false, true})
    {
      for (const int flow : {1, -1})
        check({25, 1, 0.35e-3}, {4e-4, 0., 0.}, flow, alike);
      check({15, 9, 0.5e-3}, {4e-4, -6e-4, 0.3}, 1, alike);
    }
}

/** How much of a change of load friction carries, by the linear contact and by
 * the solver over several elements of the half-width: upwind 2 loses what the
 * leading edge moves. */
BOOST_AUTO_TEST_CASE(the_edge_of_a_stick_zone_moves_with_the_load)
{
  const Grid fine{61, 1, 0.15e-3};
  const auto share = [&](const SlipOperatorKind kind, double &differences) {
    const double mean = 3.1e-5, part = 0.1;
    RollingState states[3];
    for (int k = 0; k < 3; ++k)
      {
        states[k] = {rolling_problem(fine,
                                     half_space(fine, 80e9, 0.3),
                                     0.4,
                                     {4e-4, 0., 0.},
                                     mean * (1 + part * (k - 1)),
                                     kind),
                     {}};
        states[k].solve();
        BOOST_TEST(states[k].converged);
      }
    const auto sums = [&](const RollingState &state) {
      const Resultants result = resultants(state.problem, state.state);
      return std::array<double, 2>{{result.normal_force, result.force_x}};
    };
    differences = (sums(states[2])[1] - sums(states[0])[1]) /
                  (sums(states[2])[0] - sums(states[0])[0]);
    const LinearContact contact =
      linear_contact(states[1].problem, states[1].state, at_speed());
    const std::size_t N = contact.n_nodes;
    DenseMatrix       M =
      contact.N_u * (states[1].problem.operators.W().dense() * contact.forces);
    M += contact.N_r;
    std::vector<double> motion(2 * N, 0.);
    std::fill(motion.begin() + N, motion.end(), -1.);
    Eigen::VectorXd dx = -contact.N_u * as_vector(motion);
    BOOST_TEST_REQUIRE(solve_general(M, dx));
    const Eigen::VectorXd forces = contact.forces * dx;
    return forces.head(N).sum() / forces.tail(N).sum();
  };
  double       by_law = 0., by_upwind = 0.;
  const double law    = share(SlipOperatorKind::calibrated, by_law),
               upwind = share(SlipOperatorKind::upwind_2, by_upwind);
  BOOST_TEST_MESSAGE("dT/dN by edge law " << law << " of " << by_law
                                          << ", upwind 2 " << upwind << " of "
                                          << by_upwind);
  BOOST_TEST(law == by_law, boost::test_tools::tolerance(0.1));
  BOOST_TEST(std::abs(upwind / by_law - 1) > 0.5);
}

BOOST_AUTO_TEST_CASE(the_contact_matrix_need_not_be_diagonal)
{
  const Grid   grid{9, 1};
  RollingState state      = half_space_state(grid, {0.02, 0., 0.});
  const auto  &lumped     = state.problem.operators;
  const Trace  trace      = grid.trace();
  state.problem.operators = ContactOperators(
    trace.nodes,
    contact_matrix(trace, ContactMatrices::consistent, grid.size),
    lumped.W(),
    lumped.slip_operator());
  state.solve();
  BOOST_TEST(state.converged);
  BOOST_TEST(difference_from_solver(state, FrictionResponse::constant) < 1e-6);
}

BOOST_AUTO_TEST_CASE(the_slope_of_falling_friction_is_that_of_the_solver)
{
  for (const unsigned int n_y : {1, 5})
    {
      RollingState state =
        half_space_state({7, n_y}, {0.01, n_y == 1 ? 0. : -0.02, 0.});
      state.problem.loads.friction_law =
        make_friction_law("exponential", 0.7, 0.3);
      state.problem.loads.speed = speed;
      state.solve();
      BOOST_TEST(state.converged);
      BOOST_TEST(difference_from_solver(state, FrictionResponse::node) < 1e-4);
      // which sees the slope
      BOOST_TEST(difference_from_solver(state, FrictionResponse::constant) >
                 1e-2);
    }
}

namespace
{
  void check_mean_sliding_speed(const RollingState &rolling)
  {
    const std::shared_ptr<const FrictionLaw> law =
      make_friction_law("exponential", 0.7, 0.3);
    const auto contact = [&]() {
      RollingState falls               = rolling;
      falls.problem.loads.friction_law = law;
      falls.problem.loads.speed        = speed;
      return linear_contact(falls.problem,
                            falls.state,
                            at_speed(FrictionResponse::patch_mean));
    }();
    const std::size_t N = contact.n_nodes, T = contact.n_tangential,
                      n = contact.n_tractions(), row = n;
    std::mt19937                     generator(5);
    std::normal_distribution<double> normal;
    std::vector<double> motion((T + 1) * N), none(motion.size(), 0.);
    // smooth, as the edge law looks at how smooth the bodies are
    const auto  &at = rolling.problem.operators.positions();
    const double a = normal(generator), b = normal(generator);
    for (std::size_t i = 0; i < motion.size(); ++i)
      motion[i] =
        1e-10 * (a * std::cos(400 * at[i % N][0] + i / N) +
                 b * std::sin(300 * at[i % N][0] - 200 * at[i % N][1]));
    const RollingState above = moved_rolling(rolling, motion, none, 1.),
                       below = moved_rolling(rolling, motion, none, -1.);
    const auto mean          = [&](const RollingState &state) {
      ContactProblem problem = state.problem;
      problem.loads.speed    = speed;
      return mean_sliding_speed(problem, state.state);
    };
    Eigen::VectorXd dx = Eigen::VectorXd::Zero(contact.n_unknowns());
    for (std::size_t c = 0; c <= T; ++c)
      for (std::size_t k = 0; k < contact.touching.size(); ++k)
        {
          const unsigned int i      = contact.touching[k];
          const auto         change = [&](const RollingState &state) {
            return c < T ? state.state.traction(c, i) : state.state.pressure[i];
          };
          dx[c * contact.touching.size() + k] =
            (change(above) - change(below)) / 2;
        }
    const Eigen::VectorXd u =
      rolling.problem.operators.W().dense() * (contact.forces * dx) +
      as_vector(motion);
    const double slope = law->slope(mean(rolling)),
                 found =
                   contact.N_u.row(row).dot(u) + contact.N_r.row(row).dot(dx),
                 expected = slope * (mean(above) - mean(below)) / 2;
    BOOST_TEST(found == expected, boost::test_tools::tolerance(1e-5));
    // of which the pressures are a part
    const double of_pressures = contact.N_r.row(row).dot(dx);
    BOOST_TEST(std::abs(of_pressures) > 1e-2 * std::abs(expected));
  }
} // namespace

/** The mean sliding speed that friction follows changes with the slip and with
 * the pressures that it is weighted by, as in time, and at edges with what the
 * edge law makes of both. */
BOOST_AUTO_TEST_CASE(the_mean_sliding_speed_is_that_of_the_time_law)
{
  for (const auto kind :
       {SlipOperatorKind::upwind_2, SlipOperatorKind::calibrated})
    for (const Creepages &creepages :
         {Creepages{0.01, -0.02, 3.}, Creepages{4e-4, -6e-4, 0.3}})
      check_mean_sliding_speed(
        half_space_state({15, 9, 0.5e-3}, creepages, kind));
}

BOOST_AUTO_TEST_CASE(what_has_no_stability_is_refused)
{
  const Grid         grid{7, 5};
  const RollingState good = half_space_state(grid, {0.02, 0.01, 0.});
  const auto         wrong =
    [&](const std::function<void(RollingState &, LinearContactOptions &)>
          &change) {
      RollingState         state   = good;
      LinearContactOptions options = at_speed(FrictionResponse::patch_mean);
      change(state, options);
      return complaint(
        [&]() { linear_contact(state.problem, state.state, options); });
    };
  BOOST_TEST(wrong([](auto &, auto &) {}).empty());
  BOOST_TEST(contains(wrong([](auto &, auto &options) { options.speed = 0.; }),
                      "Contact/Speed = 0 m/s"));
  BOOST_TEST(
    contains(wrong([](auto &, auto &options) { options.speed = std::nan(""); }),
             "Contact/Speed = nan m/s"));
  BOOST_TEST(contains(wrong([](auto &state, auto &) {
                        state.problem.operators.set_time_scaling({1., 100.});
                      }),
                      "stability of a time step"));
  BOOST_TEST(contains(wrong([](auto &state, auto &) {
                        state.state = open_state(state.problem);
                        state.problem.loads.approach = -1.;
                        state.state.approach         = -1.;
                      }),
                      "do not touch"));
  const auto falling = [](RollingState &state) {
    state.problem.loads.friction_law = make_friction_law("rational", 0.5, 0.2);
    state.problem.loads.speed        = speed;
  };
  BOOST_TEST(contains(wrong([&](auto &state, auto &options) {
                        falling(state);
                        options.memory = 0.;
                      }),
                      "memory of friction is 0 s"));
  BOOST_TEST(contains(wrong([&](auto &state, auto &) {
                        falling(state);
                        state.problem.loads.memory_length = 1e-3;
                      }),
                      "Contact/Friction memory length = 0.001 m"));
  BOOST_TEST(contains(wrong([&](auto &state, auto &) {
                        state = half_space_state(grid,
                                                 {0.02, 0., 0.},
                                                 SlipOperatorKind::galerkin);
                      }),
                      "Contact/Slip operator = galerkin"));
}

BOOST_AUTO_TEST_CASE(bodies_that_do_not_fit_are_refused)
{
  const Grid         grid{7, 5};
  const RollingState good = half_space_state(grid, {0.02, 0.01, 0.});
  ReducedPair        pair = random_pair(grid, 4, 1);
  check(pair);
  const double largest = symmetric_eigenvalues(pair.W_res).back();
  for (unsigned int i = 0; i < pair.W_res.rows(); ++i)
    pair.W_res(i, i) -= 0.5 * largest;
  BOOST_TEST(contains(complaint([&]() { check(pair); }),
                      "come from the same stiffness matrix"));
  pair.Phi = DenseMatrix::Zero(7, 4);
  BOOST_TEST(contains(complaint([&]() { check(pair); }),
                      "modes at the contact of the reduced bodies has 7 x 4"));
  BOOST_TEST(contains(complaint([&]() {
                        StabilityPencil(random_pair({9, 5}, 4, 1),
                                        linear_contact(good.problem,
                                                       good.state,
                                                       at_speed()));
                      }),
                      "must have the same nodes"));
}

BOOST_AUTO_TEST_CASE(nodes_about_to_change_are_counted)
{
  RollingState state   = half_space_state({9, 1}, {4e-4, 0., 0.});
  const auto   options = at_speed();
  const auto   counts  = [&]() {
    return linear_contact(state.problem, state.state, options);
  };
  const LinearContact before = counts();
  BOOST_TEST(before.n_border() == 0u);
  const unsigned int first = before.touching.front();
  const RollingState kept  = state;
  // the gap of an open node almost closed
  state.problem.loads.gap[first - 1] -=
    normal_gap(state.problem, state.state)[first - 1] * (1 - 1e-9);
  BOOST_TEST(counts().n_opening == 1u);
  BOOST_TEST(counts().touching.size() == before.touching.size());
  // a node that sticks almost slips
  state = kept;
  const auto slip =
    tangential_problem(state.problem, state.state).slip(state.state.traction);
  for (std::size_t k = 0; k < before.touching.size(); ++k)
    if (!before.slips[k])
      {
        const unsigned int i            = before.touching[k];
        state.problem.loads.friction[i] = state.state.traction.norm_at(i) /
                                          state.state.pressure[i] * (1 + 1e-6);
        BOOST_TEST(counts().n_slipping == 1u);
        BOOST_TEST(counts().n_slip() == before.n_slip());
        break;
      }
  // one that slips almost sticks
  state = kept;
  for (std::size_t k = 0; k < before.touching.size(); ++k)
    if (before.slips[k])
      {
        state.problem.loads.free_slip = NodalField(9, 1);
        state.problem.loads.free_slip(0, before.touching[k]) =
          -slip(0, before.touching[k]) * (1 - 1e-9);
        BOOST_TEST(counts().n_sticking == 1u);
        BOOST_TEST(counts().n_slip() == before.n_slip());
        break;
      }
}

BOOST_AUTO_TEST_SUITE_END()
