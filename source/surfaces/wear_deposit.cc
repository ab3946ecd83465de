#include <rolling_contact/surfaces/wear_deposit.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace RollingContact::Profiles
{
  namespace
  {
    using Numbers = std::vector<double>;

    /**
     * The second antiderivative of a hat of area 1 that reaches to the left and
     * to the right of 0: 0 before it, u less its mean place behind it.
     */
    double
    hat_integrated_twice(const double u, const double left, const double right)
    {
      const double behind = u - (right - left) / 3;
      if (u <= -left)
        return 0.;
      if (u >= right)
        return behind;
      const auto tip = [&](const double t, const double reach) {
        return t * t * t / (3 * reach * (left + right));
      };
      return u < 0. ? tip(u + left, left) : behind + tip(right - u, right);
    }

    /**
     * Add an amount that is spread as a hat about a place to those of points,
     * each the integral over its own hat function: differences of the slopes
     * over the segments, so that they add up to the amount.
     */
    void spread(const double   amount,
                const double   place,
                const double   left,
                const double   right,
                const Numbers &arc,
                Numbers       &amounts)
    {
      const auto integral = [&](const std::size_t k) {
        return hat_integrated_twice(arc[k] - place, left, right);
      };
      const std::size_t n = arc.size();
      std::size_t       k =
        std::upper_bound(arc.begin(), arc.end(), place - left) - arc.begin();
      double before = 0.;
      for (k = k == 0 ? 0 : k - 1; before < 1.; ++k)
        {
          const bool   is_behind = k + 1 == n || arc[k] >= place + right;
          const double slope     = is_behind
                                     ? 1.
                                     : std::min(1.,
                                            (integral(k + 1) - integral(k)) /
                                              (arc[k + 1] - arc[k]));
          amounts[k] += amount * (slope - before);
          before = slope;
        }
    }

    /** The distance of the line next to one; none if there is none near. */
    std::optional<double> next_line(const std::vector<WearLine> &lines,
                                    const std::size_t            line,
                                    const int                    side)
    {
      if (side < 0 ? line == 0 : line + 1 == lines.size())
        return {};
      const double distance = side * (lines[line + side].s - lines[line].s);
      if (distance > 3 * lines[line].width)
        return {};
      return distance;
    }

    /**
     * How far the hat of a line reaches to a side: to the next line, else so
     * that its area is the width times the height.
     */
    double reach(const std::vector<WearLine> &lines,
                 const std::size_t            line,
                 const int                    side)
    {
      const double width = lines[line].width;
      if (const auto distance = next_line(lines, line, side))
        return *distance;
      return std::max(0.,
                      2 * width -
                        next_line(lines, line, -side).value_or(width));
    }

    double before(const Numbers &arc, const std::size_t k)
    {
      return k == 0 ? 0. : arc[k] - arc[k - 1];
    }

    double behind(const Numbers &arc, const std::size_t k)
    {
      return k + 1 == arc.size() ? 0. : arc[k + 1] - arc[k];
    }
  } // namespace

  void check_number_of_points(const ProfileCurve        &curve,
                              const std::vector<double> &values)
  {
    if (values.size() != curve.points().size() ||
        !std::all_of(values.begin(), values.end(), [](const double value) {
          return std::isfinite(value);
        }))
      throw std::invalid_argument(
        "Wear needs a finite number for each point of the profile.");
  }

  double arc_length_across(const ProfileCurve &curve, const double y)
  {
    const ArcLengthAtY place(curve);
    if (place.covers(y))
      return place(y);
    const std::size_t first = place.first_point(),
                      end   = y < curve.points()[first].y
                                ? first
                                : first + place.n_points() - 1;
    return curve.arc_lengths()[end] + y - curve.points()[end].y;
  }

  std::vector<double> deposited(const ProfileCurve   &curve,
                                std::vector<WearLine> lines)
  {
    for (const WearLine &line : lines)
      if (!(line.width > 0. && std::isfinite(line.s + line.width + line.depth)))
        throw std::invalid_argument("A line of wear needs finite numbers and a "
                                    "width above 0.");
    std::sort(lines.begin(), lines.end(), [](const auto &a, const auto &b) {
      return a.s < b.s;
    });
    Numbers amounts(curve.points().size(), 0.);
    for (std::size_t k = 0; k < lines.size(); ++k)
      spread(lines[k].depth * lines[k].width,
             lines[k].s,
             reach(lines, k, -1),
             reach(lines, k, 1),
             curve.arc_lengths(),
             amounts);
    return amounts;
  }

  std::vector<double> smoothed(const ProfileCurve        &curve,
                               const std::vector<double> &amounts,
                               const double               width)
  {
    check_number_of_points(curve, amounts);
    if (width == 0.)
      return amounts;
    const Numbers &arc = curve.arc_lengths();
    Numbers        found(amounts.size(), 0.);
    for (std::size_t k = 0; k < amounts.size(); ++k)
      if (amounts[k] != 0.)
        {
          const double reach = std::min({width, arc[k], arc.back() - arc[k]});
          spread(amounts[k], arc[k], reach, reach, arc, found);
        }
    return found;
  }

  std::vector<double> depths_of(const ProfileCurve        &curve,
                                const std::vector<double> &amounts)
  {
    check_number_of_points(curve, amounts);
    // amount over length is the depth at the centre of a point's hat function
    const Numbers    &arc = curve.arc_lengths();
    const std::size_t n   = arc.size();
    Numbers           places(n), means(n), depths(n);
    for (std::size_t k = 0; k < n; ++k)
      {
        const double left = before(arc, k), right = behind(arc, k);
        places[k] = arc[k] + (right - left) / 3;
        means[k]  = 2 * amounts[k] / (left + right);
      }
    for (std::size_t k = 0; k < n; ++k)
      {
        const std::size_t next =
          places[k] > arc[k] ? (k == 0 ? 0 : k - 1) : std::min(k + 1, n - 1);
        const double share =
          next == k ? 0. : (arc[k] - places[k]) / (places[next] - places[k]);
        depths[k] = means[k] + share * (means[next] - means[k]);
      }
    return depths;
  }
} // namespace RollingContact::Profiles
