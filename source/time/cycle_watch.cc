#include <rolling_contact/time/checkpoint.h>
#include <rolling_contact/time/cycle_watch.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    const std::vector<std::string> velocities{"velocity_x_m/s",
                                              "velocity_y_m/s",
                                              "velocity_z_m/s"},
      forces{"normal_force_N", "force_x_N", "force_y_N"},
      others{"creepage_x",
             "creepage_y",
             "nodes_in_contact",
             "nodes_sticking",
             "kinetic_J",
             "strain_J",
             "supplied_J",
             "friction_J",
             "damping_J",
             "numerical_J"};

    /// of the rolling speed, of the largest load: what is below is no motion
    const double least_velocity = 1e-9, least_force = 3e-8;
  } // namespace

  CycleWatch::CycleWatch(const Situation &scene, const double step)
    : step(step)
    , tolerance(scene.inputs->time.periodic_tolerance)
    , speed(std::abs(scene.contact.rolling_speed()))
    , left_out(std::llround(scene.inputs->time.periodic_after / step))
  {
    for (const auto *names : {&velocities, &forces, &others})
      for (const std::string &name : *names)
        columns[name];
  }

  void CycleWatch::add_row(const std::vector<std::string> &names,
                           const std::vector<double>      &row)
  {
    for (std::size_t k = 0; k < names.size(); ++k)
      if (const auto wanted = columns.find(names[k]); wanted != columns.end())
        wanted->second.push_back(row[k]);
  }

  void CycleWatch::restore(const HistoryTable &history)
  {
    std::vector<std::string> names;
    for (const auto &[name, values] : columns)
      names.push_back(name);
    columns = history.columns(names);
  }

  std::size_t CycleWatch::n_rows() const
  {
    return column("normal_force_N").size();
  }

  bool CycleWatch::settled()
  {
    return Cycles::is_due(n_rows()) && verdict().is_final();
  }

  const Cycles::Verdict &CycleWatch::verdict()
  {
    if (judged != n_rows() || judged == 0)
      last = Cycles::judge(motion(), left_out, tolerance);
    judged = n_rows();
    return last;
  }

  Cycles::SampledMotion CycleWatch::motion() const
  {
    const auto  &load = column("normal_force_N");
    const double largest =
      load.empty() ? 0. : *std::max_element(load.begin(), load.end());
    Cycles::SampledMotion result{step, {}};
    for (const std::string &name : velocities)
      if (column(name).size() == load.size())
        result.signals.push_back({column(name), 0, least_velocity * speed});
    for (const std::string &name : forces)
      if (column(name).size() == load.size())
        result.signals.push_back({column(name), 1, least_force * largest});
    return result;
  }
} // namespace RollingContact
