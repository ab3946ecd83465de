#include <rolling_contact/base/constants.h>
#include <rolling_contact/damage/line_depths.h>
#include <rolling_contact/references/checks.h>

#include <algorithm>

namespace RollingContact::Damage
{
  namespace
  {
    using Numbers = std::vector<double>;

    void check_number(const std::string &quantity,
                      const std::size_t  number,
                      const std::size_t  wanted)
    {
      if (number != wanted)
        References::reject("Number of " + quantity,
                           number,
                           "",
                           std::to_string(wanted) + ", one each");
    }

    void check_rising(const std::string &quantity, const Numbers &values)
    {
      for (std::size_t k = 0; k < values.size(); ++k)
        {
          References::check_finite(quantity, values[k], "m");
          if (k > 0 && !(values[k] > values[k - 1]))
            References::reject(quantity,
                               values[k],
                               "m",
                               "larger than that before it");
        }
    }

    /** Piecewise linear: one at the middle, zero from begin and end on. */
    struct Hat
    {
      double begin, middle, end;

      double operator()(const double y) const
      {
        if (y <= begin || y >= end)
          return y == middle;
        return y < middle   ? (y - begin) / (middle - begin)
               : y > middle ? (end - y) / (end - middle)
                            : 1.;
      }
    };

    Hat hat_of_line(const std::vector<LinePlace> &lines, const std::size_t k)
    {
      const double y = lines[k].y, twice = 2 * lines[k].width;
      const bool   first = k == 0, last = k + 1 == lines.size();
      const double before = first ? 0. : y - lines[k - 1].y,
                   behind = last ? 0. : lines[k + 1].y - y;
      if (first && last)
        return {y - twice / 2, y, y + twice / 2};
      return {y - (first ? std::max(0., twice - behind) : before),
              y,
              y + (last ? std::max(0., twice - before) : behind)};
    }

    /** Share of a point in what is deposited at y, with one at the ends. */
    double share(const Numbers &points, const std::size_t j, const double y)
    {
      if (y <= points.front() || y >= points.back())
        return j == (y <= points.front() ? 0 : points.size() - 1);
      const double s = points[j];
      if (y < s)
        return j > 0 ? std::max(0., 1 - (s - y) / (s - points[j - 1])) : 1.;
      return y > s ? std::max(0., 1 - (y - s) / (points[j + 1] - s)) : 1.;
    }

    /**
     * Add the area, spread by the hat, to the points: over each interval
     * without a kink Simpson's rule is exact for the product of two lines.
     */
    void spread(const Hat     &hat,
                const double   area,
                const Numbers &points,
                Numbers       &deposited)
    {
      Numbers    kinks{hat.begin, hat.middle, hat.end};
      const auto from =
        std::upper_bound(points.begin(), points.end(), hat.begin);
      const auto to = std::lower_bound(from, points.end(), hat.end);
      kinks.insert(kinks.end(), from, to);
      std::sort(kinks.begin(), kinks.end());
      const std::size_t n    = points.size(),
                        left = from - points.begin() - (from > points.begin()),
                        right =
                          std::min(n - 1, std::size_t(to - points.begin()));
      const double scale = area * 2 / (hat.end - hat.begin);
      for (std::size_t i = 0; i + 1 < kinks.size(); ++i)
        for (const double where : {0., 0.5, 1.})
          {
            const double width = kinks[i + 1] - kinks[i],
                         y     = where == 1. ? kinks[i + 1]
                                             : kinks[i] + where * width,
                         amount =
                           scale * width * hat(y) * (where == 0.5 ? 4 : 1) / 6;
            for (std::size_t j = left; j <= right && amount != 0.; ++j)
              deposited[j] += amount * share(points, j, y);
          }
    }
  } // namespace

  double depth_per_passage(const NodeLine         &line,
                           const WearLaw          &law,
                           const DamageParameters &parameters)
  {
    check_number("lengths", line.lengths.size(), line.nodes.size());
    double depth = 0.;
    for (std::size_t i = 0; i < line.nodes.size(); ++i)
      depth += law.rate(line.nodes[i], parameters) * line.lengths[i];
    return depth;
  }

  double wheel_depth_per_metre(const double depth_per_passage,
                               const double rolling_radius)
  {
    References::check_positive("Rolling radius", rolling_radius, "m");
    return depth_per_passage / (2 * pi * rolling_radius);
  }

  double worn_area(const std::vector<LinePlace> &lines, const Numbers &depths)
  {
    check_number("depths", depths.size(), lines.size());
    double area = 0.;
    for (std::size_t k = 0; k < lines.size(); ++k)
      area += depths[k] * lines[k].width;
    return area;
  }

  Numbers deposit(const std::vector<LinePlace> &lines,
                  const Numbers                &areas,
                  const Numbers                &abscissae)
  {
    check_number("areas", areas.size(), lines.size());
    if (abscissae.empty())
      References::reject("Number of abscissae", 0, "", "at least 1");
    check_rising("Abscissa", abscissae);
    Numbers places;
    for (const LinePlace &line : lines)
      {
        places.push_back(line.y);
        References::check_positive("Width of a line", line.width, "m");
      }
    check_rising("Place of a line", places);
    Numbers deposited(abscissae.size(), 0.);
    for (std::size_t k = 0; k < lines.size(); ++k)
      spread(hat_of_line(lines, k), areas[k], abscissae, deposited);
    return deposited;
  }
} // namespace RollingContact::Damage
