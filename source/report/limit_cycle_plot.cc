#include <rolling_contact/plot/figure.h>
#include <rolling_contact/report/limit_cycle.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    using Values = std::vector<double>;

    Values
    last(const Values &values, const std::size_t n)
    {
      return {values.end() - std::min(n, values.size()), values.end()};
    }



    Values
    scaled(Values values, const double factor)
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



  void
  LimitCycle::draw(RunContext &context) const
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
    portrait.add_curve(
      "", scaled(displacement(cycle, whole->mean(velocity), h), 1e6), cycle);

    Figure loop("", "sliding velocity (m/s)", "T (kN)");
    loop.add_curve("", last(sliding, n), scaled(last(force, n), 1e-3));
    portrait.add_separate_panel(loop);

    Values time(std::min(2 * n, velocity.size()));
    for (std::size_t t = 0; t < time.size(); ++t)
      time[t] = 1e3 * h * t;
    Figure velocities("", "time (ms)", "velocity (m/s)"),
      forces("", "time (ms)", "force (kN)");
    for (const char axis : {'x', 'y', 'z'})
      if (const std::string name = "velocity_" + std::string(1, axis) + "_m/s";
          has(name))
        velocities.add_curve(std::string(1, axis),
                             time,
                             last(column(name), time.size()));
    for (const auto &[name, label] : {std::pair("normal_force_N", "N"),
                                      std::pair("force_x_N", "longitudinal T"),
                                      std::pair("force_y_N", "lateral T")})
      if (has(name))
        forces.add_curve(label,
                         time,
                         scaled(last(column(name), time.size()), 1e-3));
    portrait.add_separate_panel(velocities);
    portrait.add_separate_panel(forces);
    portrait.draw(context, "cycle");
  }
} // namespace RollingContact
