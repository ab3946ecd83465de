#include <boost/test/unit_test.hpp>

#include "../references/mass_on_belt.h"
#include "../references/sliding_half_space.h"
#include "../references/two_mass_flutter.h"
#include "complaint.h"
#include "stability_bodies.h"

#include <rolling_contact/stability/threshold.h>

#include <algorithm>
#include <functional>

using namespace RollingContact;
using namespace StabilityBodies;

/** Eigenvalues of bodies and linearised contact, beside closed forms. */
BOOST_AUTO_TEST_SUITE(stability)

namespace
{
  /**
   * A mass of 1 kg per mode on one node that touches between two that do not;
   * @p tangential and @p normal are its modes there, 1 m^2 its area.
   */
  ReducedPair one_node(const DenseMatrix         &stiffness,
                       const DenseMatrix         &damping,
                       const std::vector<double> &tangential,
                       const std::vector<double> &normal,
                       const double               tangential_compliance,
                       const double               normal_compliance)
  {
    ReducedPair pair;
    pair.K_m   = stiffness;
    pair.C_m   = damping;
    pair.Phi   = DenseMatrix::Zero(6, stiffness.rows());
    pair.W_res = DenseMatrix::Zero(6, 6);
    for (unsigned int i = 0; i < 3; ++i)
      {
        for (unsigned int k = 0; k < stiffness.rows(); ++k)
          {
            pair.Phi(i, k)     = tangential[k];
            pair.Phi(3 + i, k) = normal[k];
          }
        pair.W_res(i, i)         = tangential_compliance;
        pair.W_res(3 + i, 3 + i) = normal_compliance;
      }
    check(pair);
    return pair;
  }

  RollingState one_node_state(const ReducedPair                 &pair,
                              const double                       mu,
                              const double                       creepage,
                              const double                       load,
                              std::shared_ptr<const FrictionLaw> law = nullptr)
  {
    RollingState rolling{rolling_problem({3, 1, 1.},
                                         static_compliance(pair),
                                         mu,
                                         {creepage, 0., 0.},
                                         0.),
                         {}};
    rolling.problem.loads.gap          = {1e9, 0., 1e9};
    rolling.problem.loads.normal_load  = load;
    rolling.problem.loads.friction_law = law;
    rolling.problem.loads.speed        = speed;
    rolling.solve();
    BOOST_TEST(rolling.converged);
    return rolling;
  }

  DenseMatrix matrix(const std::vector<std::vector<double>> &rows)
  {
    DenseMatrix M = DenseMatrix::Zero(rows.size(), rows[0].size());
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t j = 0; j < rows[i].size(); ++j)
        M(i, j) = rows[i][j];
    return M;
  }

  /**
   * The eigenvalue of greatest growth that vibrates.
   */
  std::complex<double> leading(const ReducedPair          &pair,
                               const RollingState         &rolling,
                               const LinearContactOptions &options)
  {
    const LinearContact contact =
      linear_contact(rolling.problem, rolling.state, options);
    for (const auto &s : StabilityPencil(pair, contact).eigenvalues())
      if (s.imag() > 0.)
        return s;
    return 0.;
  }

  const References::TwoMassFlutter two_masses{3., 2., 0.4, 1.};

  std::complex<double> flutter(const References::TwoMassFlutter &masses,
                               const double                      mu)
  {
    const ReducedPair pair =
      one_node(matrix({{masses.k11, masses.k12},
                       {masses.k12, masses.k22 - masses.k3}}),
               matrix({{masses.c1, 0.}, {0., masses.c2}}),
               {1., 0.},
               {0., 1.},
               1.,
               1 / masses.k3);
    return leading(pair, one_node_state(pair, mu, 1., 1.), at_speed());
  }

  double zero_between(double                               lower,
                      double                               upper,
                      const std::function<double(double)> &function)
  {
    const bool sign = function(lower) > 0.;
    while (upper - lower > 1e-9)
      {
        const double middle                               = (lower + upper) / 2;
        ((function(middle) > 0.) == sign ? lower : upper) = middle;
      }
    return lower;
  }

  ReducedPair damped_by_mass(ReducedPair pair, const double rate)
  {
    pair.C_m = DenseMatrix::Zero(pair.n_modes(), pair.n_modes());
    for (unsigned int k = 0; k < pair.n_modes(); ++k)
      pair.C_m(k, k) = rate;
    return pair;
  }

  /**
   * Largest relative difference of eigenvalues from the nearest others.
   */
  double difference(const ComplexValues &some, const ComplexValues &others)
  {
    double largest = some.size() == others.size() ? 0. : 1e300;
    for (const auto &s : some)
      {
        double nearest = 1e300;
        for (const auto &other : others)
          nearest = std::min(nearest, std::abs(s - other) / std::abs(s));
        largest = std::max(largest, nearest);
      }
    return largest;
  }
} // namespace

BOOST_AUTO_TEST_CASE(two_masses_flutter)
{
  const double critical = two_masses.critical_friction();
  BOOST_TEST(std::abs(critical - 1.025) < 1e-12);
  for (const double part : {1.01, 1.2, 1.5})
    {
      const auto s     = flutter(two_masses, part * critical),
                 exact = two_masses.undamped_eigenvalue(part * critical);
      BOOST_TEST(std::abs(s - exact) < 1e-9);
    }
  BOOST_TEST(std::abs(flutter(two_masses, 1.5 * critical) -
                      std::complex<double>(0.14259944, 1.58755617)) < 1e-8);
  BOOST_TEST(flutter(two_masses, 0.99 * critical).real() < 1e-9);
  struct
  {
    double c1, c2, critical;
  } const damped[] = {{.02, .02, 1.027500},
                      {.02, 0., 0.4},
                      {.1, .001, 0.425010}};
  for (const auto &[c1, c2, expected] : damped)
    {
      References::TwoMassFlutter masses = two_masses;
      masses.c1                         = c1;
      masses.c2                         = c2;
      BOOST_TEST(std::abs(masses.critical_friction() - expected) < 5e-7);
      const double found = zero_between(0.2, 3., [&](const double mu) {
        return flutter(masses, mu).real();
      });
      BOOST_TEST(std::abs(found - masses.critical_friction()) < 1e-6);
      // the first threshold, as cures are found: from stable and from growing
      for (const double now : {0.2, 3.})
        {
          const double    width = 1e-5;
          const Threshold first = first_threshold(
            flutter(masses, now).real(),
            [&](const double change) {
              return std::optional<double>(
                flutter(masses, now + (now < 1. ? change : -change)).real());
            },
            {0.25, 2.9, width});
          const double at =
            now + (now < 1. ? 1 : -1) * (first.before + first.behind) / 2;
          BOOST_TEST(first.crossed);
          BOOST_TEST(std::abs(at - masses.critical_friction()) < width);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_mass_on_a_belt)
{
  const double                             v_c = 0.2;
  const std::shared_ptr<const FrictionLaw> law =
    make_friction_law("exponential", 0.5, v_c);
  const ReducedPair pair =
    one_node(matrix({{4e4}}), matrix({{20.}}), {1.}, {0.}, 0., 1e-9);
  const auto eigenvalue = [&](const double                belt_speed,
                              const LinearContactOptions &options) {
    return leading(pair,
                   one_node_state(pair, 0.4, belt_speed / speed, 100., law),
                   options);
  };
  const auto             at_once = at_speed(FrictionResponse::node);
  References::MassOnBelt belt{1., 4e4, 20., 100., 0.2, 0.4, 0.2};
  for (const double v : {0.2, 0.3})
    {
      belt.belt_speed     = v;
      const double growth = belt.growth(v_c);
      const auto   s      = eigenvalue(v, at_once);
      BOOST_TEST(std::abs(s.real() - growth) < 1e-8);
      BOOST_TEST(std::abs(std::abs(s) - 200.) < 1e-8);
      // and with a memory: (s^2 + c s + k) (1 + tau s) = N |mu'| s
      LinearContactOptions slow = at_speed(FrictionResponse::patch_mean);
      slow.memory               = 1e-3;
      const auto z              = eigenvalue(v, slow);
      BOOST_TEST(std::abs(z - s) > 0.5);
      BOOST_TEST(std::abs((z * z + 20. * z + 4e4) * (1. + 1e-3 * z) -
                          (2 * growth + 20.) * z) < 1e-6);
    }
  belt.belt_speed = 0.2;
  BOOST_TEST(std::abs(belt.growth(v_c) - 8.393972) < 1e-6);
  BOOST_TEST(std::abs(belt.critical_speed(v_c) - 0.321888) < 1e-6);
  BOOST_TEST(std::abs(zero_between(0.2,
                                   0.5,
                                   [&](const double v) {
                                     return eigenvalue(v, at_once).real();
                                   }) -
                      belt.critical_speed(v_c)) < 1e-8);
  const auto cycle =
    References::MassOnBelt{1., 4e4, 0., 100., 0.1, 0.4, 0.3}.stick_slip_cycle();
  BOOST_TEST(std::abs(cycle.amplitude - 5.59017e-4) < 1e-9);
  BOOST_TEST(std::abs(cycle.stick_time - 5e-3) < 1e-12);
  BOOST_TEST(std::abs(cycle.slip_time - 26.77945e-3) < 1e-8);
}

BOOST_AUTO_TEST_CASE(without_friction_each_mode_decays_by_its_damping)
{
  const double rate = 14.;
  const Grid   grid{7, 3};
  ReducedPair  pair = damped_by_mass(random_pair(grid, 12, 5), rate);
  check(pair);
  const RollingState state = rolling_state(grid, pair, 0., {0., -0.02, 0.});
  const auto contact = linear_contact(state.problem, state.state, at_speed());
  const auto values  = StabilityPencil(pair, contact).eigenvalues();
  BOOST_TEST(values.size() == 12u);
  for (const auto &s : values)
    {
      BOOST_TEST(std::abs(s.real() + rate / 2) < 1e-6);
      BOOST_TEST(s.imag() > 0.);
    }
  // the contact holds the modes together: none stays where it was
  for (unsigned int k = 0; k < 12; ++k)
    for (const auto &s : values)
      BOOST_TEST(std::abs(s.imag() - std::sqrt(pair.K_m(k, k))) > 1e-3);

  // with normal forces only
  const std::size_t N      = grid.n_nodes();
  ReducedPair       smooth = pair;
  smooth.Phi               = DenseMatrix::Zero(N, 12);
  smooth.W_res             = DenseMatrix::Zero(N, N);
  for (std::size_t j = 0; j < N; ++j)
    {
      for (unsigned int k = 0; k < 12; ++k)
        smooth.Phi(j, k) = pair.Phi(2 * N + j, k);
      for (std::size_t i = 0; i < N; ++i)
        smooth.W_res(i, j) = pair.W_res(2 * N + i, 2 * N + j);
    }
  ContactProblem problem = state.problem;
  problem.operators      = ContactOperators(state.problem.operators.positions(),
                                       state.problem.operators.H(),
                                       static_compliance(smooth));
  RollingState frictionless{problem, {}};
  frictionless.solve();
  BOOST_TEST(frictionless.converged);
  const auto normal = linear_contact(problem, frictionless.state, at_speed());
  BOOST_TEST(normal.n_unknowns() == normal.touching.size());
  for (const auto &s : StabilityPencil(smooth, normal).eigenvalues())
    BOOST_TEST(std::abs(s.real() + rate / 2) < 1e-6);
}

BOOST_AUTO_TEST_CASE(the_mirrored_pair_has_the_same_eigenvalues)
{
  const Grid        grid{7, 5};
  const ReducedPair pair     = random_pair(grid, 14, 8);
  ReducedPair       mirrored = pair;
  const std::size_t N        = grid.n_nodes();
  for (unsigned int k = 0; k < 14; ++k)
    for (unsigned int c = 0; c < 3; ++c)
      for (unsigned int j = 0; j < grid.n_y; ++j)
        for (unsigned int i = 0; i < grid.n_x; ++i)
          mirrored.Phi(c * N + j * grid.n_x + i, k) =
            (c == 1 ? -1. : 1.) *
            pair.Phi(c * N + (grid.n_y - 1 - j) * grid.n_x + i, k);
  for (const double creepage : {0.02, 4e-4})
    {
      const auto values_of = [&](const ReducedPair &bodies,
                                 const Creepages   &creepages) {
        const auto state = rolling_state(grid, bodies, 0.5, creepages);
        return StabilityPencil(
                 bodies, linear_contact(state.problem, state.state, at_speed()))
          .eigenvalues();
      };
      const Creepages one{creepage / 3, creepage, 0.4},
        other{creepage / 3, -creepage, -0.4},
        wrong{creepage / 3, creepage, 0.4};
      const auto values = values_of(pair, one);
      BOOST_TEST(values.size() >= 14u);
      BOOST_TEST(difference(values, values_of(mirrored, other)) < 1e-6);
      BOOST_TEST(difference(values, values_of(mirrored, wrong)) > 1e-4);
    }
}

BOOST_AUTO_TEST_CASE(rotation_splits_a_pair_exactly)
{
  const double omega = 2 * pi * 1050., rate = 10. / 0.46;
  for (const double n : {2., 5.})
    {
      ReducedPair pair;
      pair.K_m = matrix({{omega * omega, 0.}, {0., omega * omega}});
      pair.C_m = DenseMatrix::Zero(2, 2);
      pair.Phi = DenseMatrix::Zero(0, 2);
      const double      turning = n * rate, damping = 40.;
      const DenseMatrix S      = matrix({{0., n}, {-n, 0.}});
      ReducedPair       damped = pair;
      damped.C_m               = matrix({{damping, 0.}, {0., damping}});
      // what turns with the material decays as it does at rest
      add_rotation(damped, S, rate);
      const double free = std::sqrt(omega * omega - damping * damping / 4);
      BOOST_TEST(
        difference(StabilityPencil(damped, LinearContact()).eigenvalues(),
                   {{-damping / 2, free + turning},
                    {-damping / 2, free - turning}}) < 1e-12);
      add_rotation(pair, S, rate);
      check(pair);
      const StabilityPencil pencil(pair, LinearContact());
      const auto            values = pencil.eigenvalues();
      BOOST_TEST(values.size() == 2u);
      BOOST_TEST(
        difference(values, {{0., omega + n * rate}, {0., omega - n * rate}}) <
        1e-12);
      const auto mode = pencil.mode(values[0]);
      BOOST_TEST(mode.residual < 1e-12);
      for (const double share : mode.participation())
        BOOST_TEST(std::abs(share - 0.5) < 1e-9);
    }
}

BOOST_AUTO_TEST_CASE(falling_friction_needs_a_memory)
{
  const Grid        grid{9, 5};
  const ReducedPair pair = random_pair(grid, 12, 2);
  const double      mu_s = 0.5, v_c = 0.2;
  RollingState      state = rolling_state(grid, pair, mu_s, {0., -0.02, 0.});
  state.problem.loads.friction_law = make_friction_law("exponential", 0.6, v_c);
  state.problem.loads.speed        = speed;
  state.solve();
  BOOST_TEST(state.converged);
  LinearContactOptions options = at_speed(FrictionResponse::patch_mean);
  const auto contact = linear_contact(state.problem, state.state, options);
  BOOST_TEST(contact.n_slip() == contact.touching.size());

  // tau of the limit: N |mu'| w W_tt w along the sliding, which is that of y
  const std::size_t   N      = grid.n_nodes();
  std::vector<double> weight = nodal_forces(state.problem, state.state);
  weight.erase(weight.begin(), weight.begin() + 2 * N);
  double     load = 0., speed_of_patch = 0., compliance = 0.;
  const auto tangential = tangential_problem(state.problem, state.state);
  const auto slip       = tangential.slip(state.state.traction);
  for (const double force : weight)
    load += force;
  for (std::size_t i = 0; i < N; ++i)
    {
      speed_of_patch += weight[i] / load * slip.norm_at(i) * speed;
      for (std::size_t j = 0; j < N; ++j)
        compliance +=
          weight[i] / load * pair.W_res(N + i, N + j) * weight[j] / load;
    }
  const double slope = mu_s * 0.4 / v_c * std::exp(-speed_of_patch / v_c),
               limit = load * slope * compliance;
  for (const double part : {0.8, 0.9, 1.2, 2.5})
    {
      options.memory   = part * limit;
      const auto modes = unstable_modes(
        StabilityPencil(pair,
                        linear_contact(state.problem, state.state, options)),
        5000.);
      BOOST_TEST(modes.real.size() == (part < 1. ? 1u : 0u));
      for (const auto &mode : modes.real)
        {
          BOOST_TEST(mode.is_real());
          BOOST_TEST(mode.damping_ratio() == -1.);
          BOOST_TEST(mode.growth() == 1 / (limit - options.memory),
                     boost::test_tools::tolerance(0.1));
        }
    }
  // without a memory there are many
  const auto modes = unstable_modes(
    StabilityPencil(pair,
                    linear_contact(state.problem,
                                   state.state,
                                   at_speed(FrictionResponse::node))),
    5000.);
  BOOST_TEST(modes.real.size() > 5u);
}

BOOST_AUTO_TEST_CASE(waves_grow_on_a_sliding_half_space)
{
  using References::growing_sliding_waves;
  struct
  {
    double               mu, nu;
    std::complex<double> c;
  } const waves[] = {{1.2, 0.3, {1.413861, 0.080987}},
                     {1.5, 0.3, {1.414449, 0.175459}},
                     {2., 0.3, {1.420695, 0.298415}},
                     {1.2, 0.45, {1.402646, 0.114040}},
                     {2., 0.45, {1.271784, 0.391861}}};
  for (const auto &[mu, nu, expected] : waves)
    {
      const auto found = growing_sliding_waves(mu, nu);
      BOOST_TEST_REQUIRE(!found.empty());
      BOOST_TEST(std::abs(nearest(found, expected) - expected) < 1e-6);
    }
  for (const double nu : {0., 0.3, 0.45})
    for (const double mu : {0., 0.3, 0.6, 0.9})
      BOOST_TEST(growing_sliding_waves(mu, nu).empty());
  BOOST_TEST(contains(complaint([]() { growing_sliding_waves(0.3, 0.5); }),
                      "Poisson's ratio"));
}

BOOST_AUTO_TEST_SUITE_END()
