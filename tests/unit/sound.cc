#include <boost/test/unit_test.hpp>

#include <rolling_contact/algebra/third_octaves.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/time/a_weighting.h>
#include <rolling_contact/time/radiation_efficiency.h>
#include <rolling_contact/time/sound_pressure.h>
#include <rolling_contact/time/wav_file.h>

#include <cmath>
#include <cstdint>
#include <numeric>

using namespace RollingContact;
using namespace RollingContact::Sound;

BOOST_AUTO_TEST_SUITE(sound)

namespace
{
  const Air    air{1.25, 340.};
  const double rho_c = 1.25 * 340.;

  const double      step = 1e-4; // s
  const std::size_t n    = 2000;

  std::vector<double>
  tone(const double frequency, const double amplitude, const double phase = 0.)
  {
    std::vector<double> values(n);
    for (std::size_t j = 0; j < n; ++j)
      values[j] = amplitude * std::cos(2 * pi * frequency * step * j + phase);
    return values;
  }

  AudibleRange up_to(const double frequency)
  {
    AudibleRange range;
    range.highest = frequency;
    return range;
  }

  /** Modes that radiate together at one efficiency. */
  RadiatingPart part(const std::vector<std::size_t> &modes,
                     const std::vector<double>      &surface,
                     const double                    efficiency)
  {
    RadiatingPart result{modes,
                         DenseMatrix::Zero(modes.size(), modes.size()),
                         [=](const double) { return efficiency; }};
    std::copy(surface.begin(), surface.end(), result.surface.data());
    return result;
  }

  double sum(const std::vector<double> &values)
  {
    return std::accumulate(values.begin(), values.end(), 0.);
  }
} // namespace

BOOST_AUTO_TEST_CASE(weighting_of_the_standard)
{
  // IEC 61672-1, table of design goals, rounded to 0.1 dB
  for (const auto &[frequency, level] :
       std::vector<std::pair<double, double>>{{19.953, -50.5},
                                              {31.623, -39.4},
                                              {100., -19.1},
                                              {199.53, -10.9},
                                              {501.19, -3.2},
                                              {1000., 0.},
                                              {2511.9, 1.3},
                                              {3981.1, 1.},
                                              {10e3, -2.5},
                                              {15849., -6.6}})
    BOOST_TEST(std::abs(10 * std::log10(a_weighting(frequency)) - level) <
               0.06);
  BOOST_TEST(a_weighting(1000.) == 1.);
}

BOOST_AUTO_TEST_CASE(efficiencies_of_a_wheel)
{
  const auto near = [](const double value, const double expected) {
    BOOST_TEST(value == expected, boost::test_tools::tolerance(1e-10));
  };
  // computed with 25 digits from the formulas, the radial ones by quadrature
  near(axial_efficiency_of_wheel(0, 0.46, 343., 100.), 0.0372456374406);
  near(axial_efficiency_of_wheel(2, 0.46, 343., 400.), 0.254820869335);
  near(axial_efficiency_of_wheel(3, 0.46, 343., 1050.), 0.997908755321);
  near(radial_efficiency_of_wheel(0, 0.46, 0.135, 343., 100.), 0.0757982568586);
  near(radial_efficiency_of_wheel(2, 0.46, 0.135, 343., 500.), 0.280114499301);
  near(radial_efficiency_of_wheel(3, 0.46, 0.135, 343., 2000.), 0.519178245539);

  // a small source: k^2 S / (4 pi)
  const double k = 2 * pi * 2. / 343.;
  BOOST_TEST(radial_efficiency_of_wheel(0, 0.46, 0.135, 343., 2.) ==
               k * k * 0.46 * 0.135 / 2,
             boost::test_tools::tolerance(1e-3));
  for (unsigned int diameters = 0; diameters < 9; ++diameters)
    {
      BOOST_TEST(axial_efficiency_of_wheel(diameters, 0.46, 343., 9000.) >
                 0.99);
      BOOST_TEST(axial_efficiency_of_wheel(diameters, 0.46, 343., 60.) < 0.01);
    }
}

BOOST_AUTO_TEST_CASE(efficiency_of_a_beam)
{
  // -i H_1 / H_1' with the Hankel function of the second kind, its real part
  BOOST_TEST(efficiency_of_cylinder(0.05, 343., 100.) == 0.00122735222853,
             boost::test_tools::tolerance(1e-10));
  BOOST_TEST(efficiency_of_cylinder(0.05, 343., 1000.) == 0.670000976863,
             boost::test_tools::tolerance(1e-10));
  BOOST_TEST(efficiency_of_cylinder(0.1, 343., 3000.) == 1.00316893192,
             boost::test_tools::tolerance(1e-10));

  BOOST_TEST(equivalent_radius(pi * 0.04 * 0.04, 0.08, pi * 0.04) == 0.04,
             boost::test_tools::tolerance(1e-12));
  // a plate of the width w that moves across itself, per length and v^2:
  // rho c k^3 (pi w^2 / 4)^2 / 8, both faces being its surface
  const double w = 0.15, f = 5., k = 2 * pi * f / 343.,
               power = rho_c * k * k * k * std::pow(pi * w * w / 4, 2) / 8;
  BOOST_TEST(
    rho_c * efficiency_of_cylinder(equivalent_radius(0., w, 2 * w), 343., f) *
        2 * w ==
      power,
    boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(power_of_a_tone)
{
  // 500 Hz is a line of the record, and of the segments
  const double        R = 0.8, efficiency = 0.3, amplitude = 0.02;
  const RadiatingBody body{{500.}, {part({0}, {R}, efficiency)}};
  const BodySound     found =
    body_sound(body, {tone(500., amplitude)}, step, air, up_to(2000.));
  const double expected = rho_c * efficiency * R * amplitude * amplitude / 2;
  BOOST_TEST(found.power == expected, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(found.alone[0] == expected, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(found.part[0] == expected, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(sum(found.spectrum.density) * found.spectrum.step == expected,
             boost::test_tools::tolerance(1e-9));
  bool has_band = false;
  for (const auto &band : Signals::third_octaves(found.spectrum))
    if (band.lower_edge() < 500. && band.upper_edge() > 500.)
      {
        has_band = true;
        BOOST_TEST(*band.mean_square == expected,
                   boost::test_tools::tolerance(1e-6));
      }
  BOOST_TEST(has_band);
}

BOOST_AUTO_TEST_CASE(modes_together_and_apart)
{
  const double        a = 0.03, b = 0.02;
  const RadiatingBody together{{400., 600.},
                               {part({0, 1}, {0.5, 0.2, 0.2, 0.3}, 0.4)}};
  const auto          expected = [&](const double way) {
    return rho_c * 0.4 * (0.5 * a * a + 0.3 * b * b + way * 2 * 0.2 * a * b) /
           2;
  };
  for (const double way : {1., -1., 0.}) // in phase, against it, a quarter off
    {
      const auto second =
        tone(500., b, way == 0. ? pi / 2 : (way > 0. ? 0. : pi));
      const BodySound found =
        body_sound(together, {tone(500., a), second}, step, air, up_to(2000.));
      BOOST_TEST(found.power == expected(way),
                 boost::test_tools::tolerance(1e-9));
      BOOST_TEST(found.part[0] + found.part[1] == found.power,
                 boost::test_tools::tolerance(1e-9));
      BOOST_TEST(found.alone[0] == rho_c * 0.4 * 0.5 * a * a / 2,
                 boost::test_tools::tolerance(1e-9));
    }
  const RadiatingBody apart{{400., 600.},
                            {part({0}, {0.5}, 0.4), part({1}, {0.3}, 0.7)}};
  const BodySound     found =
    body_sound(apart, {tone(500., a), tone(500., b)}, step, air, up_to(2000.));
  BOOST_TEST(found.power == rho_c * (0.4 * 0.5 * a * a + 0.7 * 0.3 * b * b) / 2,
             boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(only_what_is_audible)
{
  const RadiatingBody body{{500.}, {part({0}, {1.}, 1.)}};
  for (const double frequency : {10., 2500.})
    BOOST_TEST(
      body_sound(body, {tone(frequency, 1.)}, step, air, up_to(2000.)).power <
      1e-20);
  BOOST_TEST(body_sound(body, {tone(0., 1.)}, step, air, up_to(2000.)).power <
             1e-20);
  // at rest, and without modes
  const BodySound rest =
    body_sound(body, {tone(500., 0.)}, step, air, up_to(2000.));
  BOOST_TEST(rest.power == 0.);
  BOOST_TEST(sum(rest.spectrum.density) == 0.);
  BOOST_TEST(body_sound({}, {}, step, air, up_to(2000.)).power == 0.);
}

BOOST_AUTO_TEST_CASE(efficiency_belongs_to_the_frequency_of_the_motion)
{
  RadiatingBody body{{500.}, {part({0}, {1.}, 1.)}};
  body.parts[0].efficiency = [](const double f) { return f / 1000.; };
  const double a           = 0.01;
  auto         both        = tone(500., a);
  const auto   harmonic    = tone(1500., a);
  for (std::size_t j = 0; j < n; ++j)
    both[j] += harmonic[j];
  BOOST_TEST(body_sound(body, {both}, step, air, up_to(2000.)).power ==
               rho_c * (0.5 + 1.5) * a * a / 2,
             boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(pressure_has_the_level_of_the_power)
{
  const RadiatingBody body{{500., 600.},
                           {part({0}, {0.8}, 0.3), part({1}, {0.8}, 0.3)}};
  // two signals that would cancel and a tone that is no line of the record
  const BodySound against = body_sound(body,
                                       {tone(500., 0.02), tone(500., 0.02, pi)},
                                       step,
                                       air,
                                       up_to(2000.)),
                  between = body_sound(body,
                                       {tone(731.3, 0.01), tone(500., 0.)},
                                       step,
                                       air,
                                       up_to(2000.));
  const unsigned int rate = 44100;
  const auto         p =
    pressure_over_time({against, between}, n * step, air, 7.5, rate);
  BOOST_TEST(p.size() == 8820);
  double squares = 0.;
  for (const double value : p)
    squares += value * value;
  const double expected =
    rho_c * (against.power + between.power) / (2 * pi * 7.5 * 7.5);
  BOOST_TEST(squares / p.size() == expected,
             boost::test_tools::tolerance(1e-9));
  BOOST_TEST(mean_square_pressure(2., air, 3.) == rho_c * 2. / (2 * pi * 9.),
             boost::test_tools::tolerance(1e-12));

  // sound of 120 dB re 1 pW on a hemisphere of 1 m^2: 120 dB re 20 uPa
  const double r = std::sqrt(1 / (2 * pi));
  BOOST_TEST(
    std::abs(
      Signals::level(mean_square_pressure(1., {1.2, 333.333}, r), 20e-6) -
      120.) < 0.01);
}

BOOST_AUTO_TEST_CASE(pressure_keeps_pitch_and_phase)
{
  const RadiatingBody body{{500.}, {part({0}, {0.8}, 0.3)}};
  const BodySound     found =
    body_sound(body, {tone(500., 0.02, 0.4)}, step, air, up_to(2000.));
  const unsigned int rate = 8000;
  const auto         p = pressure_over_time({found}, n * step, air, 2., rate);
  const double       amplitude =
    std::sqrt(2 * mean_square_pressure(found.power, air, 2.));
  for (std::size_t j = 0; j < p.size(); j += 37)
    BOOST_TEST(std::abs(p[j] - amplitude * std::cos(2 * pi * 500. * j / rate +
                                                    0.4)) < 1e-9 * amplitude);
}

BOOST_AUTO_TEST_CASE(a_sound_of_periods_goes_on_without_a_click)
{
  const double        period = 41.37; // samples
  std::vector<double> record;
  for (unsigned int i = 0; i < 1300; ++i)
    record.push_back(std::cos(2 * pi * i / period) +
                     // what is left of the start, and of the end's wrap
                     (i < 500 ? 5. : 0.) + (i > 1290 ? 7. : 0.));
  const auto found = repeated_periods(record, period, 9000);
  BOOST_TEST(found.size() == 9000u);
  // the tone, without a click, in pitch
  double       steepest = 0., square = 0.;
  unsigned int n_crossings = 0;
  for (unsigned int i = 0; i + 1 < found.size(); ++i)
    {
      steepest = std::max(steepest, std::abs(found[i + 1] - found[i]));
      square += found[i] * found[i] / found.size();
      n_crossings += found[i] < 0. && found[i + 1] >= 0.;
    }
  BOOST_TEST(steepest < 1.02 * 2 * pi / period);
  BOOST_TEST(std::abs(square - 0.5) < 0.005);
  BOOST_TEST(std::abs(n_crossings - 9000 / period) < 1.);
  // too few periods, or long enough
  BOOST_TEST(repeated_periods(record, 200., 9000) == record);
  BOOST_TEST(repeated_periods(record, period, 1000) == record);
}

BOOST_AUTO_TEST_CASE(records_of_whole_samples)
{
  for (const double h : {4e-6, 3.3e-6, 1e-5})
    for (const std::size_t steps : {500, 25000, 100003})
      {
        const std::size_t m = steps_of_whole_samples(steps, h, 44100);
        BOOST_TEST(m <= steps);
        BOOST_TEST(100 * m >= 99 * steps);
        const double samples = m * h * 44100, all = steps * h * 44100;
        BOOST_TEST(std::abs(samples - std::round(samples)) <=
                   std::abs(all - std::round(all)) + 1e-9);
        if (steps > 1000)
          BOOST_TEST(std::abs(samples - std::round(samples)) < 0.01);
      }
}

BOOST_AUTO_TEST_CASE(wav_file_byte_by_byte)
{
  const std::vector<double> values{0., 1., -1., 2., -2., 3., -3.};
  const std::string         bytes = wav_file(values, 44100, 2., "two Pa");
  const auto integer = [&](const std::size_t at, const unsigned int n_bytes) {
    std::uint32_t value = 0;
    for (unsigned int i = 0; i < n_bytes; ++i)
      value |=
        static_cast<std::uint32_t>(static_cast<unsigned char>(bytes.at(at + i)))
        << (8 * i);
    return value;
  };
  BOOST_TEST(bytes.substr(0, 4) == "RIFF");
  BOOST_TEST(integer(4, 4) == bytes.size() - 8);
  BOOST_TEST(bytes.substr(8, 8) == "WAVEfmt ");
  BOOST_TEST(integer(16, 4) == 16);
  BOOST_TEST(integer(20, 2) == 1);      // PCM
  BOOST_TEST(integer(22, 2) == 1);      // one channel
  BOOST_TEST(integer(24, 4) == 44100);  // Hz
  BOOST_TEST(integer(28, 4) == 132300); // bytes a second
  BOOST_TEST(integer(32, 2) == 3);
  BOOST_TEST(integer(34, 2) == 24);
  const std::size_t data = bytes.find("data");
  BOOST_TEST_REQUIRE(data != std::string::npos);
  BOOST_TEST(bytes.find("INFOICMT") < data);
  BOOST_TEST(bytes.find("two Pa") < data);
  BOOST_TEST(integer(data + 4, 4) == 21);
  BOOST_TEST(bytes.size() == data + 8 + 21 + 1); // an even number
  const std::vector<std::int32_t> expected{
    0, 4194304, -4194304, 8388607, -8388608, 8388607, -8388608};
  for (std::size_t i = 0; i < expected.size(); ++i)
    BOOST_TEST(integer(data + 8 + 3 * i, 3) ==
               (static_cast<std::uint32_t>(expected[i]) & 0xffffff));
  BOOST_TEST(n_beyond(values, 2.) == 2);
  BOOST_TEST(full_scale_above({0.3, -0.7}) == 1.,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(full_scale_above({0.3}) == 0.5,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(full_scale_above({0.2}) > 0.2);
  BOOST_TEST(full_scale_above({}) == 1.);
}

BOOST_AUTO_TEST_SUITE_END()
