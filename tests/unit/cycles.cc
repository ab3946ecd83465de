#include <boost/test/unit_test.hpp>

#include <rolling_contact/algebra/cycle_measures.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/time/verdict.h>

#include <cmath>
#include <functional>
#include <random>

using namespace RollingContact;
using namespace RollingContact::Cycles;

/** Sampled motions: do they repeat themselves, and what is a period of them. */
BOOST_AUTO_TEST_SUITE(cycles)

namespace
{
  const double h = 1e-5;

  std::vector<double> sampled(const std::size_t                    n,
                              const std::function<double(double)> &x)
  {
    std::vector<double> values(n);
    for (std::size_t k = 0; k < n; ++k)
      values[k] = x(k * h);
    return values;
  }

  SampledMotion motion(const std::size_t                    n,
                       const std::function<double(double)> &x)
  {
    return {h, {{sampled(n, x), 0, 0.}}};
  }

  double wave(const double f, const double t)
  {
    return std::cos(2 * pi * f * t) + 0.3 * std::sin(4 * pi * f * t) +
           0.1 * std::cos(10 * pi * f * t + 1.);
  }

  /** What sticks for a while and then slips: kinks and a plateau. */
  double stick_slip(const double f, const double t)
  {
    const double phase = f * t - std::floor(f * t);
    return phase < 0.6 ? 0.2 : 0.2 - std::sin(pi * (phase - 0.6) / 0.4);
  }

  Motion kind(const SampledMotion &motion, const double tolerance = 1e-3)
  {
    const Verdict verdict = judge(motion, 0, tolerance);
    BOOST_TEST_MESSAGE(sentence(verdict));
    return verdict.motion;
  }
} // namespace

#define CHECK_MOTION(found, expected) \
  BOOST_TEST(name_of(found) == name_of(expected))

BOOST_AUTO_TEST_CASE(harmonics_of_one_frequency_are_periodic)
{
  for (const double f : {397.3, 1013.7, 1999.1})
    {
      const Verdict verdict =
        judge(motion(20000, [&](double t) { return 5. + wave(f, t); }),
              0,
              1e-3);
      CHECK_MOTION(verdict.motion, Motion::periodic);
      BOOST_TEST(verdict.frequency() == f, boost::test_tools::tolerance(1e-5));
      BOOST_TEST(std::abs(verdict.amplitude.rate) < 1e-3);
    }
}

BOOST_AUTO_TEST_CASE(what_sticks_and_slips_is_periodic)
{
  const Verdict verdict =
    judge(motion(40000, [](double t) { return stick_slip(391.7, t); }),
          0,
          1e-3);
  BOOST_TEST_MESSAGE(sentence(verdict));
  CHECK_MOTION(verdict.motion, Motion::periodic);
  BOOST_TEST(verdict.frequency() == 391.7, boost::test_tools::tolerance(1e-5));
}

BOOST_AUTO_TEST_CASE(a_start_that_differs_is_forgotten_and_what_is_left_out_too)
{
  const auto arrives = [](double t) {
    return wave(1000.3, t) * (1 - std::exp(-t / 2e-3));
  };
  CHECK_MOTION(kind(motion(20000, arrives)), Motion::periodic);
  CHECK_MOTION(kind(motion(2000, arrives)), Motion::changing);
  BOOST_TEST(judge(motion(20000, arrives), 16000, 1e-3).n_judged == 1000u);
  CHECK_MOTION(judge(motion(20000, arrives), 19900, 1e-3).motion,
               Motion::too_short);
}

BOOST_AUTO_TEST_CASE(an_exponential_is_never_periodic)
{
  for (const double growth : {100., 10., 1., 0.1, 0.01})
    for (const double noise : {0., 1e-9})
      {
        std::mt19937                           random(3);
        std::uniform_real_distribution<double> one(-noise, noise + 1e-30);
        const auto                             grows = [&](double t) {
          return wave(991.3, t) * std::exp(growth * t) + one(random);
        };
        const Verdict verdict = judge(motion(30000, grows), 0, 1e-3);
        CHECK_MOTION(verdict.motion, Motion::changing);
        BOOST_TEST(verdict.amplitude.rate == growth,
                   boost::test_tools::tolerance(0.05));
      }
  for (const double decay : {10., 1., 0.1, 0.01})
    CHECK_MOTION(kind(motion(30000,
                             [&](double t) {
                               return wave(991.3, t) * std::exp(-decay * t);
                             })),
                 Motion::changing);
}

BOOST_AUTO_TEST_CASE(a_vibration_that_grows_in_a_cycle_is_no_cycle)
{
  const auto judged = [](const double growth, const double f) {
    return judge(motion(30000,
                        [&](double t) {
                          return wave(990.3, t) +
                                 1e-3 * std::exp(growth * (t - 0.3)) *
                                   std::cos(2 * pi * f * t);
                        }),
                 0,
                 1e-2);
  };
  for (const double growth : {20., 5., -5., -20.})
    {
      const Verdict verdict = judged(growth, 1773.3);
      BOOST_TEST_MESSAGE(sentence(verdict));
      CHECK_MOTION(verdict.motion,
                   growth > 0. ? Motion::changing : Motion::periodic);
      BOOST_TEST(verdict.differences.rate == growth,
                 boost::test_tools::tolerance(0.1));
    }
  // the other one of a pair that rotation has split
  CHECK_MOTION(judged(20., 1009.1).motion, Motion::changing);
  CHECK_MOTION(judged(-20., 1009.1).motion, Motion::periodic);
}

/** Two standard errors of a line through eight levels that overlap by half hold
 * nine tenths of what is estimated, one of them six, four all but a
 * hundredth. */
BOOST_AUTO_TEST_CASE(a_rate_is_within_its_uncertainty)
{
  std::mt19937                     random(11);
  std::normal_distribution<double> normal;
  const unsigned int               n_motions = 400;
  const double                     growth = 0.3, f = 991.3;
  unsigned int                     n_inside = 0;
  for (unsigned int k = 0; k < n_motions; ++k)
    {
      const SampledMotion noisy = motion(1000, [&](double t) {
        return (wave(f, t) + 0.1 * normal(random)) * std::exp(growth * t);
      });
      const auto          trend = amplitude_trend(noisy, {1.}, 1 / (f * h));
      n_inside += std::abs(trend.rate - growth) < trend.uncertainty;
    }
  BOOST_TEST_MESSAGE("inside: " << n_inside << " of " << n_motions);
  BOOST_TEST(n_inside > 0.8 * n_motions);
  BOOST_TEST(n_inside < 0.96 * n_motions);
}

BOOST_AUTO_TEST_CASE(what_dies_away_has_decayed)
{
  const auto dies = [](double t) {
    return wave(1000.3, t) * std::exp(-90 * t);
  };
  CHECK_MOTION(kind(motion(30000, dies)), Motion::decayed);
  CHECK_MOTION(kind(motion(5000, dies)), Motion::changing);
  // a small cycle after a blow is no decay
  CHECK_MOTION(kind(motion(30000,
                           [&](double t) {
                             return 1e-4 * wave(500.3, t) +
                                    std::exp(-500 * t) * wave(1000.3, t);
                           })),
               Motion::periodic);
  // nothing but rounding, and what grows out of it
  SampledMotion rest =
    motion(4000, [](double t) { return 1e-12 * std::cos(1e9 * t); });
  rest.signals[0].floor = 1e-9;
  CHECK_MOTION(kind(rest), Motion::decayed);
  SampledMotion grows    = motion(4000, [](double t) {
    return 1e-12 * std::exp(60 * t) * std::cos(6000 * t);
  });
  grows.signals[0].floor = 1e-9;
  CHECK_MOTION(kind(grows), Motion::changing);
}

BOOST_AUTO_TEST_CASE(two_lines_without_a_common_period_are_stationary)
{
  CHECK_MOTION(kind(motion(40000,
                           [](double t) {
                             return std::cos(2 * pi * 991.3 * t) +
                                    0.5 * std::cos(2 * pi * 1604.1 * t);
                           })),
               Motion::stationary);
  // a second line of a hundredth is enough
  CHECK_MOTION(kind(motion(40000,
                           [](double t) {
                             return std::cos(2 * pi * 991.3 * t) +
                                    0.01 * std::cos(2 * pi * 1604.1 * t);
                           })),
               Motion::stationary);
  // a slow beat, of which neighbouring periods know little
  BOOST_TEST(name_of(kind(motion(40000, [](double t) {
               return std::cos(2 * pi * 991.3 * t) +
                      0.02 * std::cos(2 * pi * 993.6 * t);
             }))) != "periodic");
}

BOOST_AUTO_TEST_CASE(noise_is_not_periodic_but_may_lie_on_a_cycle)
{
  std::mt19937                     random(5);
  std::normal_distribution<double> normal;
  CHECK_MOTION(kind(motion(40000, [&](double) { return normal(random); })),
               Motion::stationary);
  const auto noisy = [&](double t) {
    return wave(997.1, t) + 1e-4 * normal(random);
  };
  CHECK_MOTION(kind(motion(40000, noisy)), Motion::periodic);
  CHECK_MOTION(kind(motion(40000, noisy), 1e-5), Motion::stationary);
}

BOOST_AUTO_TEST_CASE(a_doubled_period_is_found)
{
  const auto doubled = [](double t) {
    return wave(1000.7, t) + 0.01 * std::cos(pi * 1000.7 * t + 0.4);
  };
  const Verdict verdict = judge(motion(40000, doubled), 0, 1e-3);
  CHECK_MOTION(verdict.motion, Motion::periodic);
  BOOST_TEST(verdict.frequency() == 500.35, boost::test_tools::tolerance(1e-5));
  BOOST_TEST(judge(motion(40000, doubled), 0, 0.05).frequency() == 1000.7,
             boost::test_tools::tolerance(1e-4));
}

BOOST_AUTO_TEST_CASE(noise_doubles_no_period)
{
  // by itself one period leaves a hair more than the tolerance, two a hair less
  std::mt19937                     random(5);
  std::normal_distribution<double> normal;
  for (int k = 0; k < 40; ++k)
    {
      const double tolerance = 3.5e-3 + 4e-5 * k;
      random.seed(5);
      const Verdict verdict =
        judge(motion(20000,
                     [&](double t) {
                       return wave(989.1, t) + 7e-3 * normal(random);
                     }),
              0,
              tolerance);
      BOOST_TEST(verdict.frequency() == 989.1,
                 boost::test_tools::tolerance(1e-3));
    }
}

BOOST_AUTO_TEST_CASE(all_signals_count_but_for_what_is_nothing)
{
  SampledMotion both = motion(40000, [](double t) { return wave(1000.7, t); });
  both.signals.push_back(
    {sampled(40000,
             [](double t) { return 1e4 + 50 * std::cos(pi * 1000.7 * t); }),
     1,
     1e-3});
  BOOST_TEST(judge(both, 0, 1e-3).frequency() == 500.35,
             boost::test_tools::tolerance(1e-5));
  // the same in the unit of the first, where it is a millionth
  both.signals[1].kind = 0;
  both.signals[0].values =
    sampled(40000, [](double t) { return 5e8 * wave(1000.7, t); });
  BOOST_TEST(judge(both, 0, 1e-3).frequency() == 1000.7,
             boost::test_tools::tolerance(1e-5));
}

BOOST_AUTO_TEST_CASE(measures_of_whole_periods)
{
  const double       f = 812.3, T = 1 / (f * h);
  const auto         x = sampled(30000, [&](double t) {
    return 3. + 0.5 * std::cos(2 * pi * f * t) +
           0.2 * std::sin(4 * pi * f * t) + 0.05 * std::cos(18 * pi * f * t);
  });
  const WholePeriods whole(T, x.size(), 7500);
  BOOST_TEST(whole.number() == 16u);
  BOOST_TEST(whole.mean(x) == 3., boost::test_tools::tolerance(1e-6));
  BOOST_TEST(whole.rms(x) ==
               std::sqrt((0.5 * 0.5 + 0.2 * 0.2 + 0.05 * 0.05) / 2),
             boost::test_tools::tolerance(1e-4));
  const auto amplitudes = whole.harmonics(x, 10);
  BOOST_TEST(amplitudes.size() == 10u);
  const std::vector<double> expected{
    0.5, 0.2, 0., 0., 0., 0., 0., 0., 0.05, 0.};
  for (std::size_t k = 0; k < 10; ++k)
    BOOST_TEST(std::abs(amplitudes[k] - expected[k]) < 1e-9);
  BOOST_TEST(whole.most(x) - whole.least(x) > 0.99 * 1.0);
  const auto heat = sampled(30000, [&](double t) { return 4. + 17. * t; });
  BOOST_TEST(whole.change(heat) == 17. / f, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(WholePeriods(12., 1000, 1000).harmonics(x, 10).size() == 4u);
}

BOOST_AUTO_TEST_CASE(verdicts_are_due_at_the_same_steps)
{
  std::vector<std::size_t> due;
  for (std::size_t n = 0; n < 10000; ++n)
    if (is_due(n))
      due.push_back(n);
  BOOST_TEST(due[0] == 400u);
  BOOST_TEST(due[1] == 500u);
  for (std::size_t k = 1; k < due.size(); ++k)
    BOOST_TEST(due[k] - due[k - 1] ==
               std::max<std::size_t>(100, due[k - 1] / 32));
}

BOOST_AUTO_TEST_SUITE_END()
