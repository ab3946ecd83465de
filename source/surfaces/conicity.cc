#include <boost/math/tools/roots.hpp>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/surfaces/conicity.h>
#include <rolling_contact/surfaces/profile_file.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace RollingContact::Profiles
{
  namespace
  {
    const unsigned int n_phases = 4000; // of a quarter of the oscillation

    const std::size_t least_rows = 5, most_rows = 2000;

    const double largest_shift = 0.05, largest_difference = 0.1; // m

    /**
     * The middle of the motion with this amplitude: the restoring difference
     * does as much work on its one side as on the other. NaN if there is none
     * in the table. Units: m.
     */
    double middle_of_motion(const RadiusDifference &dr, const double amplitude)
    {
      const auto work = [&](const double middle) {
        return dr.integral(middle - amplitude, middle + amplitude);
      };
      // the same wheels and rails on both sides
      const double rounding = 1e-6;
      if (dr.covers(amplitude) &&
          std::abs(work(0.)) <=
            rounding * amplitude *
              (std::abs(dr.at(amplitude)) + std::abs(dr.at(-amplitude))))
        return 0.;
      const double least = dr.shift.front() + amplitude,
                   most  = dr.shift.back() - amplitude;
      if (!(least < most && work(least) < 0. && work(most) > 0.))
        return std::nan("");
      std::uintmax_t rounds = 100;
      const auto     found  = boost::math::tools::toms748_solve(
        work, least, most, boost::math::tools::eps_tolerance<double>(), rounds);
      return (found.first + found.second) / 2;
    }

    /**
     * A quarter of the wave of y'' + dr(y) = 0, from the middle of the motion
     * to the turning point on one @p side of it: the integral of dy / sqrt(2
     * (P(A) - P(y))), P' = dr. NaN if dr does not drive the wheelset back.
     */
    double quarter_of_wave(const RadiusDifference &dr,
                           const double            middle,
                           const double            amplitude,
                           const double            side)
    {
      const auto place = [&](const unsigned int k) {
        return side * amplitude * std::sin(M_PI / 4 * k / n_phases);
      };
      // from the ends inwards; of odd index, the middles of steps
      std::vector<double> energy(2 * n_phases + 1, 0.);
      for (unsigned int k = 2 * n_phases; k-- > 0;)
        {
          const auto [from, to] = std::minmax({place(k), place(k + 1)});
          energy[k] =
            energy[k + 1] + side * dr.integral(middle + from, middle + to);
        }
      double quarter = 0.;
      for (unsigned int k = 0; k < 2 * n_phases; k += 2)
        {
          if (!(energy[k + 1] > 0.))
            return std::nan("");
          quarter +=
            side * (place(k + 2) - place(k)) / std::sqrt(2 * energy[k + 1]);
        }
      return quarter;
    }
  } // namespace

  double RadiusDifference::at(const double there) const
  {
    const std::size_t k = std::clamp<std::ptrdiff_t>(
      std::upper_bound(shift.begin(), shift.end(), there) - shift.begin() - 1,
      0,
      shift.size() - 2);
    const double t = (there - shift[k]) / (shift[k + 1] - shift[k]);
    return (1 - t) * difference[k] + t * difference[k + 1];
  }

  double RadiusDifference::integral(const double from, const double to) const
  {
    // trapezoids: it is linear between shifts
    double sum = 0., begin = from;
    for (auto next = std::upper_bound(shift.begin(), shift.end(), from);
         next != shift.end() && *next < to;
         ++next)
      {
        sum += (at(begin) + at(*next)) / 2 * (*next - begin);
        begin = *next;
      }
    return sum + (at(begin) + at(to)) / 2 * (to - begin);
  }

  bool RadiusDifference::covers(const double amplitude) const
  {
    const double rounding = 1e-9 * amplitude;
    return shift.size() > 1 && shift.front() <= -amplitude + rounding &&
           shift.back() >= amplitude - rounding;
  }

  double harmonic_conicity(const RadiusDifference &dr, const double amplitude)
  {
    const double middle = middle_of_motion(dr, amplitude);
    if (std::isnan(middle))
      return middle;
    double sum = 0.;
    for (unsigned int k = 0; k < 4 * n_phases; ++k)
      {
        const double sine = std::sin(M_PI / 2 * (k + 0.5) / n_phases);
        sum += dr.at(middle + amplitude * sine) * sine;
      }
    return sum / (4 * n_phases) / amplitude;
  }

  double equivalent_conicity(const RadiusDifference &dr, const double amplitude)
  {
    const double middle = middle_of_motion(dr, amplitude);
    if (std::isnan(middle))
      return middle;
    const double wave = 2 * (quarter_of_wave(dr, middle, amplitude, 1.) +
                             quarter_of_wave(dr, middle, amplitude, -1.));
    return std::pow(2 * M_PI / wave, 2) / 2;
  }

  RadiusDifference read_radius_difference(const std::filesystem::path &file,
                                          const double                 unit)
  {
    RadiusDifference dr;
    const auto       rows   = read_columns(file, "y and r right - r left");
    const auto       refuse = [&](const std::string &what) {
      throw InputError(file.string() + ": " + what);
    };
    if (rows.size() < least_rows || rows.size() > most_rows)
      refuse(std::to_string(rows.size()) +
             " rows found; a difference of rolling radii has " +
             std::to_string(least_rows) + " to " + std::to_string(most_rows) +
             ", 0.1 mm apart as a rule.");
    for (const auto &[shift, difference] : rows)
      {
        if (!dr.shift.empty() && !(unit * shift > dr.shift.back()))
          refuse("y = " + text_of(shift) + " follows " +
                 text_of(dr.shift.back() / unit) +
                 "; the first column, the shift to the right, must ascend.");
        if (!(std::abs(unit * shift) <= largest_shift &&
              std::abs(unit * difference) <= largest_difference))
          refuse("y = " + text_of(shift) +
                 ", r right - r left = " + text_of(difference) + " is " +
                 text_of(unit * shift) + " and " + text_of(unit * difference) +
                 " m; at most " + text_of(largest_shift) + " and " +
                 text_of(largest_difference) +
                 " m are taken. Check Contact table/File unit (1e-3 for mm).");
        dr.shift.push_back(unit * shift);
        dr.difference.push_back(unit * difference);
      }
    return dr;
  }
} // namespace RollingContact::Profiles
