#include <boost/math/special_functions/bessel.hpp>

#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/references/checks.h>
#include <rolling_contact/references/hertz_line.h>
#include <rolling_contact/references/wavy_carter.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace RollingContact::References
{
  namespace
  {
    using Amplitude = std::complex<double>;

    const Amplitude imaginary_unit(0., 1.);

    double bessel_j(const int n, const double z)
    {
      return boost::math::cyl_bessel_j(n, z);
    }

    /**
     * J_0 + i J_1.
     */
    Amplitude first_two_bessels(const double z)
    {
      return {bessel_j(0, z), bessel_j(1, z)};
    }

    void check_reference_length(const double half_width,
                                const double reference_length)
    {
      check_positive("Half-width", half_width, "m");
      check_positive("Reference length", reference_length, "m");
      if (!(2 * reference_length > half_width))
        reject("Reference length",
               reference_length,
               "m",
               "larger than half the half-width of the patch");
    }

    void check_compliance(const std::string &name, const Amplitude compliance)
    {
      check_finite("Real part of the " + name, compliance.real(), "m^2/N");
      check_finite("Imaginary part of the " + name, compliance.imag(), "m^2/N");
    }

    void check_wavy_contact(const WavyLineContact &contact)
    {
      check_reference_length(contact.half_width, contact.reference_length);
      check_positive("Relative radius", contact.relative_radius, "m");
      check_positive("Contact modulus", contact.contact_modulus, "Pa");
      check_positive("Friction coefficient", contact.friction_coefficient);
      check_positive("Creepage", contact.creepage);
      check_not_negative("Wear coefficient", contact.wear_coefficient, "m^3/J");
      check_positive("Wave number", contact.wave_number, "1/m");
      if (contact.wave_number * contact.half_width > 1000)
        reject("Wave number",
               contact.wave_number,
               "1/m",
               "at most 1000 over the half-width of the patch");
      check_compliance("normal compliance", contact.normal_compliance);
      check_compliance("tangential compliance", contact.tangential_compliance);
    }

    /**
     * exp(-i z y) = terms_0 + 2 sum terms_n T_n(y)/n: J_0 and n (-i)^n J_n, up
     * to where J_n is below rounding.
     */
    std::vector<Amplitude> wave_terms(const double       z,
                                      const unsigned int fineness)
    {
      const unsigned int n_terms =
        fineness * static_cast<unsigned int>(20 + z + 10 * std::cbrt(z));
      std::vector<Amplitude> terms(n_terms);
      Amplitude              turn = 1.;
      terms[0]                    = bessel_j(0, z);
      for (unsigned int n = 1; n < n_terms; ++n)
        {
          turn *= -imaginary_unit;
          terms[n] = turn * (n * bessel_j(n, z));
        }
      return terms;
    }

    /**
     * sum c_n cos(n angle).
     */
    Amplitude cosine_series(const std::vector<Amplitude> &terms,
                            const double                  angle)
    {
      Amplitude sum = 0.;
      for (unsigned int n = 0; n < terms.size(); ++n)
        sum += terms[n] * std::cos(n * angle);
      return sum;
    }

    /**
     * sum c_n (-1)^n, the factor of the inverse square root at the leading end.
     */
    Amplitude leading_sum(const std::vector<Amplitude> &terms)
    {
      Amplitude sum = 0.;
      for (unsigned int n = 0; n < terms.size(); ++n)
        sum += n % 2 == 0 ? terms[n] : -terms[n];
      return sum;
    }
  } // namespace

  /**
   * A point by its distances from the trailing edge and from the end of the
   * stick zone (m), both exact near the ends.
   */
  struct WavyCarter::Place
  {
    double x, before_trailing_edge, behind_stick_zone;
  };

  std::complex<double> PassageGrowth::total() const
  {
    return slip + pressure;
  }

  WavyCarter::WavyCarter(const WavyLineContact &contact,
                         const unsigned int     fineness)
    : contact(contact)
    , fineness(fineness)
  {
    check_wavy_contact(contact);
    check_positive("Fineness", fineness);
    stick_width =
      std::max(0.,
               contact.half_width - contact.creepage * contact.relative_radius /
                                      contact.friction_coefficient);
    solve_pressure();
    force_amplitude = -contact.friction_coefficient * load_amplitude;
    if (stick_width > 0)
      solve_stick_zone();
  }

  void WavyCarter::solve_pressure()
  {
    load_amplitude = load_per_wave(contact.half_width,
                                   contact.contact_modulus,
                                   contact.reference_length,
                                   contact.wave_number,
                                   contact.normal_compliance);
    pressure_terms =
      wave_terms(contact.wave_number * contact.half_width, fineness);
    for (Amplitude &term : pressure_terms)
      term *= contact.contact_modulus / contact.half_width;
    pressure_terms[0] = load_amplitude / (pi * contact.half_width);
  }

  void WavyCarter::solve_stick_zone()
  {
    const double z    = contact.wave_number * stick_width;
    const double far  = std::log(2 * contact.reference_length / stick_width);
    const double J0   = bessel_j(0, z);
    const double unit = contact.contact_modulus / (2 * stick_width);

    // W = B exp(-i k x) in the middle of the stick zone, X = mu alpha N^ + A:
    // edge = unit (W (J0/far + motion) - X/far), c_0 = unit/far (W J0 - X)
    const Amplitude motion = imaginary_unit * z * first_two_bessels(z);
    const Amplitude edge =
      contact.friction_coefficient * leading_sum(pressure_terms);
    const auto middle = [&](const Amplitude X) {
      return (edge / unit + X / far) / (J0 / far + motion);
    };
    const auto force_of = [&](const Amplitude X) {
      return pi * stick_width * unit / far * (middle(X) * J0 - X);
    };

    // T^ = -mu N^ + force_of(X), force_of(X) = int q2^ dx, affine in X
    const Amplitude X_normal =
      contact.friction_coefficient * contact.normal_compliance * load_amplitude;
    const Amplitude per_X =
      pi * stick_width * unit / far * (J0 / (J0 + far * motion) - 1.);
    const Amplitude answer = 1. - contact.tangential_compliance * per_X;
    if (answer == 0.)
      throw InputError("Tangential compliance cancels that of the contact: the "
                       "force has no bound. Add damping.");
    force_amplitude = (force_amplitude + force_of(X_normal)) / answer;
    const Amplitude X =
      X_normal + contact.tangential_compliance * force_amplitude;

    stick_terms = wave_terms(z, fineness);
    for (Amplitude &term : stick_terms)
      term *= 2 * unit * middle(X);
    stick_terms[0] = force_of(X) / (pi * stick_width);
  }

  double WavyCarter::stick_half_width() const
  {
    return stick_width;
  }

  std::complex<double> WavyCarter::load() const
  {
    return load_amplitude;
  }

  std::complex<double> WavyCarter::force() const
  {
    return force_amplitude;
  }

  WavyCarter::Place WavyCarter::place_at(const double x) const
  {
    return {x,
            contact.half_width - x,
            x + contact.half_width - 2 * stick_width};
  }

  std::complex<double> WavyCarter::pressure_at(const Place &place) const
  {
    const double ratio = place.before_trailing_edge / (2 * contact.half_width);
    return cosine_series(pressure_terms, 2 * std::asin(std::sqrt(ratio))) /
           (2 * std::sqrt(ratio * (1 - ratio)));
  }

  std::complex<double> WavyCarter::pressure(const double x) const
  {
    return std::abs(x) < contact.half_width ? pressure_at(place_at(x)) : 0.;
  }

  std::complex<double> WavyCarter::traction(const double x) const
  {
    const Amplitude sliding = -contact.friction_coefficient * pressure(x);
    const double    y       = (x + contact.half_width) / stick_width - 1;
    if (!(stick_width > 0 && std::abs(y) < 1))
      return sliding;
    return sliding + cosine_series(stick_terms, std::acos(y)) /
                       std::sqrt((1 - y) * (1 + y));
  }

  std::complex<double> WavyCarter::slip_at(const Place &place) const
  {
    const Amplitude ik = imaginary_unit * contact.wave_number;
    const Amplitude uniform =
      ik * (contact.friction_coefficient * contact.normal_compliance *
              load_amplitude +
            contact.tangential_compliance * force_amplitude);
    if (stick_width == 0)
      return uniform;

    // T_n continued beyond 1 as (y - sqrt(y^2 - 1))^n
    const double    t    = place.behind_stick_zone / stick_width;
    const double    root = std::sqrt(t * (t + 2));
    const double    fall = 1 / (1 + t + root);
    const double    far  = std::log(2 * contact.reference_length / stick_width);
    const Amplitude per_gradient = -2 / (contact.contact_modulus * root);
    const Amplitude per_value = 2 * stick_width / contact.contact_modulus * ik;
    Amplitude       sum =
      stick_terms[0] * (per_gradient + per_value * (far + std::log(fall)));
    double power = 1;
    for (unsigned int n = 1; n < stick_terms.size(); ++n)
      {
        power *= fall;
        sum += stick_terms[n] * power * (per_gradient + per_value / double(n));
      }
    return uniform + sum;
  }

  std::complex<double> WavyCarter::slip(const double x) const
  {
    const Place place = place_at(x);
    return place.behind_stick_zone > 0 && place.before_trailing_edge > 0
             ? slip_at(place)
             : 0.;
  }

  unsigned int WavyCarter::n_points() const
  {
    // a stick zone of a small width 2 a' has a branch point that near
    const double n_near =
      stick_width > 0 ? 10 * std::sqrt(contact.half_width / stick_width) : 0;
    return 2 * pressure_terms.size() +
           fineness * static_cast<unsigned int>(100 + std::min(n_near, 3000.));
  }

  PassageGrowth WavyCarter::growth() const
  {
    const double a = contact.half_width;
    const double max_pressure =
      hertz_line_of_half_width(a,
                               contact.relative_radius,
                               contact.contact_modulus)
        .max_pressure;
    const double strain =
      contact.friction_coefficient / contact.relative_radius;
    const double length  = 2 * (a - stick_width);
    const double rigid   = stick_width > 0 ? 0 : contact.creepage - strain * a;
    const unsigned int n = n_points();

    PassageGrowth growth;
    for (unsigned int i = 0; i < n; ++i)
      {
        const double half_angle = pi * (i + 0.5) / (2 * n);
        const double d          = length * std::pow(std::sin(half_angle), 2);
        const double t          = length * std::pow(std::cos(half_angle), 2);
        const Place  place{a - d, d, t};
        const double steady_pressure =
          max_pressure * std::sqrt(d * (2 * a - d)) / a;
        const double steady_slip =
          rigid + strain * std::sqrt(t * (t + 2 * stick_width));
        const Amplitude weight =
          std::polar(std::sqrt(d * t) * pi / n, contact.wave_number * place.x);
        growth.slip += steady_pressure * slip_at(place) * weight;
        growth.pressure += steady_slip * pressure_at(place) * weight;
      }
    const double wear =
      -contact.wear_coefficient * contact.friction_coefficient;
    return {wear * growth.slip, wear * growth.pressure};
  }

  std::complex<double> load_per_wave(const double half_width,
                                     const double contact_modulus,
                                     const double reference_length,
                                     const double wave_number,
                                     const std::complex<double> compliance)
  {
    check_reference_length(half_width, reference_length);
    check_positive("Contact modulus", contact_modulus, "Pa");
    check_positive("Wave number", wave_number, "1/m");
    check_compliance("normal compliance", compliance);
    const Amplitude sum =
      2 / (pi * contact_modulus) * std::log(2 * reference_length / half_width) +
      compliance;
    if (sum == 0.)
      throw InputError("Normal compliance cancels that of the contact: the "
                       "load has no bound. Add damping.");
    return bessel_j(0, wave_number * half_width) / sum;
  }

  std::complex<double> creepage_wave_ratio(const double half_width,
                                           const double reference_length,
                                           const double wave_number)
  {
    check_reference_length(half_width, reference_length);
    check_not_negative("Wave number", wave_number, "1/m");
    const double    z    = wave_number * half_width;
    const double    far  = std::log(2 * reference_length / half_width);
    const Amplitude both = first_two_bessels(z);
    return both / (both.real() + imaginary_unit * (far * z) * both);
  }

  double wave_flattening(const double z)
  {
    check_not_negative("Half-width times wave number", z);
    const double J0 = bessel_j(0, z), J1 = bessel_j(1, z);
    return z / 2 * (z * (J0 * J0 + J1 * J1) - J0 * J1);
  }

  std::complex<double>
  sliding_growth_per_creepage(const WavyLineContact &contact)
  {
    check_wavy_contact(contact);
    const double    z    = contact.wave_number * contact.half_width;
    const Amplitude load = load_per_wave(contact.half_width,
                                         contact.contact_modulus,
                                         contact.reference_length,
                                         contact.wave_number,
                                         contact.normal_compliance);
    return -contact.wear_coefficient * contact.friction_coefficient *
           (pi * contact.contact_modulus * wave_flattening(z) +
            bessel_j(0, z) * load);
  }
} // namespace RollingContact::References
