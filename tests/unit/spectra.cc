#include <boost/test/unit_test.hpp>

#include <rolling_contact/algebra/spectrogram.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/time/spectrum_lines.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

using namespace RollingContact;
using namespace RollingContact::Signals;

/** Lines of spectra, what they are of, and spectra over time. */
BOOST_AUTO_TEST_SUITE(spectra)

namespace
{
  using Values = std::vector<double>;

  /** A sum of tones, each a frequency (Hz) and an amplitude. */
  Values tones(const std::size_t                             n,
               const double                                  step,
               const std::vector<std::pair<double, double>> &parts,
               const double                                  growth = 0.)
  {
    Values values(n, 0.);
    for (const auto &[frequency, amplitude] : parts)
      for (std::size_t j = 0; j < n; ++j)
        values[j] += amplitude * std::exp(growth * step * j) *
                     std::cos(2 * pi * frequency * step * j + frequency);
    return values;
  }

  double decibels(const double mean_square, const double amplitude)
  {
    return level(mean_square, 1.) - level(amplitude * amplitude / 2, 1.);
  }
} // namespace

/** Wherever between two lines of the spectrum a tone lies, its frequency comes
 * out to a hundredth of their distance and its level to 0.1 dB. */
BOOST_AUTO_TEST_CASE(a_tone_is_found_between_the_lines)
{
  const double step = 1e-5, amplitude = 0.02;
  for (const double part : {0., 0.1, 0.3, 0.5, 0.7, 0.99})
    for (const std::size_t segment : {1000, 4000})
      {
        const double line      = 1 / (segment * step),
                     frequency = (40 + part) * line;
        const PowerSpectrum spectrum =
          welch(tones(4000, step, {{frequency, amplitude}}), step, segment);
        const auto lines = spectral_lines(spectrum, LineCriteria());
        BOOST_TEST_REQUIRE(lines.size() == 1u);
        BOOST_TEST(std::abs(lines[0].frequency - frequency) < 0.01 * line);
        BOOST_TEST(std::abs(decibels(lines[0].mean_square, amplitude)) < 0.1);
        BOOST_TEST(lines[0].prominence > 60.);
        const double all =
          spectrum.step *
          std::accumulate(spectrum.density.begin(), spectrum.density.end(), 0.);
        BOOST_TEST(std::abs(decibels(all, amplitude)) < 0.1);
      }
}

/** A vibration that grows keeps its frequency. */
BOOST_AUTO_TEST_CASE(a_growing_tone_keeps_its_frequency)
{
  const double        step = 1e-5, frequency = 1691.3;
  const PowerSpectrum spectrum =
    welch(tones(4000, step, {{frequency, 1e-3}}, 50.), step, 1000);
  const auto lines = spectral_lines(spectrum, LineCriteria());
  BOOST_TEST_REQUIRE(lines.size() == 1u);
  BOOST_TEST(std::abs(lines[0].frequency - frequency) < 0.01 * spectrum.step);
}

/** Prominence is the height above the ground, noise has none to speak of, and
 * criteria drop what they say. */
BOOST_AUTO_TEST_CASE(prominence_is_above_the_ground)
{
  PowerSpectrum spectrum;
  spectrum.step    = 2.;
  spectrum.density = Values(200, 1.);
  for (const auto &[k, height] : {std::pair(50, 1e4), std::pair(80, 1e3)})
    {
      spectrum.density[k]     = height;
      spectrum.density[k - 1] = spectrum.density[k + 1] = height / 4;
    }
  spectrum.density[65] = 10.; // the ground between both is not lower elsewhere
  for (int k = 51; k < 80; ++k)
    spectrum.density[k] = std::max(spectrum.density[k], 5.);
  LineCriteria criteria;
  criteria.prominence = 2.;
  auto lines          = spectral_lines(spectrum, criteria);
  BOOST_TEST_REQUIRE(lines.size() == 3u);
  const auto tolerance = boost::test_tools::tolerance(1e-9);
  BOOST_TEST(lines[0].frequency == 100., tolerance);
  BOOST_TEST(lines[0].prominence == 40., tolerance);
  BOOST_TEST(lines[1].frequency == 130., boost::test_tools::tolerance(1e-2));
  BOOST_TEST(lines[1].prominence == 10 * std::log10(10. / 5.), tolerance);
  // the higher of 5 on the way to the stronger line and 1 on the other side
  BOOST_TEST(lines[2].prominence == 10 * std::log10(1e3 / 5.), tolerance);
  criteria.prominence = 10.;
  BOOST_TEST(spectral_lines(spectrum, criteria).size() == 2u);
  criteria.highest = 150.;
  BOOST_TEST(spectral_lines(spectrum, criteria).size() == 1u);
  criteria.highest = 0.;
  criteria.range   = 9.;
  BOOST_TEST(spectral_lines(spectrum, criteria).size() == 1u);
  criteria.range = 60.;
  criteria.most  = 1;
  lines          = spectral_lines(spectrum, criteria);
  BOOST_TEST_REQUIRE(lines.size() == 1u);
  BOOST_TEST(lines[0].frequency == 100., tolerance);
}

/** Multiples of the strongest line, and the eigenvalue nearest in the complex
 * plane: a damped one that is nearer by its frequency alone does not count. */
BOOST_AUTO_TEST_CASE(lines_know_what_they_are_of)
{
  const double   step = 2e-5;
  SignalSpectrum of{
    {"velocity_y_m/s", "velocity_y", "contact y", SignalKind::velocity},
    welch(tones(20000,
                step,
                {{391.7, 0.1}, {783.4, 0.01}, {1175.1, 3e-3}, {1050., 0.02}}),
          step,
          20000),
    {},
    {}};
  of.lines = spectral_lines(of.spectrum, LineCriteria());
  BOOST_TEST_REQUIRE(of.lines.size() == 4u);
  BOOST_TEST(strongest_line(of) == 0u);
  const ComplexValues               eigenvalues{{-900., 2 * pi * 391.8},
                                  {73.4, 2 * pi * 392.1},
                                  {500., 0.},
                                  {-2., 2 * pi * 1052.}};
  const std::array<unsigned int, 4> multiples{{1, 2, 0, 3}};
  for (std::size_t i = 0; i < 4; ++i)
    {
      const LineOrigin origin = origin_of(of, i, eigenvalues);
      BOOST_TEST(origin.multiple == multiples[i]);
      BOOST_TEST(std::abs(origin.fundamental - 391.7) < 0.01);
      BOOST_TEST(origin.eigenfrequency() == (i < 1 ? 392.1 : 1052.),
                 boost::test_tools::tolerance(i == 1 ? 1. : 1e-12));
    }
  BOOST_TEST(origin_of(of, 0, eigenvalues).eigenvalue.real() == 73.4);
  BOOST_TEST(origin_of(of, 0, {}).eigenvalue == std::complex<double>());
}

/** A chirp: in each window the highest line is where the frequency is then. */
BOOST_AUTO_TEST_CASE(a_spectrogram_follows_a_chirp)
{
  const double      step = 1e-4, from = 300., rate = 400., amplitude = 2.;
  const std::size_t n = 20000, window = 500;
  Values            values(n);
  for (std::size_t j = 0; j < n; ++j)
    {
      const double t = step * j;
      values[j]      = amplitude * std::sin(2 * pi * (from + rate * t / 2) * t);
    }
  const Spectrogram found = spectrogram(values, step, window);
  BOOST_TEST(found.frequency_step == 20., boost::test_tools::tolerance(1e-12));
  BOOST_TEST(found.times.size() == (n - window) / 125 + 1);
  BOOST_TEST(found.times.front() == 0.025, boost::test_tools::tolerance(1e-12));
  for (std::size_t i = 0; i < found.times.size(); ++i)
    {
      const Values &line = found.mean_squares[i];
      const double  at =
        found.frequency_step *
        (std::max_element(line.begin(), line.end()) - line.begin());
      BOOST_TEST(std::abs(at - from - rate * found.times[i]) <=
                 0.55 * found.frequency_step);
      const double level_of_tone =
        decibels(*std::max_element(line.begin(), line.end()), amplitude);
      BOOST_TEST(level_of_tone < 0.1);
      BOOST_TEST(level_of_tone > -2.);
    }
  // a tone on a line has its mean square
  const Spectrogram tone =
    spectrogram(tones(n, step, {{400., amplitude}}), step, window);
  BOOST_TEST(std::abs(decibels(tone.mean_squares[7][20], amplitude)) < 0.01);
}

/** Never more windows than asked for, and none of values that are too few. */
BOOST_AUTO_TEST_CASE(a_spectrogram_is_bounded)
{
  const Values values = tones(10000, 1e-4, {{100., 1.}});
  for (const std::size_t most : {7, 50})
    {
      const Spectrogram found = spectrogram(values, 1e-4, 64, most);
      BOOST_TEST(found.times.size() <= most + 1);
      BOOST_TEST(found.times.size() > most / 2);
    }
  BOOST_TEST(spectrogram(values, 1e-4, 10001).times.empty());
  BOOST_TEST(spectrogram(values, 1e-4, 10000).times.size() == 1u);
}

BOOST_AUTO_TEST_SUITE_END()
