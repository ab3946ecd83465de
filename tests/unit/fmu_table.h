#ifndef tests_unit_fmu_table_h
#define tests_unit_fmu_table_h

#include <rolling_contact/fmu/wheelset_model.h>

#include <cmath>

/** A table of an FMU whose states follow a closed form. */
namespace FmuTable
{
  using namespace RollingContact::Fmu;

  using Axes = std::array<std::vector<double>, n_axes>;

  const Axes axes{{{-4e-3, -1e-3, 0., 1e-3, 2e-3, 4e-3},
                   {-1e-3, 0., 1e-3},
                   {-0.01, 0., 0.01},
                   {40e3, 60e3, 90e3},
                   {-0.02, -0.005, 0., 0.005, 0.02},
                   {-0.02, 0., 0.01, 0.02},
                   {0.3}}};

  const double radius = 0.46, tape_circle = 0.75;

  /** Each state by its coordinates; rolls and offsets by shifts. */
  template <class Law>
  WheelTable table_of(const Law &law, const double offset_per_shift = 0.)
  {
    std::vector<Quantities> states;
    std::size_t             n = 1;
    for (const auto &axis : axes)
      n *= axis.size();
    for (std::size_t k = 0; k < n; ++k)
      {
        Coordinates point;
        std::size_t rest = k;
        for (std::size_t d = n_axes; d-- > 0;)
          {
            point[d] = axes[d][rest % axes[d].size()];
            rest /= axes[d].size();
          }
        states.push_back(law(point));
      }
    std::vector<double> roll, offsets;
    for (std::size_t k = 0; k < axes[yaw_axis].size(); ++k)
      for (const double own : axes[shift_axis])
        for (const double other : axes[shift_axis])
          roll.push_back(0.05 * (own + other) / 2);
    for (const double shift : {-4e-3, 4e-3})
      offsets.push_back(offset_per_shift * shift);
    return WheelTable(axes, states, roll, offsets);
  }

  /** Forces over the load that are parabolas of each coordinate. */
  inline Quantities smooth(const Coordinates &x)
  {
    Quantities   found{};
    const double s = x[shift_axis] / 4e-3, u = x[along_axis] / 0.02,
                 v = x[across_axis] / 0.02, q = x[load_axis] / 60e3;
    found[force_x]       = x[load_axis] * (-u + 0.3 * u * u * v + 0.1 * s * q);
    found[force_y]       = x[load_axis] * (-v * v + 0.2 * s * s * u);
    found[force_z]       = -x[load_axis];
    found[moment_x]      = 3 * x[load_axis] * x[yaw_axis];
    found[moment_z]      = x[load_axis] * x[turn_axis];
    found[normal_force]  = x[load_axis];
    found[place_y]       = tape_circle - x[shift_axis];
    found[contact_angle] = 0.025 + s * s;
    found[max_pressure]  = 1e9 * std::cbrt(x[load_axis]);
    found[force_bound]   = 1e-3 * x[load_axis];
    return found;
  }

  inline Inputs start()
  {
    Inputs inputs{};
    inputs[speed]      = 20.;
    inputs[axle_speed] = -20. / radius;
    inputs[friction]   = 0.3;
    inputs[right_load] = inputs[left_load] = 60e3;
    return inputs;
  }

  inline WheelsetModel model_of(const WheelTable &table)
  {
    return {{radius, tape_circle, start()}, table};
  }
} // namespace FmuTable

#endif
