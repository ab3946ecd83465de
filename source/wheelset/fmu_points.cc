#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/tables/session.h>
#include <rolling_contact/wheelset/fmu_points.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace RollingContact
{
  namespace
  {
    const double moved_rail = 5e-4; ///< m, most that a rail moves

    const std::size_t enough_points = 10;
    const double      least_margin  = 0.1;

    /** A point within the intervals of the axes, each as likely as others. */
    Fmu::Coordinates random_point(const FmuStates &states, std::mt19937 &random)
    {
      Fmu::Coordinates                       point;
      std::uniform_real_distribution<double> part(0., 1.);
      for (std::size_t d = 0; d < Fmu::n_axes; ++d)
        {
          const auto &axis = states.axes[d];
          point[d]         = axis[0];
          const double at  = part(random) * (axis.size() - 1);
          const auto   k   = static_cast<std::size_t>(at);
          if (k + 1 < axis.size())
            point[d] = axis[k] + (at - k) * (axis[k + 1] - axis[k]);
        }
      return point;
    }

    /** A wheel that is asked for: inputs of the FMU, entries of the scene. */
    struct Asked
    {
      bool        is_left;
      Fmu::Inputs inputs;
    };

    Asked ask(const FmuStates   &states,
              const unsigned int number,
              std::mt19937      &random,
              Session           &session)
    {
      Fmu::Coordinates point = random_point(states, random);
      Asked            asked{number % 3 == 1, {}};
      asked.inputs             = states.inputs_at(point, asked.is_left);
      const auto   names       = FmuStates::entries();
      const auto   values      = states.entries_of(point);
      const double side        = asked.is_left ? -1. : 1.;
      const double own         = point[Fmu::shift_axis];
      double       other_shift = own;
      if (number % 3 == 2)
        {
          // the rail of the other wheel moves
          const auto &axis = states.axes[Fmu::shift_axis];
          std::uniform_real_distribution<double> move(-moved_rail, moved_rail);
          const double                           moved = move(random);
          other_shift = std::clamp(own - moved, axis.front(), axis.back());
          asked.inputs[Fmu::left_rail_y] = own - other_shift;
        }
      for (std::size_t k = 0; k < names.size(); ++k)
        {
          const bool is_odd = names[k] == "Profiles/Lateral shift" ||
                              names[k] == "Profiles/Yaw" ||
                              names[k] == "Profiles/Curve radius" ||
                              names[k] == "Profiles/Lateral velocity";
          session.set(names[k], is_odd ? side * values[k] : values[k]);
        }
      session.set("Profiles/Side", asked.is_left ? "left" : "right");
      session.set("Profiles/Roll",
                  side * states.resting_roll(own,
                                             other_shift,
                                             point[Fmu::yaw_axis]));
      return asked;
    }

    /** A point that is solved. */
    struct Solved
    {
      Asked       asked;
      TrackForces forces;
      double      friction = 0.; ///< that the wheel can carry, N

      Fmu::WheelOutputs told_by(const Fmu::WheelsetModel &model) const
      {
        return model.evaluate(asked.inputs, Fmu::default_least_speed)
          .wheels[asked.is_left ? 1 : 0];
      }

      /** Difference of the force vectors, N. */
      double error(const Fmu::WheelOutputs &told) const
      {
        return std::hypot(told.values[Fmu::force_x] - forces.force_x,
                          told.values[Fmu::force_y] - forces.force_y,
                          told.values[Fmu::force_z] - forces.force_z);
      }
    };

    /**
     * How wide the part of the bound that is of interpolation must be for it to
     * hold at every second point, and a half more; not less than it is with few
     * points. Unit: 1.
     */
    double margin_for(const std::vector<Solved> &points,
                      Fmu::WheelsetModel         model)
    {
      double      largest = 0.;
      std::size_t n       = 0;
      for (std::size_t k = 0; k < points.size(); k += 2)
        {
          model.table.margin           = 1.;
          const Fmu::WheelOutputs told = points[k].told_by(model);
          if (!told.inside) // as the other rail has moved
            continue;
          model.table.margin = 2.;
          const double bound = told.values[Fmu::force_bound],
                       between =
                         points[k].told_by(model).values[Fmu::force_bound] -
                         bound;
          ++n;
          if (between > 0.)
            largest =
              std::max(largest, 1. + (points[k].error(told) - bound) / between);
        }
      return std::max(n < enough_points ? 1. : least_margin, 1.5 * largest);
    }

    void add_row(const Solved            &point,
                 const Fmu::WheelOutputs &told,
                 ResultsTable            &rows)
    {
      const Fmu::Inputs &in   = point.asked.inputs;
      const bool         left = point.asked.is_left;
      rows.set("wheel", std::string(left ? "left" : "right"));
      rows.set("lateral_shift_m", in[Fmu::lateral_shift]);
      rows.set("yaw_rad", in[Fmu::yaw]);
      rows.set("lateral_velocity_m/s", in[Fmu::lateral_velocity]);
      rows.set("axle_speed_rad/s", in[Fmu::axle_speed]);
      rows.set("curvature_1/m", in[Fmu::curvature]);
      rows.set("friction_coefficient", in[Fmu::friction]);
      rows.set("load_N", in[left ? Fmu::left_load : Fmu::right_load]);
      rows.set("other_rail_y_m", in[Fmu::left_rail_y]);
      rows.set("force_x_N", point.forces.force_x);
      rows.set("force_y_N", point.forces.force_y);
      rows.set("force_z_N", point.forces.force_z);
      rows.set("fmu_force_x_N", told.values[Fmu::force_x]);
      rows.set("fmu_force_y_N", told.values[Fmu::force_y]);
      rows.set("fmu_force_z_N", told.values[Fmu::force_z]);
      rows.set("error_N", point.error(told));
      rows.set_if(told.inside, "force_bound_N", told.values[Fmu::force_bound]);
      rows.set("inside_table", told.inside);
      rows.end_row();
    }

    /** What is known of every other point, which the margin does not know. */
    void judge(const std::vector<Solved> &points,
               const Fmu::WheelsetModel  &model,
               ResultsTable              &rows,
               FmuErrors                 &found)
    {
      std::vector<double> errors;
      for (std::size_t k = 0; k < points.size(); ++k)
        {
          const Fmu::WheelOutputs told = points[k].told_by(model);
          add_row(points[k], told, rows);
          if (k % 2 == 0 || !told.inside)
            continue;
          const double error = points[k].error(told);
          errors.push_back(error / points[k].friction);
          found.n_within += error <= told.values[Fmu::force_bound];
        }
      found.n = errors.size();
      if (errors.empty())
        return;
      std::sort(errors.begin(), errors.end());
      found.median = errors[errors.size() / 2];
      found.most   = errors.back();
    }
  } // namespace

  FmuErrors measure_fmu(const Situation    &scene,
                        const FmuStates    &states,
                        const unsigned int  n_points,
                        Fmu::WheelsetModel &model,
                        RunContext         &context)
  {
    FmuErrors           found;
    ResultsTable        rows(context.folder, "fmu_points.csv");
    Session             session(scene);
    std::mt19937        random(1);
    std::vector<Solved> points;
    for (unsigned int k = 0; k < n_points; ++k)
      {
        throw_if_interrupted();
        const Asked         asked  = ask(states, k, random, session);
        const SessionState &solved = session.solve();
        if (solved.converged)
          points.push_back(
            {asked, *solved.track_forces, solved.forces.friction_force});
        else
          ++found.n_unsolved;
      }
    model.table.margin = margin_for(points, model);
    judge(points, model, rows, found);
    if (!points.empty())
      rows.flush();
    return found;
  }
} // namespace RollingContact
