#include <boost/test/unit_test.hpp>

#include "complaint.h"
#include "stability_bodies.h"

#include <functional>

using namespace RollingContact;
using namespace StabilityBodies;

/** Linearised contact, beside the contact solvers. */
BOOST_AUTO_TEST_SUITE(stability_contact)

namespace
{
  RollingState
  half_space_state(const Grid            &grid,
                   const Creepages       &creepages,
                   const SlipOperatorKind kind = SlipOperatorKind::upwind_2,
                   const int              flow = 1)
  {
    RollingState rolling{
      rolling_problem(
        grid, half_space(grid, 80e9, 0.3), 0.4, creepages, 3.1e-5, kind, flow),
      {}};
    rolling.solve();
    return rolling;
  }

  /**
   * The state after the bodies moved by @p size times a motion and a rate of
   * motion of their own.
   */
  std::vector<double> moved_state(const RollingState        &rolling,
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
    moved.solve();
    BOOST_TEST(moved.converged);
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
        // (N_u W forces + N_r) dx = -N_u motion - N_v velocity
        DenseMatrix M =
          contact.N_u * (rolling.problem.operators.W() * contact.forces);
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
  for (const auto kind :
       {SlipOperatorKind::galerkin, SlipOperatorKind::calibrated})
    BOOST_TEST(contains(wrong([&](auto &state, auto &) {
                          state = half_space_state(grid, {0.02, 0., 0.}, kind);
                        }),
                        "Contact/Slip operator = " + name_of(kind)));
  // the calibrated operator without its edge law is upwind 2
  BOOST_TEST(wrong([&](auto &state, auto &) {
               state                = half_space_state(grid,
                                        {0.02, 0., 0.},
                                        SlipOperatorKind::calibrated);
               state.state.edge_law = false;
               state.state.scheme   = {};
             }).empty());
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
