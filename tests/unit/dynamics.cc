#include <boost/test/unit_test.hpp>

#include "bar.h"

#include <rolling_contact/base/exceptions.h>

using namespace RollingContact;

BOOST_AUTO_TEST_SUITE(dynamics)

namespace
{
  const double pi = std::acos(-1.);

  /**
   * Numbers without pattern in (-1, 1).
   */
  std::vector<double> scattered(const std::size_t n, const double seed)
  {
    std::vector<double> result(n);
    for (std::size_t i = 0; i < n; ++i)
      result[i] = std::sin(seed + 7.3 * i * i);
    return result;
  }

  double total(const StepEnergy &energy)
  {
    return energy.kinetic + energy.strain;
  }
} // namespace

BOOST_AUTO_TEST_CASE(energy_stays_constant_at_the_midpoint_rule)
{
  for (const bool consistent : {false, true})
    {
      Bar bar;
      bar.consistent       = consistent;
      PlainStepper stepper = bar.stepper({}, 0.02);
      stepper.set_state(scattered(bar.n_unknowns(), 1.),
                        scattered(bar.n_unknowns(), 2.));
      const double initial = total(stepper.energy());
      for (unsigned int step = 0; step < 1000; ++step)
        {
          stepper.begin_step();
          stepper.end_step({0.});
        }
      BOOST_TEST(std::abs(total(stepper.energy()) / initial - 1) < 1e-10);
      BOOST_TEST(stepper.energy().numerical_dissipation == 0.);
    }
}

BOOST_AUTO_TEST_CASE(the_energy_balance_closes)
{
  Bar bar;
  for (const bool consistent : {false, true})
    for (const double theta : {0.5, 0.6, 1.})
      for (const double h : {1e-4, 5e-3, 1.})
        {
          bar.consistent       = consistent;
          PlainStepper stepper = bar.stepper({theta, 2., 1e-3}, h, {0, 50, 99});
          stepper.set_state(scattered(bar.n_unknowns(), 1.),
                            scattered(bar.n_unknowns(), 2.));
          stepper.set_loads(scattered(bar.n_unknowns(), 3.));
          const double scale = total(stepper.energy());
          for (unsigned int step = 0; step < 20; ++step)
            {
              stepper.begin_step();
              stepper.end_step(scattered(3, step));
              const StepEnergy &energy = stepper.energy();
              BOOST_TEST(std::abs(energy.balance_error) < 1e-12 * scale);
              BOOST_TEST(energy.damping > 0.);
              BOOST_TEST(energy.numerical_dissipation >= 0.);
              BOOST_TEST((theta == 0.5) ==
                         (energy.numerical_dissipation == 0.));
            }
        }
}

BOOST_AUTO_TEST_CASE(half_solves_take_the_step_of_a_full_solve)
{
  Bar bar;
  bar.consistent = true;
  const ThetaScheme              scheme{0.7, 2., 1e-3};
  const double                   h = 0.01, theta = scheme.theta;
  const std::vector<std::size_t> contact{80, 0, 31};
  PlainStepper                   stepper = bar.stepper(scheme, h, contact);
  const std::size_t              n       = bar.n_unknowns();
  const auto u = scattered(n, 1.), v = scattered(n, 2.), f = scattered(n, 3.),
             r = scattered(3, 4.);
  stepper.set_state(u, v);
  stepper.set_loads(f);
  stepper.begin_step();
  const auto free_v  = stepper.free_contact_velocity(),
             free_u  = stepper.free_contact_displacement(),
             free_th = stepper.free_contact_theta_velocity();
  stepper.end_step(r);

  // A = M + theta h C + theta^2 h^2 K with C = 2/s M + 1e-3 s K
  const SymmetricSparseMatrix M = bar.mass(), K = bar.stiffness();
  std::vector<unsigned int>   nodes(n);
  std::iota(nodes.begin(), nodes.end(), 0);
  Factorisation A(linear_combination(
                    1 + theta * h * 2., M, theta * h * (1e-3 + theta * h), K),
                  nodes);
  A.factorise();
  std::vector<double> Mv(n), Ku(n), b(n);
  M.multiply(v, Mv);
  K.multiply(u, Ku);
  for (std::size_t i = 0; i < n; ++i)
    b[i] = Mv[i] + theta * h * (f[i] - Ku[i]);
  const auto free = A.solve(b);
  for (std::size_t c = 0; c < 3; ++c)
    b[contact[c]] += theta * h * r[c];
  const auto v_th = A.solve(b);
  for (std::size_t i = 0; i < n; ++i)
    {
      const double v1 = (v_th[i] - (1 - theta) * v[i]) / theta;
      BOOST_TEST(std::abs(stepper.velocities()[i] - v1) < 1e-12);
      BOOST_TEST(std::abs(stepper.displacements()[i] - u[i] - h * v_th[i]) <
                 1e-12);
    }

  const DenseMatrix &W = stepper.system->contact_compliance();
  for (std::size_t c = 0; c < 3; ++c)
    {
      const std::size_t i      = contact[c];
      double            change = 0.;
      for (std::size_t d = 0; d < 3; ++d)
        change += W(c, d) * r[d];
      BOOST_TEST(std::abs(free_th[c] - free[i]) < 1e-12);
      BOOST_TEST(std::abs(free_v[c] + change / h - stepper.velocities()[i]) <
                 1e-12);
      BOOST_TEST(std::abs(free_u[c] + theta * change -
                          stepper.displacements()[i]) < 1e-12);
    }
}

BOOST_AUTO_TEST_CASE(an_abandoned_step_leaves_no_trace)
{
  const Bar    bar;
  PlainStepper halved   = bar.stepper({0.6, 1., 1e-3}, 0.02),
               straight = bar.stepper({0.6, 1., 1e-3}, 0.01);
  for (PlainStepper *stepper : {&halved, &straight})
    stepper->set_state(scattered(bar.n_unknowns(), 1.),
                       scattered(bar.n_unknowns(), 2.));
  halved.begin_step();
  halved.set_time_step(0.01);
  BOOST_CHECK_THROW(halved.end_step({1.}), std::logic_error);
  for (PlainStepper *stepper : {&halved, &straight})
    {
      stepper->begin_step();
      stepper->end_step({1.});
    }
  BOOST_TEST(halved.velocities() == straight.velocities());
  BOOST_TEST(halved.displacements() == straight.displacements());
}

BOOST_AUTO_TEST_CASE(a_stored_state_goes_on_to_the_same_numbers)
{
  const Bar    bar;
  PlainStepper first  = bar.stepper({0.6, 1., 1e-3}, 0.02),
               second = bar.stepper({0.6, 1., 1e-3}, 0.02);
  first.set_state(scattered(bar.n_unknowns(), 1.),
                  scattered(bar.n_unknowns(), 2.));
  for (unsigned int step = 0; step < 10; ++step)
    impact_step(first, -0.1);
  second.set_state(first.displacements(), first.velocities());
  for (unsigned int step = 0; step < 10; ++step)
    {
      BOOST_TEST(impact_step(first, -0.1) == impact_step(second, -0.1));
      BOOST_TEST(first.energy().balance_error == second.energy().balance_error);
    }
  BOOST_TEST(first.velocities() == second.velocities());
}

BOOST_AUTO_TEST_CASE(damping_and_theta_damp_a_mode_as_theory_says)
{
  Bar bar;
  bar.n_elements = 50;
  const double n = bar.n_elements, dx = bar.element_size(),
               omega = 2 / dx * std::sin(pi / 4 / n), h = 0.1;
  const double        zeta = 0.01, W = omega * h;
  std::vector<double> mode(bar.n_unknowns());
  for (std::size_t i = 0; i < mode.size(); ++i)
    mode[i] = std::cos(pi / 2 * i / n);
  for (const double theta : {0.5, 0.505, 0.6})
    {
      PlainStepper stepper = bar.stepper({theta, 0., 0.}, h);
      stepper.set_state(mode, std::vector<double>(mode.size(), 0.));
      const double initial = total(stepper.energy());
      stepper.begin_step();
      stepper.end_step({0.});
      const double factor =
        (1 + std::pow((1 - theta) * W, 2)) / (1 + std::pow(theta * W, 2));
      BOOST_TEST(std::abs(total(stepper.energy()) / initial - factor) < 1e-12);
    }
  // C = 2 zeta omega M, or 2 zeta / omega K: amplitude exp(-zeta omega t)
  for (const ThetaScheme &scheme : {ThetaScheme{0.5, 2 * zeta * omega, 0.},
                                    ThetaScheme{0.5, 0., 2 * zeta / omega}})
    {
      PlainStepper stepper = bar.stepper(scheme, 0.01);
      stepper.set_state(mode, std::vector<double>(mode.size(), 0.));
      const double initial = total(stepper.energy());
      const double periods = 20.;
      const auto   n_steps = std::lround(periods * 2 * pi / omega / 0.01);
      for (unsigned int step = 0; step < n_steps; ++step)
        {
          stepper.begin_step();
          stepper.end_step({0.});
        }
      BOOST_TEST(std::abs(std::log(initial / total(stepper.energy())) /
                            (2 * zeta * omega * n_steps * 0.01) -
                          1) < 1e-3);
    }
}

BOOST_AUTO_TEST_CASE(impact_of_a_clamped_bar)
{
  struct Row
  {
    bool   consistent;
    double theta, error, energy_kept;
  };
  for (const Row &row : {Row{false, 0.5, 8.3e-3, 0.988},
                         Row{true, 0.5, 5.6e-3, 0.991},
                         Row{true, 0.55, 1.6e-2, 0.837},
                         Row{true, 1., 5.2e-2, 0.487}})
    BOOST_TEST_CONTEXT("theta " << row.theta << ", consistent "
                                << row.consistent)
    {
      Bar bar;
      bar.consistent              = row.consistent;
      const double        h       = 0.5 * bar.element_size();
      PlainStepper        stepper = bar.stepper({row.theta, 0., 0.}, h);
      std::vector<double> stretched(bar.n_unknowns());
      for (std::size_t i = 0; i < stretched.size(); ++i)
        stretched[i] = 0.5 * (1 - i * bar.element_size());
      stepper.set_state(stretched, std::vector<double>(stretched.size(), 0.));
      const double initial = total(stepper.energy());
      BOOST_TEST(std::abs(initial - 0.125) < 1e-12);

      const unsigned int n_steps    = std::lround(4 * 3 / h);
      unsigned int       n_switches = 0;
      bool               touching   = false;
      double             squares = 0., deepest = 0., peak = 0., highest = 0.;
      for (unsigned int step = 1; step <= n_steps; ++step)
        {
          const double reaction = impact_step(stepper),
                       u        = stepper.contact_displacement()[0],
                       phase    = std::fmod(step * h, 3.),
                       exact    = std::max(0., std::abs(phase - 1.5) - 0.5) / 2;
          n_switches += (reaction > 0.) != touching;
          touching = reaction > 0.;
          squares += std::pow(u - exact, 2);
          deepest = std::min(deepest, u);
          peak    = std::max(peak, reaction);
          highest = std::max(highest, total(stepper.energy()) / initial);
        }
      const double error = std::sqrt(squares / n_steps),
                   kept  = total(stepper.energy()) / initial;
      BOOST_TEST_MESSAGE("rms " << error << " energy " << kept << " switches "
                                << n_switches << " deepest " << deepest
                                << " peak " << peak);
      BOOST_TEST(n_switches == 8u);
      BOOST_TEST(deepest > -1e-14);
      BOOST_TEST(error < row.error + 0.5e-4);
      BOOST_TEST(kept > row.energy_kept - 5e-4);
      BOOST_TEST(highest < 1 + 1e-12);
    }
}

BOOST_AUTO_TEST_CASE(a_free_bar_bounces_off_a_rigid_wall)
{
  Bar bar;
  bar.n_elements    = 400;
  bar.clamped       = false;
  bar.young_modulus = 210e9;
  bar.density       = 7800.;
  bar.area          = 1e-4;
  const double c = bar.wave_speed(), speed = 10.,
               h       = 0.5 * bar.element_size() / c;
  PlainStepper stepper = bar.stepper({}, h);
  stepper.set_state(std::vector<double>(bar.n_unknowns(), 0.),
                    std::vector<double>(bar.n_unknowns(), -speed));
  const double initial = total(stepper.energy()), wall = -10.5 * h * speed,
               duration = 2 * bar.length / c;
  double first = -1., last = 0., impulse = 0., plateau = 0.;
  for (unsigned int step = 1; step * h < 1.5 * duration; ++step)
    {
      const double reaction = impact_step(stepper, wall);
      impulse += h * reaction;
      if (reaction > 0.)
        {
          last = step * h;
          if (first < 0.)
            first = (step - 1) * h;
          if (last - first > 0.1 * duration && last - first < 0.9 * duration)
            plateau += h * reaction / (0.8 * duration);
        }
    }
  const double mass    = bar.density * bar.area * bar.length,
               rebound = impulse / mass - speed;
  BOOST_TEST_MESSAGE("stress " << plateau / bar.area / (bar.density * c * speed)
                               << " duration " << (last - first) / duration
                               << " rebound " << rebound / speed);
  BOOST_TEST(std::abs(plateau / bar.area / (bar.density * c * speed) - 1) <
             0.01);
  BOOST_TEST(std::abs((last - first) / duration - 1) < 0.01);
  BOOST_TEST(rebound < speed);
  BOOST_TEST(rebound > 0.98 * speed);
  BOOST_TEST(total(stepper.energy()) < initial);
}

BOOST_AUTO_TEST_CASE(what_no_step_can_be_made_of_is_refused)
{
  const Bar bar;
  BOOST_CHECK_THROW(bar.stepper({0.4, 0., 0.}, 0.1), InputError);
  BOOST_CHECK_THROW(bar.stepper({0.5, -1., 0.}, 0.1), InputError);
  BOOST_CHECK_THROW(bar.stepper({}, 0.), InputError);
  PlainStepper stepper = bar.stepper({}, 0.1);
  BOOST_CHECK_THROW(stepper.end_step({0.}), std::logic_error);
  BOOST_CHECK_THROW(stepper.free_contact_velocity(), std::logic_error);
  BOOST_CHECK_THROW(stepper.set_state({1.}, {1.}), std::logic_error);
}

BOOST_AUTO_TEST_CASE(two_states_at_once_are_those_one_by_one)
{
  Bar               bar;
  const ThetaScheme scheme{0.6, 2., 1e-3};
  const auto        make = [&]() { return bar.stepper(scheme, 0.02, {0, 50}); };
  const PlainStepper origin = make();
  PlainStepper       first = origin, second = origin, alone_first = make(),
               alone_second = make();
  std::vector<double> bump(bar.n_unknowns()), still(bump), load(bump);
  for (std::size_t i = 0; i < bump.size(); ++i)
    {
      bump[i] = std::sin(0.1 * i);
      load[i] = 0.01 * std::cos(0.3 * i);
    }
  for (PlainStepper *stepper : {&first, &alone_first})
    stepper->set_state(bump, still);
  for (PlainStepper *stepper : {&second, &alone_second})
    {
      stepper->set_state(still, bump);
      stepper->set_loads(load);
    }
  first.step_with(second);
  for (int step = 0; step < 5; ++step)
    {
      const std::vector<double> r{0.1 * step, -0.2}, q{0.3, 0.05 * step};
      first.begin_twin_steps();
      alone_first.begin_step();
      alone_second.begin_step();
      BOOST_CHECK(first.free_contact_theta_velocity() ==
                  alone_first.free_contact_theta_velocity());
      BOOST_CHECK(second.free_contact_theta_velocity() ==
                  alone_second.free_contact_theta_velocity());
      first.end_twin_steps(r, q);
      alone_first.end_step(r);
      alone_second.end_step(q);
    }
  const auto check_same = [](const PlainStepper &a, const PlainStepper &b) {
    BOOST_CHECK(a.displacements() == b.displacements());
    BOOST_CHECK(a.velocities() == b.velocities());
    BOOST_TEST(a.energy().kinetic == b.energy().kinetic);
    BOOST_TEST(a.energy().strain == b.energy().strain);
    BOOST_TEST(a.energy().contact_work == b.energy().contact_work);
    BOOST_TEST(a.energy().load_work == b.energy().load_work);
    BOOST_TEST(a.energy().damping == b.energy().damping);
    BOOST_TEST(a.energy().balance_error == b.energy().balance_error);
  };
  check_same(first, alone_first);
  check_same(second, alone_second);

  BOOST_CHECK_THROW(first.step_with(alone_first), std::logic_error);
  BOOST_CHECK_THROW(first.step_with(first), std::logic_error);
  BOOST_CHECK_THROW(first.end_twin_steps({0., 0.}, {0., 0.}), std::logic_error);
  BOOST_CHECK_THROW(alone_first.begin_twin_steps(), std::logic_error);
}

BOOST_AUTO_TEST_SUITE_END()
