#include <boost/test/unit_test.hpp>

#include "../references/timoshenko_rail.h"
#include "rail_on_layer.h"
#include "scene_run.h"

#include <rolling_contact/analyses/decay_energies.h>
#include <rolling_contact/analyses/track_decay.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/modes/fading_waves.h>
#include <rolling_contact/modes/measuring_point.h>

#include <algorithm>
#include <cmath>
#include <complex>

using namespace RollingContact;

BOOST_AUTO_TEST_SUITE(track_decay)

namespace
{
  using Complex = std::complex<double>;

  const double decibels = 20 / std::log(10.);

  const auto closely = boost::test_tools::tolerance(1e-12);

  /** |A|^2 that falls by a factor along each metre. */
  std::vector<double> falling(const DecayGrid &grid, const double factor)
  {
    std::vector<double> energies;
    for (const double x : grid.distances())
      energies.push_back(3e-18 * std::pow(factor, x));
    return energies;
  }
} // namespace

BOOST_AUTO_TEST_CASE(places_are_those_of_the_standard)
{
  const DecayGrid grid(0.6), wider(0.65);
  const auto     &x = grid.distances();
  BOOST_TEST_REQUIRE(x.size() == 29);
  for (unsigned int n = 0; n <= 10; ++n)
    BOOST_TEST(x[n] == 0.15 * n, closely);
  const std::vector<double> bays{
    3, 3.5, 4, 5, 6, 7, 8, 10, 12, 16, 20, 24, 30, 36, 42, 48, 54, 66};
  for (std::size_t n = 0; n < bays.size(); ++n)
    {
      BOOST_TEST(x[11 + n] == 0.6 * bays[n], closely);
      BOOST_TEST(wider.distances()[11 + n] == 0.65 * bays[n], closely);
    }
  // a rail that does not fade: all of its length, and half a step beyond
  BOOST_TEST(grid.rate(falling(grid, 1.)) == decibels / 2 / (39.6 + 6 * 0.6),
             closely);
  BOOST_TEST(grid.floor() == decibels / 2 / 39.6, closely);
}

/** Trapezoids of a geometric series from a to b, h apart, are
 * h / 2 (1 + q^h) / (1 - q^h) (q^a - q^b). */
BOOST_AUTO_TEST_CASE(what_falls_by_a_factor_has_a_closed_sum)
{
  const DecayGrid grid(0.6);
  for (const double factor : {0.02, 0.4, 0.85, 0.98})
    {
      double sum = 6 * 0.6 * std::pow(factor, 39.6);
      // from where in bays, to where, steps
      for (const auto &[a, b, h] :
           std::vector<std::array<double, 3>>{{{0., 2.5, 0.25}},
                                              {{2.5, 4., 0.5}},
                                              {{4., 8., 1.}},
                                              {{8., 12., 2.}},
                                              {{12., 24., 4.}},
                                              {{24., 54., 6.}},
                                              {{54., 66., 12.}}})
        {
          const double q = std::pow(factor, 0.6 * h);
          sum += 0.3 * h * (1 + q) / (1 - q) *
                 (std::pow(factor, 0.6 * a) - std::pow(factor, 0.6 * b));
        }
      BOOST_TEST(grid.rate(falling(grid, factor)) == decibels / 2 / sum,
                 closely);
    }
  // 20 lg e b, for amplitudes exp(-b x) that the places follow
  for (const double b : {0.04, 0.08, 0.3})
    BOOST_TEST(grid.rate(falling(grid, std::exp(-2 * b))) == decibels * b,
               boost::test_tools::tolerance(0.03));
}

BOOST_AUTO_TEST_CASE(bands_are_third_octaves_and_means_are_over_them)
{
  BOOST_TEST(decay_bands(0., 1e5).size() == 18);
  BOOST_TEST(decay_bands(100., 5000.).size() == 18);
  BOOST_TEST(decay_bands(101., 4999.).size() == 16);
  BOOST_TEST(decay_bands(5001., 9000.).empty());
  const auto bands = decay_bands(100., 5000.);
  for (std::size_t k = 0; k < bands.size(); ++k)
    {
      BOOST_TEST(bands[k].exact().centre == std::pow(10., 2 + k / 10.),
                 closely);
      BOOST_TEST(bands[k].exact().centre == bands[k].nominal,
                 boost::test_tools::tolerance(0.015));
      BOOST_TEST(bands[k].vertical_limit.has_value() ==
                 (bands[k].nominal >= 250.));
      BOOST_TEST(bands[k].lateral_limit.has_value() ==
                 (bands[k].nominal >= 250.));
    }
  const double lower = std::pow(10., 2.95), upper = std::pow(10., 3.05),
               h       = (upper - lower) / 5;
  unsigned int n_calls = 0;
  const auto   mean    = bands[10].mean(5, [&](const double f) {
    BOOST_TEST(f == lower + (n_calls + 0.5) * h, closely);
    ++n_calls;
    return std::vector<double>{7., f, f * f};
  });
  BOOST_TEST(n_calls == 5);
  BOOST_TEST(mean[0] == 7., closely);
  BOOST_TEST(mean[1] == (lower + upper) / 2, closely);
  // midpoints of f^2 are short of the integral by h^2 / 12
  BOOST_TEST(mean[2] ==
               (upper * upper + upper * lower + lower * lower) / 3 - h * h / 12,
             closely);
}

BOOST_AUTO_TEST_CASE(fitted_waves_go_on_and_leave_out_what_returns)
{
  const std::vector<Complex> z{std::polar(0.994, -0.37),
                               std::polar(0.97, -0.2),
                               std::polar(0.8, 0.1),
                               std::polar(1.01, 0.37)};
  for (const unsigned int places : {1, 8})
    {
      ComplexMatrix samples = ComplexMatrix::Zero(places, 14), a(places, 4);
      for (unsigned int c = 0; c < places; ++c)
        for (unsigned int j = 0; j < 4; ++j)
          {
            a(c, j) = std::polar(j == 3 ? 0.02 : 1. / (1. + j), 0.7 * c * j);
            for (Eigen::Index n = 0; n < samples.cols(); ++n)
              samples(c, n) += a(c, j) * std::pow(z[j], n);
          }
      const FadingWaves waves(samples, 6);
      BOOST_TEST(waves.misfit() < 1e-6);
      BOOST_TEST(waves.returning() == 0.02 * std::pow(1.01, 13),
                 boost::test_tools::tolerance(1e-3));
      for (const double n : {0., 30., 200.})
        {
          Complex exact = 0.;
          for (unsigned int j = 0; j < 3; ++j)
            exact += a(places - 1, j) * std::pow(z[j], n);
          BOOST_TEST(std::abs(waves.at(places - 1, n) - exact) <
                     1e-3 * std::abs(exact));
        }
      // fewer than there are leave something
      BOOST_TEST(FadingWaves(samples, 1).misfit() > 0.05);
    }
}

namespace
{
  /** The rail of rail_waves.prm. */
  struct RailOnLayer : public SceneInMemory
  {
    RailOnLayer()
    {
      scene.dimension   = 3;
      scene.prm_folder  = TEST_DATA "/../../prm";
      scene.wheel.rigid = true;
      set_rail_on_layer(scene.rail, 1.2, 48);
      section.lowest_frequency  = 400.;
      section.highest_frequency = 2000.;
      section.load_radius       = 0.02;
      body                      = std::make_unique<const VibratingBody<3>>(
        situation(), Side::rail, scene.modes, 5000., context);
    }

    ReceptanceParameters                    section;
    std::unique_ptr<const VibratingBody<3>> body;
  };
} // namespace

BOOST_AUTO_TEST_CASE(a_rail_on_a_layer_fades_as_a_beam)
{
  RailOnLayer                      rail;
  const References::TimoshenkoRail beam;
  const DecayGrid                  grid(0.6);
  const TrackDecay decay(*rail.body, rail.section, rail.context);
  const auto       energies   = decay_energies(*rail.body, grid, rail.section);
  double           worst_rate = 0., worst_wave = 0.;
  for (const DecayBand &band : decay_bands(400., 2000.))
    {
      const double f = band.exact().centre;
      auto         found =
        band.mean(8, [&](const double line) { return energies->at(line); });
      BOOST_TEST_REQUIRE(found.size() == 58);
      found.resize(29); // vertical
      const auto   of_beam = band.mean(8, [&](const double line) {
        std::vector<double> values;
        for (const double x : grid.distances())
          values.push_back(std::norm(line * beam.receptance(line, x)));
        return values;
      });
      const double rate    = grid.rate(found) / grid.rate(of_beam) - 1,
                   wave =
                     decay.least_decay(2, f) /
                       (20 * std::log10(std::abs(beam.receptance(f, 20.) /
                                                 beam.receptance(f, 21.)))) -
                     1;
      BOOST_TEST_MESSAGE(band.nominal << " Hz: rate " << rate << ", wave "
                                      << wave << " off");
      worst_rate = std::max(worst_rate, std::abs(rate));
      worst_wave = std::max(worst_wave, std::abs(wave));
    }
  BOOST_TEST(worst_rate < 0.06);
  BOOST_TEST(worst_wave < 0.07);
}

BOOST_AUTO_TEST_CASE(energies_are_those_of_receptances_either_way)
{
  RailOnLayer     rail;
  const DecayGrid grid(0.6);
  const auto      energies = decay_energies(*rail.body, grid, rail.section);
  const MeasuringPoint contact(*rail.body->body, {{0., 0., 0.}}, 0.02);
  const RailWaves     &waves  = *rail.body->waves;
  const std::size_t    n      = rail.body->K.size();
  const auto           up     = contact.load(2, n);
  const auto           middle = middle_of(rail.body->places, 2, as_vector(up));
  const DenseMatrix    beyond =
    waves.beyond_mesh(*rail.body->body, *rail.body->factor, {middle});
  for (const double f : {150., 900., 2200.})
    {
      const Complex s(0., 2 * pi * f);
      const auto    found  = energies->at(f);
      const auto    change = waves.change(s, {middle});
      for (unsigned int d = 0; d < 2; ++d)
        {
          const unsigned int axis = d == 0 ? 2 : 1;
          const auto         load = contact.load(axis, n);
          const auto         rest = rail.body->factor->solve(load);
          const Complex      here =
            (as_vector(load).dot(as_vector(rest)) + beyond(axis, axis)) /
              waves.stiffening(s) +
            change(axis, axis);
          BOOST_TEST(found[29 * d] == std::norm(s * here),
                     boost::test_tools::tolerance(1e-8));
          // struck there and measured here, ahead and behind
          for (const std::size_t place : {2, 4, 20})
            for (const double way : {-1., 1.})
              {
                auto there = middle;
                there[0] += way * grid.distances()[place];
                const auto alpha =
                  waves.waveguide().receptances(s, {middle, there});
                BOOST_TEST(found[29 * d + place] ==
                             std::norm(s * alpha(axis, 3 + axis)),
                           boost::test_tools::tolerance(1e-6));
              }
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
