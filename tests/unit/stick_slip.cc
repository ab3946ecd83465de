#include <boost/test/unit_test.hpp>

#include "../references/mass_on_belt.h"
#include "reduced_run.h"

#include <rolling_contact/algebra/cycle_measures.h>
#include <rolling_contact/time/patch_friction.h>
#include <rolling_contact/time/verdict.h>

using namespace RollingContact;
using namespace StabilityBodies;

/** A mass that a belt drags, in time. */
BOOST_AUTO_TEST_SUITE(stick_slip)

namespace
{
  /** A mass on a spring that a belt drags: one node that touches. */
  struct Belt
  {
    Belt(const References::MassOnBelt             &belt,
         const double                              mu,
         const double                              h,
         const std::shared_ptr<const FrictionLaw> &law   = nullptr,
         const double                              delay = 0.)
      : pair(pair_of(belt))
      , run(pair, state(belt, mu, law), h, pair, false, delay)
      , centre(run.motion.state().eta[0])
    {}

    static ReducedPair pair_of(const References::MassOnBelt &belt)
    {
      ReducedPair pair;
      pair.K_m = pair.C_m = DenseMatrix::Zero(1, 1);
      pair.K_m(0, 0)      = belt.stiffness / belt.mass;
      pair.C_m(0, 0)      = belt.damping / belt.mass;
      pair.Phi            = DenseMatrix::Zero(6, 1);
      pair.W_res          = DenseMatrix::Zero(6, 6);
      for (unsigned int i = 0; i < 3; ++i)
        {
          pair.Phi(i, 0)           = 1 / std::sqrt(belt.mass);
          pair.W_res(i, i)         = 1e-11;
          pair.W_res(3 + i, 3 + i) = 1e-9;
        }
      return pair;
    }

    RollingState state(const References::MassOnBelt             &belt,
                       const double                              mu,
                       const std::shared_ptr<const FrictionLaw> &law) const
    {
      RollingState rolling{rolling_problem({3, 1, 1.},
                                           static_compliance(pair),
                                           mu,
                                           {belt.belt_speed / speed, 0., 0.},
                                           0.),
                           {}};
      rolling.problem.loads.gap          = {1e9, 0., 1e9};
      rolling.problem.loads.normal_load  = belt.load;
      rolling.problem.loads.friction_law = law;
      rolling.problem.loads.speed        = speed;
      rolling.solve();
      BOOST_TEST(rolling.converged);
      return rolling;
    }

    /** Move the mass by this and let it go. Units: m. */
    void pull(const double distance)
    {
      ReducedState state = run.motion.state();
      state.eta[0] += distance;
      run.motion.set_state(state);
    }

    bool slides() const
    {
      return std::abs(run.state.traction(0, 1)) >=
             run.problem.loads.friction[1] * run.state.pressure[1] * (1 - 1e-9);
    }

    ReducedPair pair;
    Run         run;
    double      centre;
  };
} // namespace

BOOST_AUTO_TEST_CASE(a_mass_on_a_belt_sticks_and_slips)
{
  References::MassOnBelt belt{1., 4e4, 0., 100., 0.1, 0.4, 0.3};
  const auto             cycle = belt.stick_slip_cycle();
  const double           h     = 5e-6;
  Belt                   mass(belt, belt.kinetic_friction, h);
  mass.pull(2 * cycle.amplitude);
  std::vector<double> slips;
  double              least = 0., largest = 0.;
  bool                slid = true;
  while (slips.size() < 5)
    {
      mass.run.problem.loads.friction.assign(3,
                                             slid ? belt.kinetic_friction
                                                  : belt.static_friction);
      mass.run.step();
      if (mass.slides() && !slid)
        slips.push_back(mass.run.time);
      slid            = mass.slides();
      const double at = mass.run.motion.state().eta[0];
      if (slips.size() == 1)
        least = largest = at;
      least   = std::min(least, at);
      largest = std::max(largest, at);
      BOOST_REQUIRE(mass.run.time < 1.);
    }
  const double period = (slips.back() - slips.front()) / 4;
  BOOST_TEST(mass.run.converged);
  BOOST_TEST_MESSAGE("belt " << 1 / period << " Hz, " << (largest - least) / 2);
  BOOST_TEST(period == cycle.stick_time + cycle.slip_time,
             boost::test_tools::tolerance(1e-3));
  BOOST_TEST(1 / period == 31.466875, boost::test_tools::tolerance(1e-3));
  BOOST_TEST((largest - least) / 2 == cycle.amplitude,
             boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(a_mass_on_a_belt_with_falling_friction_has_its_limit_cycle)
{
  const double           v_c = 0.2;
  References::MassOnBelt belt{1., 4e4, 20., 100., 0.2, 0.4, 0.2};
  const double           h = 2e-5;
  Belt                   mass(belt,
            belt.static_friction,
            h,
            make_friction_law("exponential", 0.5, v_c));
  mass.pull(1.1e-3);
  std::vector<double> turns; // at the far side
  double              least = 0., largest = 0., before = 0.;
  while (turns.size() < 12)
    {
      mass.run.step();
      const double rate = mass.run.motion.state().rate[0],
                   at   = mass.run.motion.state().eta[0];
      if (before > 0. && rate <= 0.)
        turns.push_back(mass.run.time - h * rate / (rate - before));
      before = rate;
      if (turns.size() < 8)
        least = largest = at;
      least   = std::min(least, at);
      largest = std::max(largest, at);
      BOOST_REQUIRE(mass.run.time < 2.);
    }
  const double f = 4 / (turns[11] - turns[7]);
  BOOST_TEST(mass.run.converged);
  BOOST_TEST_MESSAGE("belt " << f << " Hz, " << (largest - least) / 2);
  BOOST_TEST(f == 31.14155, boost::test_tools::tolerance(1e-3));
  BOOST_TEST((largest - least) / 2 == 1.170249e-3,
             boost::test_tools::tolerance(2e-3));
}

BOOST_AUTO_TEST_CASE(the_limit_cycle_is_found_and_measured)
{
  const double                 h = 1e-4;
  const References::MassOnBelt belt{1., 4e4, 20., 100., 0.2, 0.4, 0.2};
  Belt                         mass(belt,
            belt.static_friction,
            h,
            make_friction_law("exponential", 0.5, 0.2));
  mass.pull(1.1e-3);
  Cycles::SampledMotion motion{h, {{{}, 0, 0.}, {{}, 1, 0.}}};
  auto &place = motion.signals[0].values, &velocity = motion.signals[1].values;
  std::vector<double> supplied, damping;
  Cycles::Verdict     verdict;
  while (!verdict.is_final())
    {
      const StepEnergy  &energy = mass.run.step();
      const ReducedState state  = mass.run.motion.state();
      place.push_back(state.eta[0]);
      velocity.push_back(state.rate[0]);
      const auto before = [](const auto &sums) {
        return sums.empty() ? 0. : sums.back();
      };
      supplied.push_back(before(supplied) + energy.contact_work +
                         energy.load_work);
      damping.push_back(before(damping) + energy.damping);
      if (Cycles::is_due(place.size()))
        verdict = Cycles::judge(motion, 0, 1e-3);
      BOOST_REQUIRE(mass.run.time < 6.);
    }
  BOOST_TEST_MESSAGE(mass.run.time << " s: " << Cycles::sentence(verdict));
  BOOST_TEST(Cycles::name_of(verdict.motion) == "periodic");
  BOOST_TEST(verdict.frequency() == 31.14155,
             boost::test_tools::tolerance(5e-4));
  const Cycles::WholePeriods whole(verdict.period.length,
                                   place.size(),
                                   verdict.n_judged);
  BOOST_TEST((whole.most(place) - whole.least(place)) / 2 == 1.170249e-3,
             boost::test_tools::tolerance(1e-3));
  // a cycle gives back what it takes: c times the mean square velocity
  const double period = verdict.period.length * h,
               lost   = belt.damping * period *
                      (std::pow(whole.rms(velocity), 2) +
                       std::pow(whole.mean(velocity), 2));
  BOOST_TEST(whole.change(damping) == lost, boost::test_tools::tolerance(1e-3));
  BOOST_TEST(whole.change(supplied) == lost,
             boost::test_tools::tolerance(2e-3));
}

BOOST_AUTO_TEST_CASE(a_memory_of_friction_changes_the_growth_as_it_should)
{
  // (s^2 + c s + k) (1 + tau s) = N |mu'| s about steady sliding
  const double                 v_c = 0.2, tau = 1e-3;
  const References::MassOnBelt belt{1., 4e4, 20., 100., 0.2, 0.4, 0.2};
  const double                 slope = 2 * belt.growth(v_c) + belt.damping;
  std::complex<double>         s(belt.growth(v_c), 200.);
  for (unsigned int k = 0; k < 30; ++k) // Newton's method
    s -=
      ((s * s + 20. * s + 4e4) * (1. + tau * s) - slope * s) /
      ((2. * s + 20.) * (1. + tau * s) + tau * (s * s + 20. * s + 4e4) - slope);
  const double h = 5e-5;
  Belt         mass(belt,
            belt.static_friction,
            h,
            make_friction_law("exponential", 0.5, v_c),
            tau);
  mass.pull(1e-6);
  const unsigned int period = std::lround(2 * pi / (h * s.imag()));
  double             sums[2]{};
  for (unsigned int k = 0; k < 14 * period; ++k)
    {
      mass.run.step();
      const ReducedState &state = mass.run.motion.state();
      const double        a     = std::log(
        std::hypot(200. * (state.eta[0] - mass.centre), state.rate[0]));
      sums[0] += k >= 2 * period && k < 4 * period ? a : 0.;
      sums[1] += k >= 12 * period ? a : 0.;
    }
  const double growth = (sums[1] - sums[0]) / (2 * period) / (10 * period * h);
  BOOST_TEST(mass.run.converged);
  BOOST_TEST(std::abs(s.real() - belt.growth(v_c)) > 0.5);
  BOOST_TEST(growth == s.real(), boost::test_tools::tolerance(0.01));
}

BOOST_AUTO_TEST_SUITE_END()
