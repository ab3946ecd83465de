#include <boost/test/unit_test.hpp>

#include "complaint.h"
#include "reduced_run.h"

#include <rolling_contact/vibration/excitation.h>

using namespace RollingContact;
using namespace StabilityBodies;

/** Bodies by their modes in time, with contact laws in the middle of a step. */
BOOST_AUTO_TEST_SUITE(reduced_motion)

namespace
{
  double stored(const StepEnergy &energy)
  {
    return energy.kinetic + energy.strain;
  }

  const Grid grid_3d{5, 4, 1e-3};

  /** Full sliding, all of it lateral. */
  const Creepages sideways{0., 0.02, 0.};
} // namespace

BOOST_AUTO_TEST_CASE(modes_without_damping_keep_their_energy)
{
  const ReducedPair pair = random_pair(grid_3d, 20, 3, 0.);
  ReducedMotion     motion(pair);
  ReducedState      state = motion.state();
  for (std::size_t k = 0; k < 20; ++k)
    {
      state.eta[k]  = 1e-6 * std::cos(1. * k);
      state.rate[k] = 1e-2 * std::sin(2. * k);
    }
  motion.set_state(state);
  motion.set_time_step(1e-5);
  const double              start = stored(motion.energy());
  const std::vector<double> none(state.forces.size(), 0.);
  double                    moved = 0.;
  for (unsigned int k = 0; k < 2000; ++k)
    {
      motion.begin_step();
      motion.end_step(none);
      BOOST_REQUIRE_SMALL(stored(motion.energy()) / start - 1, 1e-11);
      moved = std::max(moved, std::abs(motion.state().eta[3] - state.eta[3]));
    }
  BOOST_TEST(moved > 1e-6);
}

BOOST_AUTO_TEST_CASE(energy_that_forces_supply_is_found_again)
{
  ReducedPair pair = random_pair(grid_3d, 20, 4, 1e-2);
  pair.retardation = 2e-6;
  DenseMatrix S    = DenseMatrix::Zero(20, 20);
  for (unsigned int k = 0; k + 1 < 20; k += 2)
    {
      S(k, k + 1) = 3.;
      S(k + 1, k) = -3.;
    }
  add_rotation(pair, S, 50.);
  ReducedMotion     motion(pair);
  const std::size_t n        = pair.W_res.rows();
  double            supplied = 0., error = 0., numerical = 0.;
  motion.set_time_step(4e-6);
  for (unsigned int k = 0; k < 3000; ++k)
    {
      if (k == 1000)
        motion.set_time_step(2e-6);
      if (k == 2000)
        motion.set_time_step(4e-6);
      std::vector<double> forces(n);
      for (std::size_t i = 0; i < n; ++i)
        forces[i] = 100 * std::sin(0.02 * k + i);
      motion.begin_step(k != 1500);
      const StepEnergy &energy = motion.end_step(forces);
      supplied += std::abs(energy.contact_work);
      error += std::abs(energy.balance_error);
      if (k > 10 && k < 1000) // after the jump from no force
        {
          BOOST_TEST(energy.numerical_dissipation >= 0.);
          numerical += energy.numerical_dissipation;
        }
    }
  BOOST_TEST(supplied > 0.);
  BOOST_TEST(error < 1e-10 * supplied);
  BOOST_TEST(numerical < 1e-4 * supplied);
}

BOOST_AUTO_TEST_CASE(given_forces_move_the_contact_with_second_order)
{
  ReducedPair       pair = random_pair(grid_3d, 12, 5);
  const std::size_t n    = pair.W_res.rows();
  pair.retardation       = 2e-6;
  // the velocity halfway through the last step, of forces that are smooth
  const auto velocity = [&](const unsigned int n_steps) {
    ReducedMotion motion(pair);
    const double  h = 1e-3 / (n_steps - 0.5);
    motion.set_time_step(h);
    for (unsigned int k = 0; k < n_steps; ++k)
      {
        const double        t = (k + 0.5) * h;
        std::vector<double> forces(n);
        for (std::size_t i = 0; i < n; ++i)
          forces[i] = (1 + 0.1 * i) * std::pow(std::sin(2e3 * t), 4);
        motion.begin_step();
        motion.end_step(forces);
      }
    return motion.contact_velocity();
  };
  const auto finest = velocity(1600);
  double     errors[2];
  for (unsigned int k = 0; k < 2; ++k)
    {
      std::vector<double> v = velocity(100 << k);
      for (std::size_t i = 0; i < n; ++i)
        v[i] -= finest[i];
      errors[k] = norm(v) / norm(finest);
    }
  BOOST_TEST(errors[1] < 0.01);
  BOOST_TEST(std::log2(errors[0] / errors[1]) > 1.9);
  BOOST_TEST(std::log2(errors[0] / errors[1]) < 2.2);
}

/** A force that swings moves what the modes leave out by W_res f / (1 + i omega
 * tau), in steps that are long or short beside tau, and the work that it does
 * in a period is what is lost. */
BOOST_AUTO_TEST_CASE(the_residual_compliance_is_retarded)
{
  for (const double tau : {2e-7, 2e-6, 2e-5})
    {
      ReducedPair pair    = random_pair(grid_3d, 4, 8);
      pair.retardation    = tau;
      const std::size_t n = pair.W_res.rows();
      pair.Phi            = DenseMatrix::Zero(n, 4);
      const double omega = 2 * pi * 2000., period = 2 * pi / omega;
      const std::complex<double> answer =
        1. / (1. + std::complex<double>(0., omega * tau));
      double errors[2], losses[2];
      for (unsigned int k = 0; k < 2; ++k)
        {
          ReducedMotion      motion(pair);
          const unsigned int n_steps = 200 << k;
          const double       h       = period / n_steps;
          motion.set_time_step(h);
          const std::vector<double> unit(n, 1.), W_unit = pair.W_res * unit;
          double                    lost = 0., worst = 0.;
          for (unsigned int step = 0; step < 4 * n_steps; ++step)
            {
              const double        t = (step + 0.5) * h;
              std::vector<double> forces(n, std::cos(omega * t));
              motion.begin_step();
              const std::vector<double> u = sum(motion.compliance() * forces,
                                                1.,
                                                motion.free_displacement());
              const StepEnergy         &energy = motion.end_step(forces);
              if (step < 3 * n_steps) // until it swings evenly
                continue;
              lost += energy.damping + energy.numerical_dissipation;
              const double expected =
                (answer * std::polar(1., omega * t)).real();
              worst = std::max(worst, std::abs(u[0] / W_unit[0] - expected));
            }
          errors[k] = worst;
          losses[k] = lost / (-pi * answer.imag() * dot(unit, W_unit)) - 1.;
        }
      BOOST_TEST(errors[1] < 1e-3);
      BOOST_TEST(errors[0] / errors[1] > 3.5);
      BOOST_TEST(std::abs(losses[1]) < 5e-3);
    }
}

/** What the modes leave out answers at once: under forces that rise evenly its
 * velocity is W_res dF/dt, whatever the lengths of the steps. */
BOOST_AUTO_TEST_CASE(steps_of_any_length_know_the_rate_of_a_force)
{
  ReducedPair       pair = random_pair(grid_3d, 4, 8);
  const std::size_t n    = pair.W_res.rows();
  pair.Phi               = DenseMatrix::Zero(n, 4);
  std::vector<double> rate(n);
  for (std::size_t i = 0; i < n; ++i)
    rate[i] = 1e5 * std::sin(2. * i);
  const std::vector<double> expected = pair.W_res * rate;
  ReducedMotion             motion(pair);
  double                    time = 0.;
  unsigned int              k    = 0;
  for (const double h : {4e-6, 4e-6, 2e-6, 1e-6, 3e-6, 3e-6, 8e-6})
    {
      motion.set_time_step(h);
      std::vector<double> forces(n), error(n);
      for (std::size_t i = 0; i < n; ++i)
        forces[i] = 100. + rate[i] * (time + h / 2);
      motion.begin_step();
      motion.end_step(forces);
      time += h;
      for (std::size_t i = 0; i < n; ++i)
        error[i] = motion.contact_velocity()[i] - expected[i];
      if (++k > 2)
        BOOST_TEST(norm(error) < 1e-9 * norm(expected));
    }
}

BOOST_AUTO_TEST_CASE(a_steady_state_stays)
{
  const ReducedPair pair = random_pair(grid_3d, 20, 6, 1e-2);
  Run        run(pair, rolling_state(grid_3d, pair, 0.4, sideways), 4e-6);
  const auto start = nodal_forces(run.problem, run.state);
  for (unsigned int k = 0; k < 50; ++k)
    run.step();
  auto change = nodal_forces(run.problem, run.state);
  for (std::size_t i = 0; i < change.size(); ++i)
    change[i] -= start[i];
  BOOST_TEST(run.converged);
  BOOST_TEST(norm(change) < 1e-8 * norm(start));
}

namespace
{
  /** Bodies in rolling contact of which a vibration grows. */
  struct Squealing
  {
    ReducedPair   pair;    ///< turns
    ReducedPair   resting; ///< of which the steady state is
    RollingState  rolling;
    LinearContact contact;
    StabilityMode mode;
  };

  Squealing squealing(const unsigned int                       seed,
                      const double                             rotation = 0.,
                      const std::shared_ptr<const FrictionLaw> law = nullptr)
  {
    Squealing s;
    s.resting             = random_pair(grid_3d, 10, seed, 2e-4, 0.2);
    s.resting.retardation = 1e-6 * (seed % 2);
    s.rolling             = rolling_state(grid_3d, s.resting, 0.5, sideways);
    if (law)
      {
        s.rolling.problem.loads.friction_law = law;
        s.rolling.problem.loads.speed        = speed;
        s.rolling.solve();
        BOOST_TEST(s.rolling.converged);
      }
    s.contact     = linear_contact(s.rolling.problem,
                               s.rolling.state,
                               at_speed(law ? FrictionResponse::patch_mean
                                            : FrictionResponse::constant));
    s.pair        = s.resting;
    DenseMatrix S = DenseMatrix::Zero(10, 10);
    for (unsigned int k = 0; k + 1 < 10; k += 2)
      {
        S(k, k + 1) = 2.;
        S(k + 1, k) = -2.;
      }
    add_rotation(s.pair, S, rotation);
    const StabilityPencil pencil(s.pair, s.contact);
    s.mode = pencil.mode(vibration_near(pencil.eigenvalues(), 500., "x"));
    return s;
  }

  /** Of the orbit about the start, by the mode with the largest part in it. */
  double amplitude(const Squealing    &s,
                   const ReducedState &start,
                   const ReducedState &now)
  {
    Eigen::Index j = 0;
    s.mode.modal.cwiseAbs().maxCoeff(&j);
    return std::hypot(s.mode.s.imag() * (now.eta[j] - start.eta[j]),
                      now.rate[j]);
  }

  /** A run that begins in the vibration that grows, which starts with this
   * velocity of the contact. */
  Run excited(const Squealing &s, const double h, const double velocity)
  {
    const bool falls = s.rolling.problem.loads.friction_law != nullptr;
    Run        run(
      s.pair, s.rolling, h, s.resting, true, falls ? at_speed().memory : 0.);
    ReducedState     state = run.motion.state();
    const Excitation vibration(s.pair, s.contact, s.mode, velocity);
    vibration.add_to(state, h);
    run.motion.set_state(state);
    if (!falls)
      return run;
    const double t = -h / 2, dt = 1e-3 * h;
    run.friction->disturb(
      vibration.friction(t),
      (vibration.friction(t + dt) - vibration.friction(t - dt)) / (2 * dt));
    return run;
  }

  /** Growth over ten periods that it takes, as it is and in time. */
  void check_growth(const Squealing &s, const double h)
  {
    Run                run = excited(s, h, 1e-4);
    const ReducedState start =
      Run(s.pair, s.rolling, h, s.resting).motion.state();
    // over whole periods, so that the shape of the orbit drops out
    const unsigned int period = std::lround(1 / (h * s.mode.frequency()));
    double             first = 0., last = 0.;
    for (unsigned int k = 0; k < 12 * period; ++k)
      {
        run.step();
        const double a = std::log(amplitude(s, start, run.motion.state()));
        first += k < 2 * period ? a / (2 * period) : 0.;
        last += k >= 10 * period ? a / (2 * period) : 0.;
      }
    const double growth = (last - first) / (10 * period * h);
    BOOST_TEST(run.converged);
    BOOST_TEST_MESSAGE(s.mode.frequency()
                       << " Hz: " << growth << " of " << s.mode.growth()
                       << " 1/s, " << run.n_solutions / (12. * period)
                       << " solutions a step");
    BOOST_TEST(growth == s.mode.growth(), boost::test_tools::tolerance(0.01));
  }
} // namespace

BOOST_AUTO_TEST_CASE(growth_in_time_is_that_of_the_eigenvalue)
{
  for (const auto &[seed, rotation] :
       {std::pair(21, 0.), {37, 0.}, {21, 30.}, {37, 100.}})
    {
      const Squealing s = squealing(seed, rotation);
      check_growth(s, 1 / (100 * s.mode.frequency()));
    }
}

BOOST_AUTO_TEST_CASE(friction_that_falls_with_a_memory_grows_as_its_eigenvalue)
{
  for (const unsigned int seed : {37, 28})
    {
      const Squealing s =
        squealing(seed, 0., make_friction_law("exponential", 0.7, 0.2));
      check_growth(s, std::min(6e-6, 1 / (100 * s.mode.frequency())));
    }
}

BOOST_AUTO_TEST_CASE(an_excited_vibration_has_the_velocity_asked_for)
{
  const Squealing s = squealing(21);
  const double    h = 1e-6, period = 1 / s.mode.frequency();
  Run             run = excited(s, h, 1e-4);
  run.step();
  double largest = 0.;
  for (const unsigned int node : s.contact.touching)
    for (unsigned int c = 0; c < 3; ++c)
      largest = std::max(
        largest,
        std::abs(run.motion.contact_velocity()[c * s.contact.n_nodes + node]));
  BOOST_TEST(largest == 1e-4, boost::test_tools::tolerance(1e-3));
  BOOST_TEST(h < 2e-3 * period);
}

BOOST_AUTO_TEST_CASE(contact_in_time_is_of_second_order)
{
  const Squealing s = squealing(37);
  // forces in the middle of the last step of a vibration that is not small
  const auto forces = [&](const unsigned int n_steps) {
    const double h   = 1e-3 / (n_steps - 0.5);
    Run          run = excited(s, h, 0.02);
    for (unsigned int k = 0; k < n_steps; ++k)
      run.step();
    BOOST_TEST(run.converged);
    return nodal_forces(run.problem, run.state);
  };
  const auto finest = forces(1600);
  double     errors[2];
  for (unsigned int k = 0; k < 2; ++k)
    {
      std::vector<double> change = forces(100 << k);
      for (std::size_t i = 0; i < change.size(); ++i)
        change[i] -= finest[i];
      errors[k] = norm(change);
    }
  auto       moved = finest;
  const auto start = nodal_forces(s.rolling.problem, s.rolling.state);
  for (std::size_t i = 0; i < moved.size(); ++i)
    moved[i] -= start[i];
  BOOST_TEST_MESSAGE("order " << std::log2(errors[0] / errors[1]) << ", error "
                              << errors[1] / norm(moved));
  BOOST_TEST(errors[1] < 0.02 * norm(moved));
  BOOST_TEST(std::log2(errors[0] / errors[1]) > 1.8);
  BOOST_TEST(std::log2(errors[0] / errors[1]) < 2.3);
}

BOOST_AUTO_TEST_CASE(a_state_goes_on_to_the_same_digits)
{
  const Squealing s   = squealing(21);
  Run             run = excited(s, 4e-6, 0.1);
  for (unsigned int k = 0; k < 20; ++k)
    run.step();
  run.set_time_step(2e-6);
  run.step();
  Run other(s.pair, s.rolling, 2e-6, s.resting);
  other.motion.set_state(run.motion.state());
  other.state = run.state;
  for (unsigned int k = 0; k < 20; ++k)
    {
      run.step();
      other.step();
    }
  BOOST_TEST(run.motion.state().eta == other.motion.state().eta);
  BOOST_TEST(run.motion.state().forces == other.motion.state().forces);
  BOOST_TEST(contains(complaint([&]() {
                        ReducedState wrong = run.motion.state();
                        wrong.eta.pop_back();
                        other.motion.set_state(wrong);
                      }),
                      "9 modes"));
  BOOST_TEST(contains(complaint([&]() { other.motion.set_time_step(-1e-6); }),
                      "must be above 0"));
}

BOOST_AUTO_TEST_SUITE_END()
