#include <deal.II/lac/vector.h>

#include <boost/test/unit_test.hpp>

#include "complaint.h"
#include "stability_bodies.h"
#include "vibrating_pair.h"

#include <rolling_contact/stability/correction.h>
#include <rolling_contact/stability/rational_fit.h>
#include <rolling_contact/stability/unstable_count.h>

using namespace RollingContact;
using namespace StabilityBodies;

/** Counted and corrected eigenvalues of rolling, beside those of the pencil. */
BOOST_AUTO_TEST_SUITE(stability_checked)

namespace
{
  /**
   * The first modes of a pair, the others in its residual compliance.
   */
  ReducedPair truncated(const ReducedPair &full, const unsigned int n_modes)
  {
    ReducedPair       pair = full;
    const std::size_t n    = full.W_res.rows();
    pair.K_m = pair.C_m = DenseMatrix::Zero(n_modes, n_modes);
    pair.Phi            = DenseMatrix::Zero(n, n_modes);
    for (unsigned int k = 0; k < full.n_modes(); ++k)
      if (k < n_modes)
        {
          pair.K_m(k, k) = full.K_m(k, k);
          pair.C_m(k, k) = full.C_m(k, k);
          for (std::size_t i = 0; i < n; ++i)
            pair.Phi(i, k) = full.Phi(i, k);
        }
      else
        for (std::size_t j = 0; j < n; ++j)
          for (std::size_t i = 0; i < n; ++i)
            pair.W_res(i, j) +=
              full.Phi(i, k) * full.Phi(j, k) / full.K_m(k, k);
    pair.n_wheel_modes = n_modes / 2;
    check(pair);
    return pair;
  }

  BodyResponse response_of(const ReducedPair &pair)
  {
    return [&pair](const auto &s, const auto &forces) {
      std::vector<ComplexVector> u;
      for (std::size_t k = 0; k < s.size(); ++k)
        u.push_back(reduced_response(pair, s[k], forces[k]));
      return u;
    };
  }

  const Grid      patch{7, 5};
  const Creepages sliding{0.02, -0.01, 0.};

  /**
   * The eigenvalues in the part of the plane that a counter looks at.
   */
  int number(const ReducedPair &bodies, const LinearContact &contact)
  {
    int count = 0;
    for (const auto &s : StabilityPencil(bodies, contact).eigenvalues())
      count += s.real() > 0. && s.imag() > 2 * pi * 60. &&
               s.imag() < 2 * pi * 5000. && s.real() < 2 * pi * 5000.;
    return count;
  }

  DenseMatrix grown(const DenseMatrix &M,
                    const unsigned int rows,
                    const unsigned int columns)
  {
    DenseMatrix larger = DenseMatrix::Zero(M.rows() + rows, M.cols() + columns);
    larger.topLeftCorner(M.rows(), M.cols()) = M;
    return larger;
  }

  /**
   * A contact with two unknowns more that swing by themselves.
   */
  LinearContact excited(const LinearContact       &contact,
                        const std::complex<double> s)
  {
    const unsigned int n      = contact.n_unknowns();
    LinearContact      result = contact;
    result.N_u                = grown(contact.N_u, 2, 0);
    result.N_v                = grown(contact.N_v, 2, 0);
    result.N_r                = grown(contact.N_r, 2, 2);
    result.N_s                = grown(contact.N_s, 2, 2);
    result.forces             = grown(contact.forces, 0, 2);
    result.N_s(n, n) = result.N_s(n + 1, n + 1) = 1.;
    result.N_r(n, n) = result.N_r(n + 1, n + 1) = -s.real();
    result.N_r(n, n + 1)                        = s.imag();
    result.N_r(n + 1, n)                        = -s.imag();
    return result;
  }

  const ReducedPair &some_pair()
  {
    static const ReducedPair pair = random_pair({7, 5}, 14, 41, 2e-4, 0.2);
    return pair;
  }
} // namespace

BOOST_AUTO_TEST_CASE(a_rational_fit_finds_poles)
{
  const auto function = [](const std::complex<double> s, const int k) {
    return 3. / (s - std::complex<double>(-0.1, 2.)) +
           static_cast<double>(k) / (s - std::complex<double>(0.4, 5.)) +
           std::exp(0.1 * s);
  };
  ComplexValues points;
  for (int i = 0; i <= 60; ++i)
    points.push_back({0., 1. + 0.1 * i});
  ComplexMatrix values = ComplexMatrix::Zero(points.size(), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (int k = 0; k < 3; ++k)
      values(i, k) = function(points[i], k);
  const RationalFit fit(points, values);
  BOOST_TEST(fit.error() < 1e-10);
  BOOST_TEST(fit.n_support_points() < 12u);
  for (const std::complex<double> s :
       {std::complex<double>(0., 2.03), {0.2, 4.}, {0., 3.}})
    for (int k = 0; k < 3; ++k)
      BOOST_TEST(std::abs(fit(s)[k] - function(s, k)) < 1e-8);
}

/** What many stiff modes with C = tau K take, their compliance takes with the
 * retardation time tau, and without it growths are another. */
BOOST_AUTO_TEST_CASE(a_retarded_compliance_damps_as_the_modes_left_out)
{
  const double tau       = 3e-6;
  ReducedPair  full      = random_pair({7, 5}, 30, 42, 2e-4, 0.2);
  full.retardation       = tau;
  const unsigned int few = 14;
  for (unsigned int k = few; k < full.n_modes(); ++k)
    {
      full.K_m(k, k) *= 100.;
      full.C_m(k, k) = tau * full.K_m(k, k);
      full.Phi.col(k) *= 10.;
    }
  const RollingState state =
    rolling_state({7, 5}, full, 0.5, {0.02, -0.01, 0.});
  const auto  contact       = linear_contact(state.problem,
                                      state.state,
                                      at_speed(FrictionResponse::constant));
  ReducedPair reduced       = truncated(full, few);
  const auto  of_full       = StabilityPencil(full, contact).eigenvalues();
  const auto  largest_error = [&]() {
    const auto found = StabilityPencil(reduced, contact).eigenvalues();
    double     error = 0.;
    for (const auto &s : of_full)
      if (s.imag() > 2 * pi * 60. && s.imag() < 2 * pi * 4000.)
        {
          double nearest = 1e300;
          for (const auto &other : found)
            nearest = std::min(nearest, std::abs(other - s));
          error = std::max(error, nearest);
        }
    return error;
  };
  const double retarded = largest_error();
  reduced.retardation   = 0.;
  const double at_once  = largest_error();
  BOOST_TEST_MESSAGE("error " << retarded << " 1/s, at once " << at_once);
  BOOST_TEST(retarded < 0.1 * at_once);
  BOOST_TEST(at_once > 5.);
}

BOOST_AUTO_TEST_CASE(the_count_is_that_of_the_eigenvalues)
{
  const double low = 60., high = 5000.;
  unsigned int n_unstable = 0, n_right = 0, n_stable = 0;
  for (unsigned int seed = 0; seed < 40; ++seed)
    {
      const Grid  grid{7, seed % 2 ? 5u : 1u};
      ReducedPair pair =
        random_pair(grid, 10 + seed % 7, 100 + seed, 2e-4, 0.2);
      pair.retardation   = 1e-6 * (seed % 3);
      const double mu    = 0.15 + 0.1 * (seed % 6);
      RollingState state = rolling_state(grid,
                                         pair,
                                         mu,
                                         {seed % 4 == 2 ? 4e-4 : 0.02,
                                          grid.n_y > 1 ? -0.01 : 0.,
                                          0.});
      if (seed % 5 == 0)
        {
          state.problem.loads.friction_law =
            make_friction_law("exponential", 0.8, 0.2);
          state.problem.loads.speed = speed;
          state.solve();
          BOOST_TEST(state.converged);
        }
      LinearContactOptions options = at_speed(FrictionResponse::patch_mean);
      options.memory               = 2e-4;
      const auto contact  = linear_contact(state.problem, state.state, options);
      int        expected = 0;
      for (const auto &s : StabilityPencil(pair, contact).eigenvalues())
        expected +=
          s.real() > 0. && s.imag() > 2 * pi * low && s.imag() < 2 * pi * high;
      const UnstableCounter counter(pair, {low, high});
      const auto            result = counter.count(contact);
      n_right += result.count == expected;
      n_unstable += expected;
      n_stable += expected == 0;
      BOOST_TEST(result.count == expected);
      BOOST_TEST(result.resolved);
      BOOST_TEST(result.fitted);
      BOOST_TEST(std::abs(result.turns - std::round(result.turns)) < 1e-6);
      BOOST_TEST(result.largest_step <= 0.8);
      BOOST_TEST(result.n_points < 6000u);
    }
  BOOST_TEST(n_right == 40u);
  BOOST_TEST(n_unstable > 20u);
  BOOST_TEST(n_stable > 5u);
  BOOST_TEST_MESSAGE("unstable: " << n_unstable
                                  << ", states without: " << n_stable);
}

BOOST_AUTO_TEST_CASE(the_count_is_right_in_states_of_bodies_with_meshes)
{
  VibratingPair::Eigenvalues<3> eigen(VibratingPair::unstable_pair, 12e3);
  const ReducedPair            &pair = eigen.reduced;
  const UnstableCounter         counter(pair);
  std::mt19937                  generator(7);
  std::uniform_real_distribution<double> uniform(0., 1.);
  RollingState                           state{eigen.steady.problem, {}};
  unsigned int n_unstable = 0, n_stable = 0, n_sticking = 0;
  for (unsigned int k = 0; k < 40; ++k)
    {
      const double mu        = 0.1 + 0.7 * uniform(generator),
                   direction = 2 * pi * uniform(generator),
                   size      = 0.05 * std::pow(0.02, uniform(generator));
      ContactLoads &loads    = state.problem.loads;
      loads.friction.assign(state.problem.n_nodes(), mu);
      loads.creepages = {size * std::cos(direction),
                         size * std::sin(direction),
                         0.};
      state.solve();
      BOOST_TEST(state.converged);
      const auto contact =
        linear_contact(state.problem, state.state, at_speed());
      int expected = 0;
      for (const auto &s : StabilityPencil(pair, contact).eigenvalues())
        expected += s.real() > 0. && s.imag() > 2 * pi * 60. &&
                    s.imag() < 2 * pi * 5000. && s.real() < 2 * pi * 5000.;
      const auto result = counter.count(contact);
      BOOST_TEST_CONTEXT("state " << k << ", friction " << mu)
      {
        BOOST_TEST(result.count == expected);
        BOOST_TEST(result.resolved);
      }
      n_unstable += expected;
      n_stable += expected == 0;
      n_sticking += contact.n_slip() < contact.touching.size();
    }
  BOOST_TEST_MESSAGE("unstable: " << n_unstable << ", states without "
                                  << n_stable << ", with nodes that stick "
                                  << n_sticking);
  BOOST_TEST(n_unstable > 10u);
  BOOST_TEST(n_stable > 5u);
  BOOST_TEST(n_sticking > 5u);
}

BOOST_AUTO_TEST_CASE(vibrations_without_damping_are_not_counted)
{
  VibratingPair::Eigenvalues<2> discs(
    [](SceneParameters &scene) {
      VibratingPair::vibrating(scene);
      scene.wheel.model.damping = scene.rail.model.damping = {};
      scene.mesh.elements_across_patch                     = 8;
      scene.mesh.growth                                    = 0.8;
      scene.contact.approach                               = 6e-5;
      scene.contact.creepages.x                            = 0.05;
    },
    10e3);
  VibratingPair::Eigenvalues<3> on_pad(
    [](SceneParameters &scene) {
      VibratingPair::unstable_pair(scene);
      scene.wheel.model.damping = scene.rail.model.damping = {};
    },
    12e3);
  const auto check = [](const ReducedPair &pair, const LinearContact &contact) {
    CountOptions options;
    BOOST_TEST(!UnstableCounter(pair, options).count(contact).resolved);
    options.least_growth = 1e-7 * 2 * pi * options.highest_frequency;
    const auto result    = UnstableCounter(pair, options).count(contact);
    int        expected  = 0;
    for (const auto &s : StabilityPencil(pair, contact).eigenvalues())
      expected += s.real() > options.least_growth && s.imag() > 2 * pi * 60. &&
                  s.imag() < 2 * pi * 5000.;
    BOOST_TEST(result.resolved);
    BOOST_TEST(result.count == expected);
    return result.count;
  };
  BOOST_TEST(check(discs.reduced, discs.contact) == 0);
  BOOST_TEST(check(on_pad.reduced, on_pad.contact) > 0);
}

BOOST_AUTO_TEST_CASE(bodies_that_are_unstable_alone_are_counted)
{
  const RollingState state = rolling_state(patch, some_pair(), 0.5, sliding);
  const auto contact = linear_contact(state.problem, state.state, at_speed());
  // a mode with negative damping
  ReducedPair driven = some_pair();
  driven.C_m(5, 5)   = -800.;
  const auto result  = UnstableCounter(driven).count(contact);
  BOOST_TEST(result.n_body_poles == 1u);
  BOOST_TEST(result.count == number(driven, contact));
  BOOST_TEST(result.count > 0);
  BOOST_TEST(UnstableCounter(driven).uses_residues());
  // a body that nothing holds: its modes at rest share one vector
  ReducedPair free = some_pair();
  free.K_m(0, 0) = free.C_m(0, 0) = 0.;
  const UnstableCounter counter(free);
  BOOST_TEST(!counter.uses_residues());
  BOOST_TEST(counter.count(contact).count == number(free, contact));
  BOOST_TEST(counter.count(contact).resolved);
  free.K_m(0, 0) = 1e-18; // or almost
  BOOST_TEST(!UnstableCounter(free).uses_residues());
}

BOOST_AUTO_TEST_CASE(a_contact_that_is_unstable_alone_is_counted)
{
  RollingState state   = rolling_state(patch, some_pair(), 0.5, sliding);
  const auto   contact = linear_contact(state.problem, state.state, at_speed());
  const auto   swings  = excited(contact, {30., 2 * pi * 777.});
  const UnstableCounter counter(some_pair());
  const auto            result = counter.count(swings);
  BOOST_TEST(result.n_contact_poles == 1u);
  BOOST_TEST(result.count == counter.count(contact).count + 1);
  BOOST_TEST(result.count == number(some_pair(), swings));
  // falling friction without a memory
  state.problem.loads.friction_law = make_friction_law("exponential", 0.5, 0.2);
  state.problem.loads.speed        = speed;
  state.solve();
  BOOST_TEST(state.converged);
  int most = 0;
  for (const double V : {1., 10., 100.})
    {
      LinearContactOptions options = at_speed(FrictionResponse::node);
      options.speed                = V;
      const auto falling = linear_contact(state.problem, state.state, options);
      BOOST_TEST(counter.count(falling).count == number(some_pair(), falling));
      most = std::max(most, counter.count(falling).count);
    }
  BOOST_TEST(most > 0);
}

BOOST_AUTO_TEST_CASE(the_full_bodies_correct_reduced_modes)
{
  unsigned int n_modes = 0, n_moved = 0;
  for (unsigned int seed = 0; seed < 12; ++seed)
    {
      ReducedPair full        = random_pair(patch, 40, 900 + seed, 2e-4, 0.15);
      full.retardation        = 1e-6 * (seed % 3);
      const ReducedPair pair  = truncated(full, 26);
      const auto        state = rolling_state(patch, full, 0.6, sliding);
      const auto        contact =
        linear_contact(state.problem, state.state, at_speed());
      const ComplexValues exact = StabilityPencil(full, contact).eigenvalues();
      for (const auto &mode :
           unstable_modes(StabilityPencil(pair, contact), 2500.).vibrations)
        {
          const auto   truth = nearest(exact, mode.s);
          const double off   = std::abs(mode.s - truth);
          BOOST_TEST(mode.residual < 1e-10);

          // the reduced bodies find nothing to correct
          const auto same =
            correct(pair, contact, {mode}, response_of(pair))[0];
          BOOST_TEST(same.n_responses == 1u);
          BOOST_TEST(same.backward_error < 1e-9);
          BOOST_TEST(std::abs(same.s - mode.s) < 1e-8 * std::abs(mode.s));

          CorrectionOptions options;
          options.most_steps = 1;
          const auto once =
            correct(pair, contact, {mode}, response_of(full), options)[0];
          BOOST_TEST(std::abs(once.s - truth) < 0.2 * off);
          BOOST_TEST(std::abs(once.uncertainty - off) < 0.2 * off);
          options.most_steps     = 30;
          options.tolerance      = 1e-11;
          options.damping_margin = 1e-4;
          const auto corrected =
            correct(pair, contact, {mode}, response_of(full), options)[0];
          BOOST_TEST(std::abs(corrected.s - truth) < 1e-8 * std::abs(truth));
          BOOST_TEST(corrected.first_backward_error > 1e-8);
          BOOST_TEST(corrected.backward_error <
                     1e-3 * corrected.first_backward_error);
          BOOST_TEST(corrected.unstable() == (truth.real() > 0.));
          if (corrected.unstable())
            BOOST_TEST(corrected.damping_needed ==
                         truth.real() / std::abs(truth) + 1e-4,
                       boost::test_tools::tolerance(1e-4));
          ++n_modes;
          n_moved += off > 1e-6 * std::abs(truth);
        }
    }
  BOOST_TEST(n_modes > 5u);
  BOOST_TEST(n_moved > 3u);
  BOOST_TEST_MESSAGE(n_modes << " modes, " << n_moved << " moved");
}

BOOST_AUTO_TEST_CASE(growth_below_its_uncertainty_decides_nothing)
{
  CorrectedMode mode;
  mode.s           = {0.5, 6000.};
  mode.uncertainty = 0.4;
  BOOST_TEST(mode.unstable());
  BOOST_TEST(!mode.undecided());
  mode.uncertainty = 0.6;
  BOOST_TEST(!mode.unstable());
  BOOST_TEST(mode.undecided());
  mode.uncertainty = std::nan("");
  BOOST_TEST(!mode.unstable());
  BOOST_TEST(mode.undecided());

  // bodies that have nothing to do with the reduced ones
  const ReducedPair pair  = random_pair(patch, 20, 907, 1e-5, 0.3);
  const auto        state = rolling_state(patch, pair, 0.6, sliding);
  const auto contact = linear_contact(state.problem, state.state, at_speed());
  const auto modes =
    unstable_modes(StabilityPencil(pair, contact), 5000.).vibrations;
  BOOST_TEST_REQUIRE(!modes.empty());
  ReducedPair other = random_pair(patch, 20, 77, 1e-5, 0.3);
  BOOST_TEST(
    correct(pair, contact, {modes[0]}, response_of(other))[0].undecided());
  BOOST_TEST(contains(
    complaint([&]() {
      correct(pair, contact, {modes[0]}, [](const auto &, const auto &) {
        return std::vector<ComplexVector>(1, ComplexVector::Zero(3));
      });
    }),
    "has 3 values; the contact needs 105"));
}

BOOST_AUTO_TEST_SUITE_END()
