#include <boost/test/unit_test.hpp>

#include <rolling_contact/algebra/fourier.h>
#include <rolling_contact/algebra/low_pass.h>
#include <rolling_contact/algebra/third_octaves.h>
#include <rolling_contact/base/constants.h>

#include <cmath>
#include <numeric>
#include <random>

using namespace RollingContact;
using namespace RollingContact::Signals;

BOOST_AUTO_TEST_SUITE(signals)

namespace
{
  std::vector<double> tone(const std::size_t n,
                           const double      step,
                           const double      frequency,
                           const double      amplitude)
  {
    std::vector<double> values(n);
    for (std::size_t j = 0; j < n; ++j)
      values[j] = amplitude * std::cos(2 * pi * frequency * step * j + 0.7);
    return values;
  }

  double mean_square(const PowerSpectrum &spectrum)
  {
    return spectrum.step * std::accumulate(spectrum.density.begin(),
                                           spectrum.density.end(),
                                           0.);
  }
} // namespace

/** FFTW's sums against their definition, and back. */
BOOST_AUTO_TEST_CASE(transforms_are_what_they_say)
{
  std::mt19937                           random(4);
  std::uniform_real_distribution<double> one(-1., 1.);
  for (const std::size_t n : {9, 16})
    {
      std::vector<double> values(n);
      for (double &value : values)
        value = one(random);
      const auto sums = fourier_sums(values);
      BOOST_TEST(sums.size() == n / 2 + 1);
      for (std::size_t k = 0; k < sums.size(); ++k)
        {
          std::complex<double> sum;
          for (std::size_t j = 0; j < n; ++j)
            sum += values[j] *
                   std::polar(1., -2 * pi * static_cast<double>(j * k) / n);
          BOOST_TEST(std::abs(sum - sums[k]) < 1e-13);
        }
      const auto back = values_of_fourier_sums(sums, n);
      for (std::size_t j = 0; j < n; ++j)
        BOOST_TEST(std::abs(back[j] - values[j]) < 1e-14);
    }
}

/** Each wave by its factor, of values that come again and of mirror images,
 * along and across. */
BOOST_AUTO_TEST_CASE(waves_on_a_grid_are_scaled)
{
  const auto factor = [](const double k, const double l) {
    return 2 - 3 * k + 7 * l * l;
  };
  for (const bool again_x : {false, true})
    for (const bool again_y : {false, true})
      for (const auto &[n_x, n_y] : {std::pair(8, 5), {9, 6}, {7, 1}})
        {
          const GridDirection x{static_cast<std::size_t>(n_x), 0.1, again_x},
            y{static_cast<std::size_t>(n_y), 0.3, again_y};
          // k waves in the length from which on values repeat
          const auto waves = [](const GridDirection &it, const int k) {
            const double period = it.again || it.n == 1 ? it.n : 2. * it.n - 2;
            return k / period;
          };
          std::vector<double> values(n_x * n_y, 0.), scaled(n_x * n_y, 0.);
          for (int k = 0; k < 4; ++k)
            for (int l = 0; l < (n_y == 1 ? 1 : 3); ++l)
              for (int j = 0; j < n_y; ++j)
                for (int i = 0; i < n_x; ++i)
                  {
                    const double of_x = waves(x, k), of_y = waves(y, l),
                                 shift  = again_x ? 0.4 : 0.;
                    const double height = (1. + k - 2 * l) *
                                          std::cos(2 * pi * of_x * i + shift) *
                                          std::cos(2 * pi * of_y * j);
                    values[j * n_x + i] += height;
                    scaled[j * n_x + i] +=
                      factor(of_x / 0.1, of_y / 0.3) * height;
                  }
          scale_waves(values, x, y, factor);
          for (std::size_t k = 0; k < values.size(); ++k)
            BOOST_TEST(std::abs(values[k] - scaled[k]) < 1e-12);
        }
}

/** Against the sums over the matrix, on grids that are not square, and from
 * either component to both. */
BOOST_AUTO_TEST_CASE(grid_convolution_multiplies_as_its_matrix_does)
{
  const auto entry = [](const int          along,
                        const int          across,
                        const unsigned int of,
                        const unsigned int by) {
    return (of == by ? 1. + of : 0.3 * along - 0.1 * of) /
           (1 + along * along + 3 * std::abs(across));
  };
  for (const auto &[n_x, n_y] : {std::pair(5, 3), {4, 7}, {1, 2}})
    {
      const int             n = n_x * n_y;
      const GridConvolution matrix(n_x, n_y, 2, entry);
      std::vector<double>   values;
      for (int k = 0; k < 2 * n; ++k)
        values.push_back(std::sin(k) + (k == 0 ? 4. : 0.));
      const auto product = matrix.multiply(values, 0, 0, 2),
                 of_last =
                   matrix.multiply({values.begin() + n, values.end()}, 1, 0, 1);
      BOOST_TEST_REQUIRE(product.size() == 2u * n);
      BOOST_TEST_REQUIRE(of_last.size() == 1u * n);
      for (int i = 0; i < 2 * n; ++i)
        {
          double sums[2] = {0., 0.};
          for (int k = 0; k < 2 * n; ++k)
            sums[k / n] += entry(i % n % n_x - k % n % n_x,
                                 i % n / n_x - k % n / n_x,
                                 i / n,
                                 k / n) *
                           values[k];
          BOOST_TEST(std::abs(product[i] - sums[0] - sums[1]) < 1e-14);
          if (i < n)
            BOOST_TEST(std::abs(of_last[i] - sums[1]) < 1e-14);
        }
    }
}

/** A product that is far from the border of a grid comes from about what it is
 * divided into. */
BOOST_AUTO_TEST_CASE(grid_convolution_divides_about_right)
{
  const int             n = 24;
  const GridConvolution matrix(n, n, 1, [](const int i, const int j, int, int) {
    return 1. / std::hypot(1., i, j);
  });
  std::vector<double>   values(n * n);
  for (int k = 0; k < n * n; ++k)
    values[k] =
      std::exp(-0.1 * (std::pow(k % n - 11, 2) + std::pow(k / n - 12, 2)));
  const auto back = matrix.divide(matrix.multiply(values), 0);
  BOOST_TEST(std::abs(back[12 * n + 11] - 1.) < 0.05);
}

/** Long waves pass unshifted, short ones go, in between the gain is said. */
BOOST_AUTO_TEST_CASE(low_pass_has_its_gain_and_no_phase)
{
  const std::size_t n       = 240;
  const double      spacing = 1e-3;
  const CutOff      cut_off{0.012, 0.006};
  BOOST_TEST(cut_off.gain(0.) == 1.);
  BOOST_TEST(cut_off.gain(1 / 0.008) == 0.5,
             boost::test_tools::tolerance(1e-12));
  for (const double wavelength : {0.02, 0.012, 0.008, 0.006, 0.004})
    {
      const auto wave = tone(n, spacing, 1 / wavelength, 2e-6);
      const auto left = low_pass(wave, {n, spacing, true}, {}, cut_off);
      for (std::size_t j = 0; j < n; ++j)
        BOOST_TEST(std::abs(left[j] - cut_off.gain(1 / wavelength) * wave[j]) <
                   1e-18);
    }
  // a constant stays, mirror images leave no jump
  const auto constant =
    low_pass(std::vector<double>(50, 3.), {50, spacing}, {}, cut_off);
  for (const double value : constant)
    BOOST_TEST(value == 3., boost::test_tools::tolerance(1e-13));
  // half waves that begin and end on a crest, each alone by its gain
  for (const unsigned int k : {10, 17, 27, 31, 40})
    {
      std::vector<double> wave(100);
      for (std::size_t j = 0; j < wave.size(); ++j)
        wave[j] = 2e-6 * std::cos(pi * k * j / 99);
      const auto left = low_pass(wave, {100, spacing}, {}, cut_off);
      for (std::size_t j = 0; j < wave.size(); ++j)
        BOOST_TEST(std::abs(left[j] - cut_off.gain(k / (2 * 99 * spacing)) *
                                        wave[j]) < 1e-18);
    }
  std::vector<double> ramp(200);
  std::iota(ramp.begin(), ramp.end(), 0.);
  const auto smooth = low_pass(ramp, {200, spacing}, {}, cut_off);
  for (std::size_t j = 20; j < 180; ++j)
    BOOST_TEST(std::abs(smooth[j] - ramp[j]) < 0.02);
}

/** Parseval: the density sums up to the variance. */
BOOST_AUTO_TEST_CASE(densities_sum_up_to_the_variance)
{
  std::mt19937               random(11);
  std::normal_distribution<> normal(3., 2.);
  const double               step = 1e-3;
  // one segment: the mean square under the window, exactly
  std::vector<double> values;
  for (const std::size_t n : {1001, 1000, 6})
    {
      values.resize(n);
      for (double &value : values)
        value = normal(random);
      const double mean = std::accumulate(values.begin(), values.end(), 0.) / n;
      double       under_window = 0., squares = 0.;
      for (std::size_t j = 0; j < n; ++j)
        {
          const double window =
            std::pow(std::sin(pi * static_cast<double>(j) / n), 2);
          under_window += std::pow(window * (values[j] - mean), 2);
          squares += window * window;
        }
      BOOST_TEST(mean_square(welch(values, step, n)) == under_window / squares,
                 boost::test_tools::tolerance(1e-12));
    }
  // many: that of the process, sigma^2 = 4, to 3 standard deviations
  values.resize(100'000);
  for (double &value : values)
    value = normal(random);
  const PowerSpectrum noise = welch(values, step, 1000);
  BOOST_TEST(noise.n_segments == 199);
  BOOST_TEST(noise.step == 1., boost::test_tools::tolerance(1e-12));
  BOOST_TEST(mean_square(noise) == 4., boost::test_tools::tolerance(0.015));
  BOOST_TEST(noise.density[200] > 0.5 * 4. / 500);
  BOOST_TEST(noise.density[200] < 2 * 4. / 500);
}

/** A tone of amplitude A on a line has A^2/2, in its third octave alone. */
BOOST_AUTO_TEST_CASE(a_tone_is_in_its_third_octave)
{
  const double step = 1e-4, amplitude = 3.;
  for (const std::size_t segment : {1000, 2000})
    {
      const PowerSpectrum spectrum =
        welch(tone(4000, step, 1000., amplitude), step, segment);
      BOOST_TEST(mean_square(spectrum) == amplitude * amplitude / 2,
                 boost::test_tools::tolerance(1e-12));
      const auto bands  = third_octaves(spectrum);
      double     others = 0.;
      bool       found  = false;
      for (const ThirdOctave &band : bands)
        if (std::abs(band.centre - 1000.) < 1e-6)
          {
            found = true;
            BOOST_TEST(*band.mean_square == amplitude * amplitude / 2,
                       boost::test_tools::tolerance(1e-12));
            BOOST_TEST(level(*band.mean_square, 1e-3) ==
                         20 * std::log10(amplitude / std::sqrt(2.) / 1e-3),
                       boost::test_tools::tolerance(1e-12));
          }
        else
          others += band.mean_square.value_or(0.);
      BOOST_TEST(found);
      BOOST_TEST(others < 1e-12);
    }
}

/** Bands lie edge to edge; those of fewer than four lines are left empty. */
BOOST_AUTO_TEST_CASE(bands_without_lines_are_not_invented)
{
  PowerSpectrum flat;
  flat.step = 10.;
  flat.density.assign(501, 2.); // to 5000 Hz
  const auto bands = third_octaves(flat);
  BOOST_TEST(bands.back().centre == std::pow(10., 3.6),
             boost::test_tools::tolerance(1e-12));
  for (std::size_t k = 0; k < bands.size(); ++k)
    {
      const double width = bands[k].upper_edge() - bands[k].lower_edge();
      BOOST_TEST(bands[k].mean_square.has_value() == (width >= 40.));
      if (bands[k].mean_square)
        BOOST_TEST(*bands[k].mean_square == 2. * width,
                   boost::test_tools::tolerance(1e-12));
      if (k > 0)
        BOOST_TEST(bands[k].lower_edge() == bands[k - 1].upper_edge(),
                   boost::test_tools::tolerance(1e-12));
    }
}

BOOST_AUTO_TEST_SUITE_END()
