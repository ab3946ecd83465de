#include <boost/test/unit_test.hpp>

#include "complaint.h"

#include <rolling_contact/algebra/adaptive_integral.h>
#include <rolling_contact/analyses/rolling_noise_report.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/stability/passing_waves.h>
#include <rolling_contact/surfaces/roughness_levels.h>
#include <rolling_contact/time/modal_sound.h>
#include <rolling_contact/time/sound_pressure.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>

using namespace RollingContact;

/** Roughness, its filter, and the sound of what it excites. */
BOOST_AUTO_TEST_SUITE(rolling_noise)

namespace
{
  const double band = std::log(10.) / 10; ///< of a third octave

  /** A file of the system's folder for temporary files, gone at the end. */
  struct File
  {
    File(const std::string &name, const std::string &text)
      : folder(std::filesystem::temp_directory_path())
      , name(name)
    {
      std::ofstream(folder / name) << text;
    }

    ~File()
    {
      std::filesystem::remove(folder / name);
    }

    RoughnessLevels levels() const
    {
      return roughness_levels("Rail roughness", name, folder);
    }

    std::filesystem::path folder;
    std::string           name;
  };
} // namespace

BOOST_AUTO_TEST_CASE(waves_across_cohere_as_they_are_asked_to)
{
  const std::vector<double> x{0., 1e-3, 2e-3, 0.5e-3, 1.5e-3},
    y{-3e-3, -3e-3, 1e-3, 1e-3, 2e-3};
  const double k = 400.;
  for (const double c : {0., 0.3, 1., 4.})
    {
      const ComplexMatrix b      = random_waves(x, y, k, c);
      const ComplexMatrix spread = b * b.adjoint();
      BOOST_TEST(b.cols() == (c > 0. ? 3 : 1));
      for (std::size_t i = 0; i < x.size(); ++i)
        for (std::size_t j = 0; j < x.size(); ++j)
          BOOST_TEST(
            std::abs(spread(i, j) -
                     std::polar(std::exp(-c * k * std::abs(y[i] - y[j])),
                                -k * (x[i] - x[j]))) < 1e-14);
    }
}

BOOST_AUTO_TEST_CASE(sharp_resonances_are_integrated)
{
  // int dx / (x^2 + d^2) = (atan(b/d) - atan(a/d)) / d
  const double d   = 1e-5;
  const auto   all = adaptive_integral(
    [&](const double x) {
      return Eigen::ArrayXd(
        Eigen::Array3d(1 / (x * x + d * d), std::exp(x), 1.));
    },
    -0.1,
    0.13,
    2,
    1e-4);
  BOOST_TEST(all.converged);
  const double exact = (std::atan(0.13 / d) - std::atan(-0.1 / d)) / d;
  BOOST_TEST(std::abs(all.value[0] / exact - 1) < 1e-4);
  BOOST_TEST(std::abs(all.value[1] / (std::exp(0.13) - std::exp(-0.1)) - 1) <
             1e-12);
  BOOST_TEST(std::abs(all.value[2] - 0.23) < 1e-14);
  BOOST_TEST((all.error[0] <= 1e-4 * all.value[0]));
  const auto coarse = adaptive_integral(
    [&](const double x) {
      return Eigen::ArrayXd(Eigen::ArrayXd::Constant(1, 1 / (x * x + d * d)));
    },
    -0.1,
    0.13,
    1,
    1e-4,
    2,
    4);
  BOOST_TEST(!coarse.converged);
}

BOOST_AUTO_TEST_CASE(modes_radiate_together_what_they_do_alone_and_by_pairs)
{
  using Complex = std::complex<double>;
  Sound::RadiatingPart part;
  part.modes   = {0, 2};
  part.surface = DenseMatrix(2, 2);
  part.surface << 3., 1., 1., 5.;
  part.efficiency = [](const double f) { return f / 1000; };
  const Sound::RadiatingBody body{{1., 2., 3.}, {part}};
  Eigen::MatrixXcd           v(3, 2);
  v << Complex(1., 2.), Complex(0., 1.), 7., 8., Complex(0., -1.), 2.;
  // 3 |v_1|^2 + 5 |v_3|^2 + 2 Re v_1^* v_3 of both columns
  const double     alike = 3 * 5 + 5 * 1 + 2 * (-2.), other = 3 * 1 + 5 * 4 + 0;
  const Sound::Air air{1.2, 343.};
  BOOST_TEST(Sound::radiated_power(body, v, 500., air) ==
               1.2 * 343 * 0.5 * (alike + other),
             boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(the_limit_of_rails_has_its_levels)
{
  const auto limit = roughness_levels("Rail roughness", iso_3095_limit, "");
  BOOST_TEST(limit.level(0.1) == 4.9, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(limit.level(0.4) == 17.1, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(limit.level(0.00315) == -11., boost::test_tools::tolerance(1e-12));
  BOOST_TEST(limit.level(0.02) == -6.2, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(limit.shortest() == 0.00315 * std::pow(10., -0.05),
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(limit.longest() == 0.4 * std::pow(10., 0.05),
             boost::test_tools::tolerance(1e-12));
  // a whole third octave of the same density has the level
  BOOST_TEST(limit.density(0.1) * band == 1e-12 * std::pow(10., 0.49),
             boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(levels_are_read_from_files)
{
  const File file("roughness_levels.csv",
                  "# of a grinding train\nlevel_dB,wavelength_m\n2,0.01\n"
                  "8,0.04\n");
  BOOST_TEST(file.levels().level(0.02) == 5.,
             boost::test_tools::tolerance(1e-12));
  for (const auto &[text, tells] :
       {std::pair("wavelength_m,height\n1,2\n", "no column level_dB"),
        std::pair("wavelength_m,level_dB\n0.1,2\n", "two or more"),
        std::pair("wavelength_m,level_dB\n0.1,2\n0.1,3\n", "twice"),
        std::pair("wavelength_m,level_dB\n0.1,2\n-0.1,3\n", "above 0"),
        std::pair("wavelength_m,level_dB\n0.1,2\n0.2,x\n", "3")})
    {
      const File        bad("roughness_levels.csv", text);
      const std::string said = complaint([&]() { bad.levels(); });
      BOOST_TEST(said.find("Rail roughness") != std::string::npos);
      BOOST_TEST(said.find(tells) != std::string::npos, text << ": " << said);
    }
  BOOST_TEST(complaint([]() {
               roughness_levels("Rail roughness", "ground.sdf", "");
             }).find("give `middle line: ground.sdf`") != std::string::npos);
  BOOST_TEST(complaint([]() {
               roughness_levels("Rail roughness", "rough", "");
             }).find(iso_3095_limit) != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_record_has_the_levels_of_its_waves)
{
  // waves of 1 um (rms) in the middle of the third octave of 0.1 m, and of
  // 0.1 um in that of 20 mm
  std::ostringstream text;
  text << "position_m,height_m\n" << std::setprecision(12);
  for (int i = 0; i < 20000; ++i)
    {
      const double x = 1e-3 * i;
      text << x << ','
           << std::sqrt(2.) * (1e-6 * std::sin(2 * pi * x / 0.1) +
                               1e-7 * std::sin(2 * pi * x / 0.02))
           << '\n';
    }
  const auto levels = File("roughness_record.csv", text.str()).levels();
  BOOST_TEST(std::abs(levels.level(0.1)) < 0.01);
  // 10^(17/10) waves in a metre: the centre of the band
  BOOST_TEST(std::abs(levels.level(std::pow(10., -1.7)) + 20) < 0.05);
  BOOST_TEST(levels.level(0.05) < -60);
  std::string few = "position_m,height_m\n";
  for (int i = 0; i < 12; ++i)
    few += std::to_string(i) + ",0.00000" + std::to_string(i % 3) + "\n";
  const std::string said =
    complaint([&]() { File("roughness_record.csv", few).levels(); });
  BOOST_TEST(said.find("longer") != std::string::npos, said);
}

BOOST_AUTO_TEST_CASE(the_filter_of_the_directive_has_its_tables)
{
  BOOST_TEST(directive_contact_filter(50e3, 0.02) == -8.,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(directive_contact_filter(25e3, 0.0025) == -24.2,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(directive_contact_filter(100e3, 0.0315) == -5.4,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(directive_contact_filter(50e3, 1.) == 0.);
  // the middle of the logarithms of 25 and 50 kN
  BOOST_TEST(directive_contact_filter(25e3 * std::sqrt(2.), 0.02) ==
               (-5.3 - 8.) / 2,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(complaint([]() {
               directive_contact_filter(120e3, 0.02);
             }).find("25 to 100 kN") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(places_between_sleepers_are_averaged_by_their_powers)
{
  std::vector<NoiseOfSpeed> places(2);
  for (std::size_t k = 0; k < 2; ++k)
    {
      NoiseOfSpeed &place = places[k];
      place.uncertainty   = 0.5 + k;
      place.bands.resize(2);
      place.bands[0].powers.values.setConstant(k == 0 ? 3e-6 : 1e-6);
      place.bands[1].powers.values.setConstant(k == 0 ? 7e-6 : 1e-6);
    }
  const NoiseOfSpeed mean = mean_of_places(places);
  BOOST_TEST(mean.bands[0].powers[NoisePowers::load] == 2e-6,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(mean.bands[1].powers[NoisePowers::weighted_rail] == 4e-6,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(*mean.uncertainty == 1.5);
  BOOST_TEST(*mean.range == 10 * std::log10(5.),
             boost::test_tools::tolerance(1e-12));
  places[0].uncertainty.reset();
  BOOST_TEST(!mean_of_places(places).uncertainty);
  BOOST_TEST(!mean_of_places({places[1]}).range);
  BOOST_TEST(*mean_of_places({places[1]}).uncertainty == 1.5);
}

BOOST_AUTO_TEST_CASE(the_slope_is_that_of_levels_over_speed)
{
  std::vector<NoiseOfSpeed> speeds;
  BOOST_TEST(!slope_of(speeds).has_value());
  for (const double speed : {10., 20., 40.})
    {
      NoiseOfSpeed it;
      it.speed = speed;
      it.bands.resize(2);
      it.bands[0].powers.values[NoisePowers::weighted_wheel] =
        1e-9 * std::pow(speed, 3.);
      it.bands[1].powers.values[NoisePowers::weighted_rail] =
        2e-9 * std::pow(speed, 3.);
      speeds.push_back(it);
      BOOST_TEST(slope_of(speeds).has_value() == (speeds.size() > 1));
    }
  BOOST_TEST(*slope_of(speeds) == 30., boost::test_tools::tolerance(1e-12));
  BOOST_TEST(Sound::power_level(speeds[0].sum().weighted()) ==
               10 * std::log10(3e-6 / 1e-12),
             boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_SUITE_END()
