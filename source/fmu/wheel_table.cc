#include <rolling_contact/fmu/wheel_table.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace RollingContact::Fmu
{
  namespace
  {
    const double rounding = 1e-9; ///< of the largest value of an axis

    const std::size_t most_values = 100000000;

    void require(const bool is_right, const char *what)
    {
      if (!is_right)
        throw std::invalid_argument(what);
    }

    void check_axis(const std::vector<double> &axis)
    {
      require(axis.size() == 1 || axis.size() > 2,
              "an axis has one value or at least three");
      for (std::size_t k = 0; k < axis.size(); ++k)
        require(std::isfinite(axis[k]) && (k == 0 || axis[k] > axis[k - 1]),
                "the values of an axis do not ascend");
    }

    /**
     * The first state of the interval around x and the part of it before x,
     * which is moved into the axis.
     */
    std::pair<std::size_t, double> place_on(const std::vector<double> &axis,
                                            double                    &x)
    {
      x = std::min(std::max(x, axis.front()), axis.back());
      if (axis.size() == 1)
        return {0, 0.};
      const std::size_t above =
        std::upper_bound(axis.begin() + 1, axis.end() - 1, x) - axis.begin();
      return {above - 1,
              (x - axis[above - 1]) / (axis[above] - axis[above - 1])};
    }

    /**
     * Weights of the slope at state k of three neighbours, the first of which
     * is returned: that of the parabola through them.
     */
    std::size_t slope_weights(const std::vector<double> &axis,
                              const std::size_t          k,
                              std::array<double, 3>     &weights)
    {
      const std::size_t first = std::min(k > 0 ? k - 1 : 0, axis.size() - 3);
      for (std::size_t i = 0; i < 3; ++i)
        {
          const double a = axis[first + (i + 1) % 3],
                       b = axis[first + (i + 2) % 3], at = axis[first + i];
          weights[i] = (2 * axis[k] - a - b) / ((at - a) * (at - b));
        }
      return first;
    }
  } // namespace

  double scale_of(const std::size_t quantity, const double load)
  {
    return quantity == place_y || quantity == contact_angle ? 1.
           : quantity == max_pressure                       ? std::cbrt(load)
                                                            : load;
  }

  WheelTable::WheelTable(const std::array<std::vector<double>, n_axes> &axes,
                         const std::vector<Quantities>                 &given,
                         const std::vector<double>                     &roll,
                         const std::vector<double>                     &offsets)
    : axes(axes)
    , states(given)
    , roll(roll)
    , offsets(offsets)
  {
    std::size_t n = 1;
    for (std::size_t d = n_axes; d-- > 0;)
      {
        check_axis(axes[d]);
        strides[d] = n;
        n *= axes[d].size();
        require(n <= most_values, "the table is too large");
      }
    require(axes[load_axis].front() > 0. && axes[friction_axis].front() > 0.,
            "a load or a friction coefficient is not above 0");
    require(states.size() == n, "states do not fill the axes");
    require(roll.size() == axes[yaw_axis].size() * axes[shift_axis].size() *
                             axes[shift_axis].size(),
            "angles of roll do not fill the axes");
    for (std::size_t k = 0; k < n; ++k)
      {
        const auto  &loads = axes[load_axis];
        const double load  = loads[k / strides[load_axis] % loads.size()];
        for (std::size_t q = 0; q < n_quantities; ++q)
          {
            require(std::isfinite(states[k][q]), "a value is not finite");
            states[k][q] /= scale_of(q, load);
          }
      }
    require(axes[shift_axis].size() == 1 ? offsets.size() == 1
                                         : offsets.size() > 1,
            "offsets do not fill the axis of shifts");
    for (const auto *numbers : {&roll, &offsets})
      for (const double number : *numbers)
        require(std::isfinite(number), "a roll or an offset is not finite");
    find_jumps();
  }

  void WheelTable::find_jumps()
  {
    jumps.assign(states.size(), {});
    for (std::size_t d = 0; d < n_axes; ++d)
      if (axes[d].size() > 1)
        find_jumps_along(d);
  }

  void WheelTable::find_jumps_along(const std::size_t d)
  {
    const std::vector<double> &axis   = axes[d];
    const std::size_t          stride = strides[d];
    for (std::size_t k = 0; k < states.size(); ++k)
      {
        // at the ends that of the neighbour within
        const std::size_t at    = k / stride % axis.size(),
                          inner = std::min(std::max<std::size_t>(at, 1),
                                           axis.size() - 2),
                          here  = k + inner * stride - at * stride;
        double square           = 0.;
        for (const Quantity q : {force_x, force_y, force_z})
          {
            const double before = (states[here][q] - states[here - stride][q]) /
                                  (axis[inner] - axis[inner - 1]),
                         behind = (states[here + stride][q] - states[here][q]) /
                                  (axis[inner + 1] - axis[inner]);
            square += (behind - before) * (behind - before);
          }
        jumps[k][d] = static_cast<float>(std::sqrt(square));
      }
  }

  WheelTable::Stencil WheelTable::stencil(const std::vector<double> &axis,
                                          const double               x,
                                          bool                      &inside)
  {
    double     within = x;
    const auto place  = place_on(axis, within);
    inside            = inside &&
             std::abs(x - within) <= rounding * std::max(std::abs(axis.front()),
                                                         std::abs(axis.back()));
    Stencil found;
    found.first = found.cell = place.first;
    if (axis.size() == 1)
      return found;
    const double      t = found.t = place.second;
    const double      h = found.width = axis[found.cell + 1] - axis[found.cell];
    const std::size_t low             = found.cell > 0 ? found.cell - 1 : 0,
                      high = std::min(found.cell + 2, axis.size() - 1);
    found.first            = low;
    found.n                = high - low + 1;
    found.weights          = {};
    found.weights[found.cell - low] += (1 + 2 * t) * (1 - t) * (1 - t);
    found.weights[found.cell + 1 - low] += t * t * (3 - 2 * t);
    const double by_slope[] = {h * t * (1 - t) * (1 - t), -h * t * t * (1 - t)};
    for (std::size_t end = 0; end < 2; ++end)
      {
        std::array<double, 3> weights;
        const std::size_t     first =
          slope_weights(axis, found.cell + end, weights);
        for (std::size_t i = 0; i < 3; ++i)
          found.weights[first + i - low] += by_slope[end] * weights[i];
      }
    return found;
  }

  void WheelTable::add_states(const std::array<Stencil, n_axes> &stencils,
                              const std::size_t                  d,
                              const std::size_t                  state,
                              const double                       weight,
                              Quantities                        &sum) const
  {
    if (d == n_axes)
      {
        for (std::size_t q = 0; q < n_quantities; ++q)
          sum[q] += weight * states[state][q];
        return;
      }
    const Stencil &here = stencils[d];
    for (std::size_t k = 0; k < here.n; ++k)
      if (here.weights[k] != 0.)
        add_states(stencils,
                   d + 1,
                   state + (here.first + k) * strides[d],
                   weight * here.weights[k],
                   sum);
  }

  double WheelTable::bound(const std::array<Stencil, n_axes> &stencils) const
  {
    double sum = 0.;
    for (std::size_t corner = 0; corner < (1u << n_axes); ++corner)
      {
        double      weight = 1.;
        std::size_t state  = 0;
        for (std::size_t d = 0; d < n_axes && weight != 0.; ++d)
          {
            const bool upper = corner >> d & 1;
            weight *= upper ? stencils[d].t : 1 - stencils[d].t;
            state += (stencils[d].cell + upper) * strides[d];
          }
        if (weight == 0.)
          continue;
        double here = states[state][force_bound];
        for (std::size_t d = 0; d < n_axes; ++d)
          {
            const Stencil &along = stencils[d];
            if (along.width == 0.)
              continue;
            const bool        upper = corner >> d & 1;
            const std::size_t other =
              upper ? state - strides[d] : state + strides[d];
            here += margin * along.t * (1 - along.t) * along.width *
                    (double(jumps[state][d]) + jumps[other][d]);
          }
        sum += weight * here;
      }
    return sum;
  }

  TableValues WheelTable::at(const Coordinates &point) const
  {
    TableValues                 found;
    std::array<Stencil, n_axes> stencils;
    for (std::size_t d = 0; d < n_axes; ++d)
      stencils[d] = stencil(axes[d], point[d], found.inside);
    add_states(stencils, 0, 0, 1., found.values);
    found.values[force_bound] = bound(stencils);
    for (std::size_t q = 0; q < n_quantities; ++q)
      found.values[q] *= scale_of(q, point[load_axis]);
    return found;
  }

  double WheelTable::resting_roll(const double shift,
                                  const double other_shift,
                                  const double yaw) const
  {
    const std::array<const std::vector<double> *, 3> along{
      {&axes[yaw_axis], &axes[shift_axis], &axes[shift_axis]}};
    std::array<double, 3>                         x{{yaw, shift, other_shift}};
    std::array<std::pair<std::size_t, double>, 3> places;
    for (std::size_t d = 0; d < 3; ++d)
      places[d] = place_on(*along[d], x[d]);
    double sum = 0.;
    for (std::size_t corner = 0; corner < 8; ++corner)
      {
        double      weight = 1.;
        std::size_t at     = 0;
        for (std::size_t d = 0; d < 3; ++d)
          {
            const std::size_t upper = corner >> d & 1;
            weight *= upper ? places[d].second : 1 - places[d].second;
            at = at * along[d]->size() +
                 std::min(places[d].first + upper, along[d]->size() - 1);
          }
        sum += weight * roll[at];
      }
    return sum;
  }

  double at_equal_distances(const std::vector<double> &values,
                            const double               first,
                            const double               last,
                            const double               x)
  {
    if (values.size() < 2 || !(last > first))
      return values.front();
    const double n_intervals = values.size() - 1.,
                 at = std::min(std::max((x - first) / (last - first), 0.), 1.) *
                      n_intervals;
    const auto k = static_cast<std::size_t>(std::min(at, n_intervals - 1.));
    return values[k] + (at - k) * (values[k + 1] - values[k]);
  }

  double WheelTable::offset(const double shift) const
  {
    const std::vector<double> &axis = axes[shift_axis];
    return at_equal_distances(offsets, axis.front(), axis.back(), shift);
  }

  std::vector<double> WheelTable::numbers() const
  {
    std::vector<double> all{margin};
    for (const auto &axis : axes)
      {
        all.push_back(axis.size());
        all.insert(all.end(), axis.begin(), axis.end());
      }
    all.insert(all.end(), roll.begin(), roll.end());
    all.push_back(offsets.size());
    all.insert(all.end(), offsets.begin(), offsets.end());
    const auto &loads = axes[load_axis];
    for (std::size_t k = 0; k < states.size(); ++k)
      for (std::size_t q = 0; q < n_quantities; ++q)
        all.push_back(
          states[k][q] *
          scale_of(q, loads[k / strides[load_axis] % loads.size()]));
    return all;
  }

  WheelTable WheelTable::of_numbers(const std::vector<double> &numbers,
                                    std::size_t               &at)
  {
    const auto next = [&]() {
      require(at < numbers.size(), "the table ends too early");
      return numbers[at++];
    };
    const auto take = [&](const std::size_t n) {
      require(n <= numbers.size() - at, "the table ends too early");
      at += n;
      return std::vector<double>(numbers.begin() + (at - n),
                                 numbers.begin() + at);
    };
    const double margin = next();
    require(margin > 0. && std::isfinite(margin),
            "the margin is not a finite number above 0");
    std::array<std::vector<double>, n_axes> axes;
    std::size_t                             n = 1;
    for (auto &axis : axes)
      {
        const double size = next();
        require(size >= 1. && size <= double(most_values) / n,
                "an axis has no possible size");
        axis = take(static_cast<std::size_t>(size));
        n *= axis.size();
      }
    const std::size_t n_shifts = axes[shift_axis].size();
    const auto        roll = take(axes[yaw_axis].size() * n_shifts * n_shifts);
    const double      n_offsets = next();
    require(n_offsets >= 1. && n_offsets <= double(most_values),
            "offsets have no possible number");
    const auto              offsets = take(static_cast<std::size_t>(n_offsets));
    const auto              values  = take(n * n_quantities);
    std::vector<Quantities> states(n);
    for (std::size_t k = 0; k < n; ++k)
      std::copy_n(values.begin() + k * n_quantities,
                  std::size_t(n_quantities),
                  states[k].begin());
    WheelTable table(axes, states, roll, offsets);
    table.margin = margin;
    return table;
  }
} // namespace RollingContact::Fmu
