#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/bessel.hpp>
#include <boost/test/unit_test.hpp>

#include "scene_run.h"
#include "time_run.h"

#include <rolling_contact/references/moving_heat_source.h>
#include <rolling_contact/results/flash_temperature.h>

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
