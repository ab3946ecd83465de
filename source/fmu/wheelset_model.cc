#include <rolling_contact/fmu/wheelset_model.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace RollingContact::Fmu
{
  namespace
  {
    const char mark_of_model[] = "rolling-contact wheelset 1\n";

    const unsigned int rounds_of_roll = 4;

    const double least_friction = 1e-6;
  } // namespace

  std::array<double, 2> WheelsetModel::creepages(const WheelMotion &motion,
                                                 const double       yaw) const
  {
    return {{1 - tape_circle * motion.turn +
               radius * std::cos(yaw) * motion.about_axle,
             motion.aside + radius * std::sin(yaw) * motion.about_axle}};
  }

  WheelMotion WheelsetModel::motion(const std::array<double, 2> &creepages,
                                    const double                 turn,
                                    const double                 yaw) const
  {
    const double about_axle =
      (creepages[0] - 1 + tape_circle * turn) / (radius * std::cos(yaw));
    return {creepages[1] - radius * std::sin(yaw) * about_axle,
            turn,
            about_axle};
  }

  std::array<double, WheelQuestion::n_numbers> WheelQuestion::numbers() const
  {
    return {{on_own,
             on_other,
             yaw,
             rail_down,
             load,
             friction,
             motion.aside,
             motion.turn,
             motion.about_axle}};
  }

  WheelQuestion
  WheelQuestion::of_numbers(const std::array<double, n_numbers> &numbers)
  {
    const auto [on_own, on_other, yaw, down, load, mu, aside, turn, axle] =
      numbers;
    return {on_own, on_other, yaw, down, load, mu, {aside, turn, axle}};
  }

  WheelQuestion question_of(const Inputs      &inputs,
                            const unsigned int wheel,
                            const double       least_speed)
  {
    const bool   is_left = wheel == 1;
    const double side    = is_left ? -1. : 1.;
    const Input  own_y   = is_left ? left_rail_y : right_rail_y,
                other_y  = is_left ? right_rail_y : left_rail_y,
                own_z    = is_left ? left_rail_z : right_rail_z,
                other_z  = is_left ? right_rail_z : left_rail_z;
    const double V       = std::max(inputs[speed], least_speed);
    return {side * (inputs[lateral_shift] - inputs[own_y]),
            side * (inputs[lateral_shift] - inputs[other_y]),
            side * inputs[yaw],
            inputs[own_z] - inputs[other_z],
            inputs[is_left ? left_load : right_load],
            std::max(inputs[friction], least_friction),
            {side * inputs[lateral_velocity] / V,
             side * (inputs[curvature] + inputs[yaw_rate] / V),
             inputs[axle_speed] / V}};
  }

  WheelOutputs outputs_of(const Quantities  &values,
                          const bool         inside,
                          const Inputs      &inputs,
                          const unsigned int wheel)
  {
    WheelOutputs found{values, 0., inside};
    const double side = wheel == 1 ? -1. : 1.;
    for (const Quantity q :
         {force_y, moment_x, moment_z, place_y, contact_angle})
      found.values[q] *= side;
    found.values[place_y] += inputs[wheel == 1 ? left_rail_y : right_rail_y];
    if (!inside)
      found.values[force_bound] = std::numeric_limits<double>::max();
    found.force_ratio =
      found.values[force_y] / inputs[wheel == 1 ? left_load : right_load];
    return found;
  }

  void Wheelset::check() const
  {
    const auto is_finite = [](const double value) {
      return std::isfinite(value);
    };
    if (!(radius > 0. && tape_circle > 0. && is_finite(radius) &&
          is_finite(tape_circle) &&
          std::all_of(start.begin(), start.end(), is_finite)))
      throw std::invalid_argument(
        "lengths must be above 0, and all values finite");
  }

  WheelOutputs WheelsetModel::wheel(const Inputs      &inputs,
                                    const unsigned int wheel,
                                    const double       least_speed,
                                    double            &roll) const
  {
    const WheelQuestion asked = question_of(inputs, wheel, least_speed);
    const double        rolled =
      table.resting_roll(asked.on_own, asked.on_other, asked.yaw) +
      asked.rail_down / (2 * tape_circle);
    roll = (wheel == 1 ? -1. : 1.) * rolled;
    if (asked.load <= 0.)
      return {};
    // a wheel that is rolled more than the states of its place is one that is
    // shifted
    double shift = asked.on_own;
    for (unsigned int k = 0; k < rounds_of_roll; ++k)
      shift = asked.on_own -
              radius * (rolled - table.resting_roll(shift, shift, asked.yaw));
    const auto [along, across] = creepages(asked.motion, asked.yaw);
    const double      mu       = asked.friction;
    const TableValues values   = table.at({{shift,
                                            asked.yaw,
                                            asked.motion.turn,
                                            asked.load,
                                            (along - table.offset(shift)) / mu,
                                            across / mu,
                                            mu}});
    return outputs_of(values.values,
                      values.inside && inputs[speed] >= least_speed,
                      inputs,
                      wheel);
  }

  Outputs WheelsetModel::evaluate(const Inputs &inputs,
                                  const double  least_speed) const
  {
    Outputs found;
    for (unsigned int k : {1, 0})
      found.wheels[k] = wheel(inputs, k, least_speed, found.roll);
    return found;
  }

  std::string WheelsetModel::bytes() const
  {
    std::vector<double> all{radius, tape_circle};
    all.insert(all.end(), start.begin(), start.end());
    const auto more = table.numbers();
    all.insert(all.end(), more.begin(), more.end());
    std::string text(mark_of_model);
    text.append(reinterpret_cast<const char *>(all.data()),
                all.size() * sizeof(double));
    return text;
  }

  WheelsetModel WheelsetModel::of_bytes(const std::string &bytes)
  {
    const std::size_t head = std::strlen(mark_of_model);
    if (bytes.compare(0, head, mark_of_model) != 0 ||
        (bytes.size() - head) % sizeof(double) != 0)
      throw std::invalid_argument("it is not a table of this version");
    std::vector<double> all((bytes.size() - head) / sizeof(double));
    std::memcpy(all.data(), bytes.data() + head, bytes.size() - head);
    std::size_t   at = 2 + n_inputs;
    WheelsetModel model;
    if (all.size() < at)
      throw std::invalid_argument("the table ends too early");
    model.radius      = all[0];
    model.tape_circle = all[1];
    std::copy_n(all.begin() + 2, std::size_t(n_inputs), model.start.begin());
    model.check();
    model.table = WheelTable::of_numbers(all, at);
    if (at != all.size())
      throw std::invalid_argument("there is more than a table");
    return model;
  }
} // namespace RollingContact::Fmu
