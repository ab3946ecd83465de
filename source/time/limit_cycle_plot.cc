#include <rolling_contact/run/figure.h>
#include <rolling_contact/time/limit_cycle.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    using Values = std::vector<double>;

    /// of the largest rms value in a panel: what is less is not drawn
    const double least_shown = 1e-6;

    Values last(const Values &values, const std::size_t n)
    {
      return {values.end() - std::min(n, values.size()), values.end()};
    }

    Values multiplied(Values values, const double factor)
    {
      for (double &value : values)
        value *= factor;
      return values;
    }

    /** The integral over steps of a velocity about its mean, itself without
     * mean. */
    Values
    displacement(const Values &velocity, const double mean, const double step)
    {
      Values place(velocity.size(), 0.);
      double sum = 0.;
      for (std::size_t t = 1; t < velocity.size(); ++t)
        {
          place[t] =
            place[t - 1] + step * ((velocity[t] + velocity[t - 1]) / 2 - mean);
          sum += place[t];
        }
      for (double &value : place)
        value -= sum / velocity.size();
      return place;
    }
  } // namespace

  LimitCycle::Names LimitCycle::that_move(const Names &names) const
  {
    double largest = 0.;
    for (const auto &[name, label] : names)
      if (has(name))
        largest = std::max(largest, whole->rms(column(name)));
    Names result;
    for (const auto &[name, label] : names)
      if (has(name) && whole->rms(column(name)) >= least_shown * largest)
        result.emplace_back(name, label);
    return result;
  }

  void LimitCycle::draw(RunContext &context) const
  {
    if (!is_periodic())
      return;
    const double h = watch.time_step(), speed = watch.rolling_speed();
    const auto   n =
      static_cast<std::size_t>(std::ceil(verdict.period.length) + 1);
    const std::string along(1, direction());
    const Values     &velocity = column("velocity_" + along + "_m/s"),
                 &force        = column("force_" + along + "_N");
    Values sliding             = velocity;
    for (std::size_t t = 0; t < sliding.size(); ++t)
      sliding[t] += speed * column("creepage_" + along)[t];

    Figure portrait("Limit cycle, " + std::string("contact along ") + along,
                    "displacement (\u00b5m)",
                    "velocity (m/s)");
    const Values cycle = last(velocity, n);
    portrait.add_curve("",
                       multiplied(displacement(cycle, whole->mean(velocity), h),
                                  1e6),
                       cycle);

    Figure loop("", "sliding velocity (m/s)", "T (kN)");
    loop.add_curve("", last(sliding, n), multiplied(last(force, n), 1e-3));
    portrait.add_separate_panel(loop);

    Values time(std::min(2 * n, velocity.size()));
    for (std::size_t t = 0; t < time.size(); ++t)
      time[t] = 1e3 * h * t;
    const auto add_over_time =
      [&](const std::string &y_label, const Names &names, const double factor) {
        Figure panel("", "time (ms)", y_label);
        for (const auto &[name, label] : that_move(names))
          panel.add_curve(label,
                          time,
                          multiplied(last(column(name), time.size()), factor));
        portrait.add_separate_panel(panel);
      };
    add_over_time("velocity (m/s)",
                  {{"velocity_x_m/s", "x"},
                   {"velocity_y_m/s", "y"},
                   {"velocity_z_m/s", "z"}},
                  1.);
    add_over_time("N (kN)", {{"normal_force_N", ""}}, 1e-3);
    add_over_time("T (kN)",
                  {{"force_x_N", "longitudinal"}, {"force_y_N", "lateral"}},
                  1e-3);
    portrait.draw(context, "cycle");
  }
} // namespace RollingContact
