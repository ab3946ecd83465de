#include <boost/test/unit_test.hpp>

#include "reference_checks.h"

#include <rolling_contact/references/carter.h>
#include <rolling_contact/references/wavy_carter.h>

#include <complex>
#include <functional>
#include <limits>
#include <vector>

using namespace RollingContact;
using namespace RollingContact::References;
using boost::test_tools::tolerance;

BOOST_AUTO_TEST_SUITE(wavy_carter)

namespace
{
  using Complex = std::complex<double>;

  const double  pi = std::acos(-1.);
  const Complex imaginary(0., 1.);

  /** Steel, a = 5 mm; creepage over that from which all slides. */
  WavyLineContact wavy_contact(const double  saturation,
                               const double  z,
                               const Complex compliance,
                               const Complex tangential = 0.)
  {
    const double a = 5e-3, R = 0.46, mu = 0.3;
    return {a,
            R,
            115.4e9,
            0.1,
            mu,
            saturation * mu * a / R,
            1e-15,
            z / a,
            compliance,
            tangential};
  }

  HertzLine steady_contact(const WavyLineContact &contact)
  {
    return hertz_line_of_half_width(contact.half_width,
                                    contact.relative_radius,
                                    contact.contact_modulus);
  }

  Carter steady_rolling(const WavyLineContact &contact)
  {
    return Carter(steady_contact(contact),
                  contact.relative_radius,
                  contact.friction_coefficient,
                  contact.creepage);
  }

  /** Growth over k_w mu xi pi E*. */
  Complex scaled_growth(const WavyLineContact &contact,
                        const unsigned int     fineness = 1)
  {
    return WavyCarter(contact, fineness).growth().total() /
           (contact.wear_coefficient * contact.friction_coefficient *
            contact.creepage * pi * contact.contact_modulus);
  }

  double deviation(const Complex value, const Complex expected)
  {
    return std::abs(value - expected) / std::abs(expected);
  }

  template <typename Function>
  Complex integrate_complex(const Function &function,
                            const double    from,
                            const double    to,
                            const int       n_points = 2000)
  {
    return {integrate([&](const double x) { return function(x).real(); },
                      from,
                      to,
                      n_points),
            integrate([&](const double x) { return function(x).imag(); },
                      from,
                      to,
                      n_points)};
  }

  /**
   * A density f with inverse square roots at both ends of an interval, and its
   * integral with ln|x - s| by the midpoint rule in the angle, the singularity
   * taken off by int ln|x - s|/sqrt(w^2 - s^2) ds = pi ln(w/2).
   */
  class SampledDensity
  {
  public:
    template <typename Function>
    SampledDensity(const Function &function,
                   const double    middle,
                   const double    half_width)
      : middle(middle)
      , half_width(half_width)
      , density([=](const double x) {
        const double y = (x - middle) / half_width;
        return function(x) * half_width * std::sqrt((1 - y) * (1 + y));
      })
    {
      for (unsigned int i = 0; i < 20000; ++i)
        {
          points.push_back(middle +
                           half_width * std::cos(pi * (i + 0.5) / 20000));
          values.push_back(density(points.back()));
        }
    }

    Complex integral() const
    {
      Complex sum = 0.;
      for (const Complex value : values)
        sum += value;
      return sum * pi / double(values.size());
    }

    Complex potential(const double x) const
    {
      const bool    inside = std::abs(x - middle) < half_width;
      const Complex here   = inside ? density(x) : 0.;
      Complex       sum    = 0.;
      for (unsigned int i = 0; i < points.size(); ++i)
        sum += (values[i] - here) * std::log(std::abs(x - points[i]));
      return sum * pi / double(values.size()) +
             here * pi * std::log(half_width / 2);
    }

  private:
    double                         middle, half_width;
    std::function<Complex(double)> density;
    std::vector<double>            points;
    std::vector<Complex>           values;
  };

  /** K[q] of the half-planes. */
  Complex displacement(const SampledDensity  &density,
                       const WavyLineContact &contact,
                       const double           x)
  {
    return -2 / (pi * contact.contact_modulus) *
           (density.potential(x) -
            density.integral() * std::log(contact.reference_length));
  }
} // namespace

BOOST_AUTO_TEST_SUITE(tables)

// independent computation with Bessel functions of another library; all digits
BOOST_AUTO_TEST_CASE(growth)
{
  const Complex damped(-4e-11, 1e-11), soft(1e-11, -1e-11);
  const auto    check =
    [](const WavyLineContact &contact, const double real, const double imag) {
      BOOST_TEST(deviation(scaled_growth(contact), {real, imag}) < 1e-12);
    };
  check(wavy_contact(0.5, 0.5, 2e-11), -0.047372378800100, 0.042935540949908);
  check(wavy_contact(0.5, 0.5, damped), -0.015345111711237, -0.013269340643063);
  check(wavy_contact(0.5, 0.5, 2e-11, soft),
        -0.024880511156898,
        0.029910958585738);
  check(wavy_contact(0.9, 1, 2e-11), -0.220094211806518, 0.116619612275952);
  check(wavy_contact(2, 1, 2e-11), -0.261249503213959, 0.044161909503805);
  check(wavy_contact(2, 1, 2e-11, soft), -0.240386802862106, 0.065024609855658);
}

BOOST_AUTO_TEST_CASE(adhesion_and_flattening)
{
  const auto check = [](const double z, const double real, const double imag) {
    BOOST_TEST(deviation(creepage_wave_ratio(5e-3, 0.1, z / 5e-3),
                         {real, imag}) < 1e-13);
    double sum = 0;
    for (int n = 1; n < 60; ++n)
      sum += n * std::pow(std::cyl_bessel_j(n, z), 2);
    BOOST_TEST(wave_flattening(z) == sum, tolerance(1e-13));
  };
  check(0.1, 0.9095172395215356, -0.29081802071284474);
  check(0.5, 0.2720067104205723, -0.46491541669533404);
  check(1, 0.06727040082852483, -0.2915349556704125);
  check(2, 0.0026413517092113868, -0.1419884114299802);
  check(4, 0.004548790167421758, -0.06821941348780163);
  BOOST_TEST(wave_flattening(4) == 1.244259, tolerance(1e-6));
  BOOST_TEST(wave_flattening(0) == 0);
  BOOST_TEST(creepage_wave_ratio(5e-3, 0.1, 0).real() == 1);
  // short waves: u = K[q] is uniform, F 2 ln(2 L/a)/(pi E*) = -xi/(i k)
  BOOST_TEST(deviation(creepage_wave_ratio(1, 20, 1e5),
                       1. / (imaginary * 1e5 * std::log(40.))) < 1e-5);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(limits)

// the power |T| xi of Carter's contact under a load that changes slowly
BOOST_AUTO_TEST_CASE(long_waves)
{
  for (const double saturation : {0.3, 0.5, 0.9, 1.5})
    {
      const WavyLineContact contact = wavy_contact(saturation, 1e-4, 3e-11);
      const double          load    = steady_contact(contact).load_per_length();
      const auto            power   = [&](const double N) {
        const HertzLine hertz =
          hertz_line(N, contact.relative_radius, contact.contact_modulus);
        return -contact.creepage * contact.friction_coefficient * N *
               Carter(hertz,
                      contact.relative_radius,
                      contact.friction_coefficient,
                      contact.creepage)
                 .force_ratio();
      };
      const double derivative =
        (power(load * 1.0001) - power(load * 0.9999)) / (load * 0.0002);
      const WavyCarter wavy(contact);
      BOOST_TEST(
        deviation(wavy.growth().total(),
                  -contact.wear_coefficient * derivative * wavy.load()) < 1e-3);
      BOOST_TEST(wavy.growth().total().real() ==
                   -contact.wear_coefficient * derivative * wavy.load().real(),
                 tolerance(1e-6));
    }
}

// alpha_t = C/(i k): the creepage follows the force, xi^ = C T^
BOOST_AUTO_TEST_CASE(long_waves_with_creepage_that_follows_the_force)
{
  const double    ratio = 0.6, follow = 4e-10;
  WavyLineContact contact       = wavy_contact(ratio, 1e-4, 3e-11);
  contact.tangential_compliance = follow / (imaginary * contact.wave_number);
  const WavyCarter wavy(contact);
  const HertzLine  hertz = steady_contact(contact);
  const auto       force = [&](const double N, const double creepage) {
    return contact.friction_coefficient * N *
           Carter(hertz_line(N,
                             contact.relative_radius,
                             contact.contact_modulus),
                  contact.relative_radius,
                  contact.friction_coefficient,
                  creepage)
             .force_ratio();
  };
  const double load = hertz.load_per_length(), xi = contact.creepage;
  const double by_load = (force(load * 1.0001, xi) - force(load * 0.9999, xi)) /
                         (load * 0.0002),
               by_creepage =
                 (force(load, xi * 1.0001) - force(load, xi * 0.9999)) /
                 (xi * 0.0002);
  const double N        = wavy.load().real();
  const double T        = by_load * N / (1 - by_creepage * follow);
  const double creepage = follow * T;
  BOOST_TEST(std::abs(creepage * by_creepage) > 0.1 * std::abs(T));
  BOOST_TEST(deviation(wavy.force(), T) < 1e-3);
  BOOST_TEST(wavy.force().real() == T, tolerance(1e-6));
  const double steady = force(load, xi);
  BOOST_TEST(wavy.growth().total().real() ==
               contact.wear_coefficient * (xi * T + steady * creepage),
             tolerance(1e-6));
}

// int p^ exp(i k x), int p^ x exp(i k x), int p_0 exp(i k x) by hand
BOOST_AUTO_TEST_CASE(full_slip)
{
  for (const double z : {0.01, 0.3, 1., 5., 40.})
    {
      const WavyLineContact contact =
        wavy_contact(1.7, z, {2e-11, -3e-12}, {1e-11, -1e-11});
      const double a = contact.half_width, mu = contact.friction_coefficient,
                   E = contact.contact_modulus, k = contact.wave_number;
      const double  J0 = std::cyl_bessel_j(0, z), J1 = std::cyl_bessel_j(1, z);
      const Complex N =
        J0 / (2 / (pi * E) * std::log(40.) + contact.normal_compliance);
      const double S     = z / 2 * (z * (J0 * J0 + J1 * J1) - J0 * J1);
      const double slope = z * (J0 * J0 + J1 * J1) / 2; // dS/dz
      const double steady =
        steady_contact(contact).load_per_length() * 2 * J1 / z;
      const Complex slip =
        imaginary * k * mu *
        (contact.normal_compliance - contact.tangential_compliance) * N *
        steady;
      const Complex pressure = contact.creepage * (pi * E * S + N * J0) +
                               mu / contact.relative_radius * imaginary * a *
                                 (N * J1 - pi * E * slope / 2);
      const double     wear = -contact.wear_coefficient * mu;
      const WavyCarter wavy(contact);
      BOOST_TEST(deviation(wavy.growth().slip, wear * slip) < 1e-12);
      BOOST_TEST(deviation(wavy.growth().pressure, wear * pressure) < 1e-12);
      BOOST_TEST(deviation(wavy.load(), N) < 1e-12);
      BOOST_TEST(deviation(wavy.force(), -mu * N) < 1e-12);
      BOOST_TEST(wavy.stick_half_width() == 0);
    }
}

BOOST_AUTO_TEST_CASE(derivative_by_creepage_where_all_slides)
{
  const auto contact = [](const double saturation) {
    return wavy_contact(saturation, 0.8, 2e-11, {1e-11, -1e-11});
  };
  const Complex rise = WavyCarter(contact(3)).growth().total() -
                       WavyCarter(contact(1.5)).growth().total();
  const Complex derivative = sliding_growth_per_creepage(contact(2));
  BOOST_TEST(deviation(rise / contact(1.5).creepage, derivative) < 1e-12);
  BOOST_TEST(
    deviation(WavyCarter(contact(1e6)).growth().total() / contact(1e6).creepage,
              derivative) < 1e-5);
}

// G is smooth on both sides, so what differs falls with the distance
BOOST_AUTO_TEST_CASE(continuous_where_all_slides)
{
  for (const double distance : {1e-3, 1e-5, 1e-7, 1e-9, 1e-12})
    {
      const auto growth = [&](const double saturation) {
        return scaled_growth(
          wavy_contact(saturation, 1, 2e-11, {1e-11, -1e-11}));
      };
      BOOST_TEST(deviation(growth(1 - distance), growth(1 + distance)) <
                 5 * distance + 1e-13);
    }
  const WavyCarter partial(wavy_contact(1 - 1e-9, 1, 2e-11)),
    full(wavy_contact(1 + 1e-9, 1, 2e-11));
  BOOST_TEST(deviation(partial.force(), full.force()) < 1e-8);
}

BOOST_AUTO_TEST_CASE(stiff_along_the_rail)
{
  for (const double saturation : {0.2, 0.7, 1.3})
    {
      const auto growth = [&](const Complex tangential) {
        return WavyCarter(wavy_contact(saturation, 1, 2e-11, tangential))
          .growth();
      };
      const Complex direction(1, -2);
      const auto    change = [&](const double size) {
        return (growth(size * direction).total() - growth(0.).total()) / size;
      };
      BOOST_TEST(deviation(change(1e-15), change(1e-16)) < 1e-3);
      BOOST_TEST(std::abs(change(1e-15)) * 1e-11 >
                 0.01 * std::abs(growth(0.).total()));
      if (saturation < 1)
        continue;
      // all slides: k_w mu^2 i k alpha_t N^ int p_0 exp(i k x) dx
      const WavyLineContact contact = wavy_contact(saturation, 1, 2e-11);
      const Complex expected = contact.wear_coefficient * 0.09 * imaginary *
                               contact.wave_number * direction *
                               WavyCarter(contact).load() *
                               steady_contact(contact).load_per_length() * 2. *
                               std::cyl_bessel_j(1, 1.);
      BOOST_TEST(deviation(change(1e-11), expected) < 1e-12);
    }
}

// relative to the parts, which nearly cancel in a small slip zone
BOOST_AUTO_TEST_CASE(terms_and_points_suffice)
{
  for (const double saturation :
       {1e-6, 0.05, 0.5, 0.9, 0.999, 0.99999, 1 - 1e-8, 2.})
    for (const double z : {1e-3, 0.5, 3., 20., 100., 900.})
      {
        const WavyLineContact contact =
          wavy_contact(saturation, z, {2e-11, -1e-12}, {1e-11, -1e-11});
        const PassageGrowth growth = WavyCarter(contact).growth(),
                            finer  = WavyCarter(contact, 3).growth();
        const double size = std::abs(growth.slip) + std::abs(growth.pressure);
        BOOST_TEST(std::abs(finer.slip - growth.slip) < 1e-13 * size);
        BOOST_TEST(std::abs(finer.pressure - growth.pressure) < 1e-13 * size);
      }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(equations)

BOOST_AUTO_TEST_CASE(pressure_fits_the_wave)
{
  for (const double z : {0.2, 1.5, 6.})
    {
      const WavyLineContact contact = wavy_contact(0.4, z, {-3e-11, 1e-11});
      const WavyCarter      wavy(contact);
      const SampledDensity  pressure(
        [&](const double x) { return wavy.pressure(x); },
        0,
        contact.half_width);
      BOOST_TEST(deviation(pressure.integral(), wavy.load()) < 1e-9);
      for (const double y : {-0.95, -0.41, 0.003, 0.7})
        {
          const double  x    = y * contact.half_width;
          const Complex wave = displacement(pressure, contact, x) +
                               contact.normal_compliance * wavy.load();
          BOOST_TEST(deviation(wave, std::polar(1., -contact.wave_number * x)) <
                     1e-7);
        }
      const Complex flattened = integrate_complex(
        [&](const double x) {
          return wavy.pressure(x) * std::polar(1., contact.wave_number * x);
        },
        -contact.half_width,
        contact.half_width);
      BOOST_TEST(deviation(flattened,
                           pi * contact.contact_modulus * wave_flattening(z) +
                             wavy.load() * std::cyl_bessel_j(0, z)) < 1e-9);
    }
}

// slip is (d/dx + i k) (K[q^] + alpha_t T^): none in the stick zone, s^ beyond;
// q^ = -mu p^ where it slips; the leading edge moves with traction and pressure
BOOST_AUTO_TEST_CASE(traction_sticks_and_slips)
{
  for (const double saturation : {0.3, 0.8})
    for (const double z : {0.3, 2.})
      {
        const WavyLineContact contact =
          wavy_contact(saturation, z, {2e-11, -4e-12}, {1e-11, -2e-11});
        const WavyCarter wavy(contact);
        const double a = contact.half_width, mu = contact.friction_coefficient;
        const double stick = wavy.stick_half_width(), end = 2 * stick - a;
        BOOST_TEST(stick == steady_rolling(contact).stick_half_width(),
                   tolerance(1e-13));

        const SampledDensity pressure(
          [&](const double x) { return wavy.pressure(x); }, 0, a);
        const SampledDensity stuck(
          [&](const double x) {
            return wavy.traction(x) + mu * wavy.pressure(x);
          },
          stick - a,
          stick);
        BOOST_TEST(deviation(stuck.integral() - mu * pressure.integral(),
                             wavy.force()) < 1e-9);

        const auto moved = [&](const double x) {
          return std::polar(1., contact.wave_number * x) *
                 (displacement(stuck, contact, x) -
                  mu * displacement(pressure, contact, x) +
                  contact.tangential_compliance * wavy.force());
        };
        const Complex carried = moved(-a + 0.3 * stick);
        for (const double y : {0.01, 1., 1.95})
          BOOST_TEST(deviation(moved(-a + y * stick), carried) < 1e-7);
        for (const double part : {0.1, 0.5, 0.9})
          {
            const double  x       = end + part * (a - end);
            const Complex slipped = integrate_complex(
              [&](const double x) {
                return wavy.slip(x) * std::polar(1., contact.wave_number * x);
              },
              end,
              x);
            BOOST_TEST(deviation(moved(x) - carried, slipped) < 2e-7);
            BOOST_TEST(deviation(wavy.traction(x), -mu * wavy.pressure(x)) <
                       1e-14);
          }

        const double near = -a * (1 - 1e-7);
        BOOST_TEST(deviation(wavy.traction(near) / wavy.pressure(near),
                             steady_rolling(contact).traction(near) /
                               steady_contact(contact).pressure(near)) < 1e-6);
        BOOST_TEST(std::abs(wavy.slip(end - 1e-6)) == 0);
        BOOST_TEST(std::abs(wavy.slip(a + 1e-6)) == 0);
        BOOST_TEST(std::abs(wavy.pressure(-a)) == 0);
      }
}

BOOST_AUTO_TEST_CASE(growth_is_lost_power_on_the_material)
{
  for (const double saturation : {0.3, 0.8, 1.4})
    {
      const WavyLineContact contact =
        wavy_contact(saturation, 1.2, {2e-11, -4e-12}, {1e-11, -2e-11});
      const WavyCarter wavy(contact);
      const Carter     rolling = steady_rolling(contact);
      const auto       part    = [&](const auto &power) {
        return contact.wear_coefficient *
               integrate_complex(
                 [&](const double x) {
                   return power(x) * std::polar(1., contact.wave_number * x);
                 },
                 2 * wavy.stick_half_width() - contact.half_width,
                 contact.half_width);
      };
      const Complex slip = part(
        [&](const double x) { return rolling.traction(x) * wavy.slip(x); });
      const Complex pressure = part(
        [&](const double x) { return wavy.traction(x) * rolling.slip(x); });
      BOOST_TEST(deviation(wavy.growth().slip, slip) < 1e-11);
      BOOST_TEST(deviation(wavy.growth().pressure, pressure) < 1e-11);
      BOOST_TEST(deviation(wavy.growth().total(), slip + pressure) < 1e-11);
    }
}

// dT^/d(alpha_t T^) is the answer of the stick zone to a creepage wave
BOOST_AUTO_TEST_CASE(stick_zone_under_a_creepage_wave)
{
  for (const double z : {0.1, 1., 4.})
    {
      const Complex         alpha(1e-11, -2e-11);
      const WavyLineContact contact = wavy_contact(0.4, z, 2e-11, alpha);
      const WavyCarter      wavy(contact), stiff(wavy_contact(0.4, z, 2e-11));
      const Complex         answer =
        (wavy.force() - stiff.force()) / (alpha * wavy.force());
      const double  stick = wavy.stick_half_width(), k = contact.wave_number;
      const Complex creepage = imaginary * k;
      BOOST_TEST(deviation(answer,
                           -pi * stick * contact.contact_modulus / 2 *
                             creepage * creepage_wave_ratio(stick, 0.1, k)) <
                 1e-11);
    }
}

BOOST_AUTO_TEST_CASE(no_units)
{
  const double    length = 3, stiffness = 0.2, alpha = 2e-11;
  WavyLineContact contact =
    wavy_contact(0.6, 1.3, {alpha, -alpha}, {alpha, -2 * alpha});
  const Complex growth = WavyCarter(contact).growth().total();
  contact.half_width *= length;
  contact.relative_radius *= length;
  contact.reference_length *= length;
  contact.wave_number /= length;
  contact.contact_modulus *= stiffness;
  contact.normal_compliance /= stiffness;
  contact.tangential_compliance /= stiffness;
  contact.wear_coefficient /= stiffness;
  BOOST_TEST(deviation(WavyCarter(contact).growth().total(), growth) < 1e-12);
  contact.wear_coefficient = 0;
  BOOST_TEST(std::abs(WavyCarter(contact).growth().total()) == 0);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_CASE(bad_input)
{
  const auto with = [](const auto &change) {
    WavyLineContact contact = wavy_contact(0.5, 1, 2e-11);
    change(contact);
    return WavyCarter(contact).growth().total();
  };
  using Contact         = WavyLineContact;
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK_INPUT_ERROR(with([](Contact &c) { c.half_width = 0; }),
                    "Half-width is 0 m");
  CHECK_INPUT_ERROR(with([](Contact &c) { c.relative_radius = -1; }),
                    "Relative radius is -1 m");
  CHECK_INPUT_ERROR(with([](Contact &c) { c.contact_modulus = 0; }),
                    "Contact modulus is 0 Pa");
  CHECK_INPUT_ERROR(with([](Contact &c) { c.reference_length = 2.5e-3; }),
                    "Reference length is 0.0025 m");
  CHECK_INPUT_ERROR(with([](Contact &c) { c.friction_coefficient = 0; }),
                    "Friction coefficient is 0");
  CHECK_INPUT_ERROR(with([](Contact &c) { c.creepage = 0; }), "Creepage is 0");
  CHECK_INPUT_ERROR(with([](Contact &c) { c.creepage = -1e-3; }),
                    "Creepage is -0.001");
  CHECK_INPUT_ERROR(with([](Contact &c) { c.wear_coefficient = -1; }),
                    "Wear coefficient is -1 m^3/J");
  CHECK_INPUT_ERROR(with([](Contact &c) { c.wave_number = 0; }),
                    "Wave number is 0 1/m");
  CHECK_INPUT_ERROR(with([](Contact &c) { c.wave_number = 3e5; }),
                    "at most 1000 over the half-width of the patch.");
  CHECK_INPUT_ERROR(with([&](Contact &c) { c.normal_compliance = infinity; }),
                    "Real part of the normal compliance is inf m^2/N");
  CHECK_INPUT_ERROR(with([&](Contact &c) {
                      c.tangential_compliance = {0, infinity};
                    }),
                    "Imaginary part of the tangential compliance is inf m^2/N");
  CHECK_INPUT_ERROR(WavyCarter(wavy_contact(0.5, 1, 2e-11), 0),
                    "Fineness is 0");
  const double contact_compliance =
    2 / (pi * 115.4e9) * std::log(2 * 0.1 / 5e-3);
  CHECK_INPUT_ERROR(load_per_wave(5e-3, 115.4e9, 0.1, 100, -contact_compliance),
                    "Normal compliance cancels that of the contact");
  CHECK_INPUT_ERROR(load_per_wave(5e-3, 115.4e9, 0.1, 0, 0.),
                    "Wave number is 0 1/m");
  CHECK_INPUT_ERROR(creepage_wave_ratio(5e-3, 1e-3, 100),
                    "Reference length is 0.001 m: it must be larger than half "
                    "the half-width of the patch.");
  CHECK_INPUT_ERROR(creepage_wave_ratio(5e-3, 0.1, -1),
                    "Wave number is -1 1/m");
  CHECK_INPUT_ERROR(wave_flattening(-1), "Half-width times wave number is -1");
  CHECK_INPUT_ERROR(sliding_growth_per_creepage(wavy_contact(0, 1, 2e-11)),
                    "Creepage is 0");
}

BOOST_AUTO_TEST_SUITE_END()
