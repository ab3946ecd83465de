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

  WheelOutputs WheelsetModel::wheel(const Inputs      &inputs,
                                    const unsigned int wheel,
                                    const double       least_speed,
                                    double            &roll) const
  {
    const bool   is_left  = wheel == 1;
    const double side     = is_left ? -1. : 1.;
    const Input  own_y    = is_left ? left_rail_y : right_rail_y,
                other_y   = is_left ? right_rail_y : left_rail_y,
                own_z     = is_left ? left_rail_z : right_rail_z,
                other_z   = is_left ? right_rail_z : left_rail_z,
                load      = is_left ? left_load : right_load;
    const double on_own   = side * (inputs[lateral_shift] - inputs[own_y]),
                 on_other = side * (inputs[lateral_shift] - inputs[other_y]),
                 yawed = side * inputs[yaw], Q = inputs[load],
                 V      = std::max(inputs[speed], least_speed);
    const double rolled = table.resting_roll(on_own, on_other, yawed) +
                          (inputs[own_z] - inputs[other_z]) / (2 * tape_circle);
    roll = side * rolled;
    // a wheel that is rolled more than the states of its place is one that is
    // shifted
    double shift = on_own;
    for (unsigned int k = 0; k < rounds_of_roll; ++k)
      shift =
        on_own - radius * (rolled - table.resting_roll(shift, shift, yawed));
    WheelOutputs found;
    if (Q <= 0.)
      return found;
    const WheelMotion motion{side * inputs[lateral_velocity] / V,
                             side * (inputs[curvature] + inputs[yaw_rate] / V),
                             inputs[axle_speed] / V};
    const auto [along, across] = creepages(motion, yawed);
    const double      mu       = std::max(inputs[friction], least_friction);
    const TableValues values   = table.at({{shift,
                                            yawed,
                                            motion.turn,
                                            Q,
                                            (along - table.offset(shift)) / mu,
                                            across / mu,
                                            mu}});
    found.values               = values.values;
    found.inside               = values.inside && inputs[speed] >= least_speed;
    for (const Quantity q :
         {force_y, moment_x, moment_z, place_y, contact_angle})
      found.values[q] *= side;
    found.values[place_y] += inputs[own_y];
    if (!found.inside)
      found.values[force_bound] = std::numeric_limits<double>::max();
    found.force_ratio = found.values[force_y] / Q;
    return found;
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
      throw std::invalid_argument("it is no table of this version");
    std::vector<double> all((bytes.size() - head) / sizeof(double));
    std::memcpy(all.data(), bytes.data() + head, bytes.size() - head);
    std::size_t   at = 2 + n_inputs;
    WheelsetModel model;
    if (all.size() < at)
      throw std::invalid_argument("the table ends too early");
    model.radius      = all[0];
    model.tape_circle = all[1];
    std::copy_n(all.begin() + 2, std::size_t(n_inputs), model.start.begin());
    for (std::size_t k = 0; k < at; ++k)
      if (!std::isfinite(all[k]) || (k < 2 && !(all[k] > 0.)))
        throw std::invalid_argument("a dimension of the wheelset is none");
    model.table = WheelTable::of_numbers(all, at);
    if (at != all.size())
      throw std::invalid_argument("there is more than a table");
    return model;
  }
} // namespace RollingContact::Fmu
