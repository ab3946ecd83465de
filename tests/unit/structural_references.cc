#include <boost/test/unit_test.hpp>

#include "../references/annular_plate.h"
#include "../references/slender_bodies.h"
#include "../references/timoshenko_rail.h"

#include <rolling_contact/base/exceptions.h>

#include <cmath>
#include <complex>

using namespace RollingContact;
using namespace RollingContact::References;

BOOST_AUTO_TEST_SUITE(structural_references)

namespace
{
  const double pi = std::acos(-1.);
} // namespace

BOOST_AUTO_TEST_CASE(receptance_of_a_rail_on_a_foundation)
{
  // an independent computation, at 1000 Hz by quadrature as well
  const TimoshenkoRail                       rail;
  const std::array<std::array<double, 3>, 7> expected{
    {{{0., 3.206962e-09, -8.187}},
     {{100., 3.371549e-09, -8.799}},
     {{372.6, 1.011968e-08, -66.091}},
     {{500., 3.400794e-09, -118.646}},
     {{1000., 7.894492e-10, -116.728}},
     {{2000., 3.068573e-10, -104.443}},
     {{5000., 1.212927e-10, -91.322}}}};
  for (const auto &[frequency, size, phase] : expected)
    {
      const auto value = rail.receptance(frequency);
      BOOST_TEST(std::abs(std::abs(value) / size - 1) < 1e-6);
      BOOST_TEST(std::abs(std::arg(value) * 180 / pi - phase) < 1e-3);
    }
}

BOOST_AUTO_TEST_CASE(receptance_along_a_rail_is_its_fourier_integral)
{
  const TimoshenkoRail       rail;
  const double               frequency = 800., omega = 2 * pi * frequency;
  const std::complex<double> steel(1., rail.loss_factor);
  const std::complex<double> bending = rail.bending_stiffness * steel,
                             shear   = rail.shear_stiffness * steel,
                             stiff   = rail.foundation_stiffness *
                                       std::complex<double>(
                                         1., rail.foundation_loss_factor) -
                                     rail.mass * omega * omega,
                             turn = shear - rail.rotary_inertia * omega * omega;
  for (const double x : {0., 0.3, 1.7})
    {
      // without 1 / (shear k^2 + c^2), whose integral is exp(-c |x| / ...)
      const double         c = 3., end = 600.;
      std::complex<double> sum = 0.;
      const unsigned int   n   = 600000;
      for (unsigned int i = 0; i < n; ++i)
        {
          const double               k   = (i + 0.5) * end / n;
          const std::complex<double> top = bending * k * k + turn,
                                     value =
                                       top / ((shear * k * k + stiff) * top -
                                              shear * k * shear * k);
          sum += (value - 1. / (shear * (k * k + c * c))) * std::cos(k * x) *
                 (end / n) / pi;
        }
      sum += std::exp(-c * x) / (2. * c * shear);
      BOOST_TEST(std::abs(sum - rail.receptance(frequency, x)) <
                 1e-4 * std::abs(rail.receptance(frequency)));
    }
}

BOOST_AUTO_TEST_CASE(a_static_rail_without_shear_is_winklers)
{
  TimoshenkoRail rail;
  rail.shear_stiffness *= 1e6;
  rail.loss_factor = rail.foundation_loss_factor = 0.;
  const double winkler =
    winkler_beam_compliance(rail.bending_stiffness, rail.foundation_stiffness);
  BOOST_TEST(std::abs(rail.receptance(0.).real() / winkler - 1) < 1e-5);
  // at a distance: exp(-b x) (cos b x + sin b x)
  const double b =
    std::pow(rail.foundation_stiffness / (4 * rail.bending_stiffness), 0.25);
  BOOST_TEST(std::abs(rail.receptance(0., 1. / b).real() / winkler -
                      std::exp(-1.) * (std::cos(1.) + std::sin(1.))) < 1e-5);
}

BOOST_AUTO_TEST_CASE(frequencies_of_an_annular_plate)
{
  // an independent computation by Bessel functions of another library
  const std::array<std::array<double, 3>, 6> expected{
    {{{115.173, 711.055, 2074.535}},
     {{104.533, 765.010, 2146.039}},
     {{145.352, 949.158, 2378.525}},
     {{295.276, 1282.986, 2800.194}},
     {{514.358, 1738.883, 3405.561}},
     {{788.660, 2279.291, 4150.172}}}};
  const AnnularPlate plate;
  for (unsigned int n = 0; n < expected.size(); ++n)
    {
      const auto found = plate.frequencies(n, 3);
      BOOST_REQUIRE_EQUAL(found.size(), 3u);
      for (unsigned int i = 0; i < 3; ++i)
        BOOST_TEST(std::abs(found[i] - expected[n][i]) < 6e-4);
    }
  AnnularPlate inverted;
  inverted.inner_radius = 0.5;
  BOOST_CHECK_THROW(inverted.frequencies(0, 1), InputError);
}

BOOST_AUTO_TEST_CASE(formulas_of_slender_bodies)
{
  Bar bar;
  bar.width = bar.depth = 0.1;
  const double J        = torsional_stiffness(bar) / bar.shear_modulus;
  BOOST_TEST(std::abs(J / 1e-4 - 0.140577) < 1e-6); // square
  bar.width = 0.2;
  BOOST_TEST(std::abs(torsional_stiffness(bar) / bar.shear_modulus / 2e-4 -
                      0.228682) < 1e-6); // 2 : 1
  std::swap(bar.width, bar.depth);
  BOOST_TEST(std::abs(torsional_stiffness(bar) / bar.shear_modulus / 2e-4 -
                      0.228682) < 1e-6);
  bar            = Bar();
  bar.length     = 2.;
  const double c = std::sqrt(bar.young_modulus * bar.second_moment() /
                             (bar.density * bar.area())) /
                   (2 * pi * bar.length * bar.length);
  // (beta L)^2 of the tables
  BOOST_TEST(std::abs(cantilever_frequency(bar, 1) / c - 3.516015) < 1e-6);
  BOOST_TEST(std::abs(cantilever_frequency(bar, 2) / c - 22.034492) < 1e-6);
  BOOST_TEST(std::abs(cantilever_frequency(bar, 3) / c - 61.697214) < 1e-6);
  const double I = 1e-4 / 12;
  BOOST_TEST(std::abs(cantilever_compliance(bar) /
                        (8 / (3 * 210e9 * I) + 2 / (5. / 6 * 81e9 * 0.01)) -
                      1) < 1e-12);
  // n = 2: omega = 6 / sqrt 5 = 2.683282 sqrt(E I / (rho A R^4))
  const double ring = std::sqrt(210e9 * I / (7850. * 0.01)) / (2 * pi * 0.25);
  BOOST_TEST(std::abs(free_ring_frequency(bar, 0.5, 2) / ring - 2.683282) <
             1e-6);
  BOOST_TEST(std::abs(free_ring_frequency(bar, 0.5, 3) / ring - 7.589466) <
             1e-6);
  BOOST_TEST(free_ring_frequency(bar, 0.5, 1) == 0.);
}

BOOST_AUTO_TEST_SUITE_END()
