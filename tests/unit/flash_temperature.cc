#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/bessel.hpp>
#include <boost/test/unit_test.hpp>

#include "scene_run.h"
#include "time_run.h"

#include <rolling_contact/pair/friction_heat.h>
#include <rolling_contact/references/moving_heat_source.h>
#include <rolling_contact/results/error_bounds.h>
#include <rolling_contact/scene/hot_friction.h>

#include <algorithm>
#include <cmath>

using namespace RollingContact;

/** Heat of friction at the surface. */
BOOST_AUTO_TEST_SUITE(flash_temperatures)

namespace
{
  const double pi = std::acos(-1.), conductivity = 50., diffusivity = 1.4e-5;

  /** The flux 1e6 (1 - |x|/l)^2 on steps of l/40, l = 2 mm. */
  struct Source
  {
    Source()
    {
      for (int i = -60; i <= 80; ++i)
        {
          x.push_back(2e-3 * i / 40);
          flux.push_back(
            std::abs(i) <= 40 ? 1e6 * std::pow(1 - std::abs(i) / 40., 2) : 0.);
        }
    }

    std::vector<double> x, flux;
  };
} // namespace

BOOST_AUTO_TEST_CASE(jaegers_integral_by_quadrature)
{
  const Source                               source;
  boost::math::quadrature::tanh_sinh<double> quadrature;
  for (const double V : {0.002, 0.05, 1., -1.})
    {
      const auto rise = References::moving_heat_source(
        source.x, source.flux, V, conductivity, diffusivity);
      for (const std::size_t i : {25u, 61u, 100u, 139u})
        {
          double sum = 0.;
          for (std::size_t j = 0; j + 1 < source.x.size(); ++j)
            {
              const double a = source.x[j], b = source.x[j + 1];
              if (source.flux[j] == 0. && source.flux[j + 1] == 0.)
                continue;
              sum += quadrature.integrate(
                [&](const double at) {
                  const double u = V * (source.x[i] - at) / (2 * diffusivity);
                  if (std::abs(u) < 1e-14 || u < -300.)
                    return 0.;
                  const double part = (at - a) / (b - a);
                  const double kernel =
                    u > 300.
                      ? std::sqrt(pi / (2 * u)) * (1 - 1 / (8 * u))
                      : std::exp(u) * boost::math::cyl_bessel_k(0, std::abs(u));
                  return kernel * (source.flux[j] + part * (source.flux[j + 1] -
                                                            source.flux[j]));
                },
                a,
                b);
            }
          BOOST_TEST(rise[i] == sum / (pi * conductivity),
                     boost::test_tools::tolerance(1e-5));
        }
    }
}

BOOST_AUTO_TEST_CASE(a_fast_source_heats_as_one_from_the_side)
{
  // theta = 1/(b sqrt(pi V)) int f / sqrt(x - x') dx', here of a constant f
  const double        V = 20., f = 1e8, length = 8e-3;
  std::vector<double> x, flux;
  for (unsigned int i = 0; i <= 200; ++i)
    {
      x.push_back(length * i / 200);
      flux.push_back(f);
    }
  const auto rise =
    References::moving_heat_source(x, flux, V, conductivity, diffusivity);
  for (const std::size_t i : {50u, 100u, 150u})
    BOOST_TEST(rise[i] == 2 * f * std::sqrt(diffusivity * x[i] / (pi * V)) /
                            conductivity,
               boost::test_tools::tolerance(2e-3));
  // backwards it is the mirror image
  const auto back =
    References::moving_heat_source(x, flux, -V, conductivity, diffusivity);
  for (std::size_t i = 0; i < x.size(); ++i)
    BOOST_TEST(back[i] == rise[x.size() - 1 - i],
               boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(full_sliding_of_two_discs)
{
  // p_0 sqrt(1 - x^2/a^2): the largest rise of a fast semi-elliptic flux f_0
  // is 1.3115 f_0 sqrt(a kappa/(pi V)) / k where x/a = 0.32; both bodies take
  // half of mu p s V
  SceneRun<2> run(standard<2>, [](SceneParameters &scene) {
    scene.contact.creepages.x        = 0.05;
    scene.contact.speed              = 40.;
    scene.mesh.elements_across_patch = 48;
  });
  const auto  rise =
    flash_temperature(run.situation(), run.steady.problem, run.steady.state);
  const auto   hottest = std::max_element(rise.begin(), rise.end());
  const double a = run.steady.result.half_width_x, V = 40.,
               p0    = 2 * run.steady.result.normal_force / (pi * a * 0.02),
               kappa = 50. / (7800. * 460.);
  // the same integral by midpoints of x = a (X - t^2)
  double largest = 0., at = 0.;
  for (double X = -1.; X < 1.; X += 0.01)
    {
      double             sum = 0.;
      const unsigned int n   = 2000;
      for (unsigned int k = 0; k < n; ++k)
        {
          const double t = std::sqrt(X + 1) * (k + 0.5) / n, x = X - t * t;
          sum += 2 * std::sqrt(std::max(0., 1 - x * x)) * std::sqrt(X + 1) / n *
                 (0.05 + 0.3 * a / 0.23 * x); // it slides more where it leaves
        }
      if (sum > largest)
        largest = sum, at = X;
    }
  const double exact =
    0.5 * 0.3 * p0 * V * largest * std::sqrt(a * kappa / (pi * V)) / 50.;
  BOOST_TEST(*hottest == exact, boost::test_tools::tolerance(0.02));
  const double place =
    run.steady.problem.operators.positions()[hottest - rise.begin()][0];
  BOOST_TEST(std::abs(place / a - at) < 0.06);
}

/**
 * Bodies of unlike temperature and no sliding: the surfaces have the mean
 * weighted by e = sqrt(k rho c), and the heat is what flows into a half-space
 * whose surface is suddenly at that.
 */
BOOST_AUTO_TEST_CASE(of_bodies_that_are_not_equally_warm)
{
  SceneRun<2> run(standard<2>, [](SceneParameters &scene) {
    scene.contact.creepages.x        = 0.;
    scene.contact.speed              = 40.;
    scene.wheel.temperature          = 400.;
    scene.rail.temperature           = 250.;
    scene.rail.thermal_conductivity  = 200.;
    scene.mesh.elements_across_patch = 48;
  });
  // e of the rail is twice that of the wheel
  BOOST_TEST(contact_temperature(run.situation()) == 300.,
             boost::test_tools::tolerance(1e-12));
  const auto flows =
    heat_flows(run.situation(), run.steady.problem, run.steady.state, 0.);
  BOOST_TEST(flows.wheel == -flows.rail);
  const double e = std::sqrt(50. * 7800. * 460.),
               a = run.steady.result.half_width_x, V = 40., n = 20000.;
  double sum = 0.; // of the flux e (400 - 300)/sqrt(pi t) over the patch
  for (double k = 0.5; k < n; ++k)
    sum += e * 100. / std::sqrt(pi * k / n * 2 * a / V) * 2 * a / n;
  BOOST_TEST(flows.rail == 0.02 * sum, boost::test_tools::tolerance(0.03));
  const auto shared =
    heat_flows(run.situation(), run.steady.problem, run.steady.state, 900.);
  BOOST_TEST(shared.wheel - flows.wheel == 300.,
             boost::test_tools::tolerance(1e-9));
  BOOST_TEST(shared.rail - flows.rail == 600.,
             boost::test_tools::tolerance(1e-9));
}

/**
 * Where mu follows the temperature, each node has the mu of its own.
 */
BOOST_AUTO_TEST_CASE(friction_that_becomes_less_where_it_is_hot)
{
  const std::string text = "300: 1, 400: 0.9, 1200: 0.3";
  const auto        make = [&](const double creepage, const std::string &hot) {
    return std::make_unique<SceneRun<2>>(
      standard<2>, [&](SceneParameters &scene) {
        scene.contact.creepages.x               = creepage;
        scene.contact.speed                     = 40.;
        scene.contact.friction_over_temperature = hot;
        scene.mesh.elements_across_patch        = 32;
      });
  };
  for (const double creepage : {0.002, 0.01, 0.05})
    {
      const auto        run = make(creepage, text), cold = make(creepage, "");
      const auto        rise = flash_temperature(run->situation(),
                                          run->steady.problem,
                                          run->steady.state);
      const HotFriction law(text);
      double            total = 0.;
      for (unsigned int i = 0; i < rise.size(); ++i)
        {
          const double mu = 0.3 * law.share(293.15 + rise[i]);
          BOOST_TEST(run->steady.problem.loads.friction[i] == mu,
                     boost::test_tools::tolerance(1e-7));
          const double p = run->steady.state.pressure[i];
          BOOST_TEST(std::abs(run->steady.state.traction(0, i)) <=
                     mu * p * (1 + 1e-6));
          total += mu * p * run->steady.problem.operators.areas()[i];
        }
      BOOST_TEST(std::abs(run->steady.result.force_x) <
                 std::abs(cold->steady.result.force_x));
      BOOST_TEST(run->steady.solver.friction_rounds > 2u);
      BOOST_TEST(!error_bounds(run->situation(), run->steady).force);
      if (creepage == 0.05)
        BOOST_TEST(std::abs(run->steady.result.force_x) == total,
                   boost::test_tools::tolerance(1e-6));
    }
  // friction that does not change where it is this hot
  const auto same = make(0.01, "293: 1, 3000: 1"), cold = make(0.01, "");
  BOOST_TEST(same->steady.result.force_x == cold->steady.result.force_x,
             boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(friction_over_temperature_as_it_is_written)
{
  const HotFriction law("300: 1, 500 : 0.6");
  BOOST_TEST(law.share(100.) == 1.);
  BOOST_TEST(law.share(400.) == 0.8, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(law.share(900.) == 0.6, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(HotFriction("").is_constant());
  for (const char *wrong : {"0.3",
                            "300 1",
                            "20: 1, 300: 0.5",
                            "300: 1, 300: 2",
                            "300: 0",
                            "300: inf",
                            "inf: 1",
                            "300: nan",
                            "300:",
                            "300: 1,",
                            ",",
                            "300: -1",
                            "300: x"})
    BOOST_CHECK_THROW(HotFriction{wrong}, InputError);
}

BOOST_AUTO_TEST_CASE(what_there_is_no_temperature_of)
{
  SceneRun<2> run(standard<2>, [](SceneParameters &scene) {
    scene.contact.creepages.x = 0.002;
    scene.contact.speed.reset();
  });
  BOOST_TEST(
    flash_temperature(run.situation(), run.steady.problem, run.steady.state)
      .empty());
  run.scene.contact.speed = 10.;
  const auto slow =
    flash_temperature(run.situation(), run.steady.problem, run.steady.state);
  BOOST_TEST(slow.size() == run.steady.problem.n_nodes());
  // more heat in proportion to V, less time to go in: as the root of V
  run.scene.contact.speed = 40.;
  const auto fast =
    flash_temperature(run.situation(), run.steady.problem, run.steady.state);
  BOOST_TEST(*std::max_element(fast.begin(), fast.end()) ==
               2 * *std::max_element(slow.begin(), slow.end()),
             boost::test_tools::tolerance(0.01));
  // a rail that takes heat better leaves the surface cooler
  run.scene.rail.thermal_conductivity = 200.;
  const auto cooled =
    flash_temperature(run.situation(), run.steady.problem, run.steady.state);
  BOOST_TEST(*std::max_element(cooled.begin(), cooled.end()) ==
               2. / 3 * *std::max_element(fast.begin(), fast.end()),
             boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_SUITE_END()
