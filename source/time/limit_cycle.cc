#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/time/limit_cycle.h>

#include <cmath>
#include <functional>

namespace RollingContact
{
  namespace
  {
    const std::size_t n_harmonics = 10;

    /** A column of the history and what it is called in a cycle. */
    struct Quantity
    {
      std::string column, name, unit;
    };

    const std::vector<Quantity> recorded_velocities{
      {"velocity_x_m/s", "velocity_x", "m/s"},
      {"velocity_y_m/s", "velocity_y", "m/s"},
      {"velocity_z_m/s", "velocity_z", "m/s"}},
      recorded_forces{{"normal_force_N", "normal_force", "N"},
                      {"force_x_N", "force_x", "N"},
                      {"force_y_N", "force_y", "N"}};
  } // namespace

  LimitCycle::LimitCycle(CycleWatch                                &watch,
                         const std::optional<std::complex<double>> &eigenvalue)
    : watch(watch)
    , verdict(watch.verdict())
    , eigenvalue(eigenvalue)
  {
    if (verdict.motion != Cycles::Motion::too_short)
      whole.emplace(is_periodic() ? verdict.period.length
                                  : verdict.n_judged - 1.,
                    watch.n_rows(),
                    verdict.n_judged);
  }

  LimitCycle::Shares LimitCycle::shares() const
  {
    Shares        result;
    const Values &load     = column("normal_force_N"),
                 &touching = column("nodes_in_contact"),
                 &sticking = column("nodes_sticking");
    std::size_t n = 0, n_touching = 0;
    for (std::size_t t = whole->first_sample(); t < load.size(); ++t)
      {
        ++n;
        result.stick_time += sticking[t] > 0.;
        result.sticking += sticking[t];
        result.open_time += !(load[t] > 0.);
        n_touching += touching[t] > 0.;
        result.stick_node += touching[t] > 0. ? sticking[t] / touching[t] : 0.;
      }
    result.sticking /= std::max(1., result.stick_time);
    result.stick_time /= n;
    result.open_time /= n;
    result.stick_node /= std::max<std::size_t>(1, n_touching);
    return result;
  }

  std::vector<std::pair<std::string, double>> LimitCycle::energies() const
  {
    Values stored = column("kinetic_J");
    for (std::size_t t = 0; t < stored.size(); ++t)
      stored[t] += column("strain_J")[t];
    const auto change = [&](const Values &energy) {
      return is_periodic() ? whole->change(energy) : 0.;
    };
    const double drive = change(column("supplied_J")),
                 heat  = change(column("friction_J"));
    return {{"cycle_drive_J", drive},
            {"cycle_heat_J", heat},
            {"cycle_vibration_J", drive - heat},
            {"cycle_damping_J", change(column("damping_J"))},
            {"cycle_numerical_J", change(column("numerical_J"))},
            {"cycle_stored_J", change(stored)}};
  }

  void LimitCycle::add_ranges(ResultsTable &row) const
  {
    const auto add = [&](const Quantity                              &quantity,
                         const std::string                           &what,
                         const std::function<double(const Values &)> &value) {
      const std::string name =
        "cycle_" + quantity.name + "_" + what + "_" + quantity.unit;
      const bool known = whole && has(quantity.column);
      row.set_if(known, name, known ? value(column(quantity.column)) : 0.);
    };
    for (const Quantity &velocity : recorded_velocities)
      {
        add(velocity, "amplitude", [&](const Values &x) {
          return (whole->most(x) - whole->least(x)) / 2;
        });
        add(velocity, "rms", [&](const Values &x) { return whole->rms(x); });
      }
    for (const Quantity &force : recorded_forces)
      {
        add(force, "least", [&](const Values &x) { return whole->least(x); });
        add(force, "most", [&](const Values &x) { return whole->most(x); });
      }
  }

  void LimitCycle::add_columns(ResultsTable &row) const
  {
    row.set("cycle", Cycles::name_of(verdict.motion));
    const bool periodic = is_periodic(), known = whole.has_value();
    row.set_if(periodic, "cycle_frequency_Hz", verdict.frequency());
    row.set_if(verdict.period.length > 0.,
               "cycle_difference",
               verdict.period.difference);
    row.set_if(known, "cycle_amplitude_rate_1/s", verdict.amplitude.rate);
    add_ranges(row);
    const Shares share = known ? shares() : Shares();
    row.set_if(known, "cycle_stick_time_share", share.stick_time);
    row.set_if(known, "cycle_stick_node_share", share.stick_node);
    row.set_if(known, "cycle_open_time_share", share.open_time);
    for (const auto &[name, value] : energies())
      row.set_if(periodic, name, value);
  }

  void LimitCycle::note(RunContext &context) const
  {
    std::string text = Cycles::sentence(verdict);
    if (is_periodic() && eigenvalue)
      text += "; the vibration that it started in has " +
              significant(std::abs(eigenvalue->imag()) / (2 * pi), 6) +
              " Hz and grows by " + significant(eigenvalue->real(), 4) +
              " 1/s while it is small";
    context.report.set_finding("cycle", text);
    if (verdict.motion == Cycles::Motion::changing ||
        verdict.motion == Cycles::Motion::too_short)
      context.log.warning("The motion is not known to be a limit cycle: " +
                          Cycles::sentence(verdict) +
                          ". Take a later Time/End time; --resume continues "
                          "the run.");
    if (!is_periodic())
      return;
    const std::string along    = std::string(1, direction());
    const Values     &velocity = column("velocity_" + along + "_m/s"),
                 &force        = column("force_" + along + "_N"),
                 &load         = column("normal_force_N");
    const Shares share         = shares();
    context.report.set_finding(
      "motion",
      "along " + along + " " +
        significant((whole->most(velocity) - whole->least(velocity)) / 2, 4) +
        " m/s (amplitude), " + significant(whole->rms(velocity), 4) +
        " m/s (rms); N " + significant(whole->least(load), 5) + " to " +
        significant(whole->most(load), 5) + " N, T_" + along + " " +
        significant(whole->least(force), 5) + " to " +
        significant(whole->most(force), 5) + " N; nodes stick " +
        significant(100 * share.stick_time, 3) + " % of the time, " +
        significant(100 * share.stick_node, 3) +
        " % of those that touch; no contact " +
        significant(100 * share.open_time, 3) + " % of the time");
    if (share.sticking > 0.)
      {
        // each border of the zone may be off by a node
        const double error = 2 / share.sticking;
        context.report.errors.push_back(
          {"amplitude of the cycle",
           error,
           "itself",
           "two nodes of the " + significant(share.sticking, 2) +
             " that stick on average while any do; these limit it",
           true,
           "so power " + significant(std::pow(1. + error, 2) - 1., 2) +
             " of itself, levels " +
             significant(20. * std::log10(1. + error), 2) + " dB"});
      }
    const auto energy = energies();
    context.report.set_finding(
      "work",
      "in a cycle: drive " + significant(energy[0].second, 5) + " J, heat " +
        significant(energy[1].second, 5) + " J, to the vibration " +
        significant(energy[2].second, 4) + " J, of which damping " +
        significant(energy[3].second, 4) + " J and the scheme " +
        significant(energy[4].second, 2) + " J");
  }

  void LimitCycle::write_harmonics(RunContext &context) const
  {
    if (!is_periodic())
      return;
    ResultsTable        table(context.folder, "cycle.csv");
    std::vector<Values> amplitudes;
    Values              means;
    std::size_t         n = n_harmonics;
    for (const auto *quantities : {&recorded_velocities, &recorded_forces})
      for (const Quantity &quantity : *quantities)
        {
          const Values &values = column(quantity.column);
          amplitudes.push_back(
            values.empty() ? Values() : whole->harmonics(values, n_harmonics));
          means.push_back(values.empty() ? 0. : whole->mean(values));
          if (!values.empty())
            n = std::min(n, amplitudes.back().size());
        }
    for (std::size_t k = 0; k <= n; ++k)
      {
        table.set("harmonic", k);
        table.set("frequency_Hz", k * verdict.frequency());
        std::size_t i = 0;
        for (const auto *quantities : {&recorded_velocities, &recorded_forces})
          for (const Quantity &quantity : *quantities)
            {
              const std::string full = quantity.name + "_" + quantity.unit;
              if (!has(quantity.column))
                table.leave_empty(full);
              else
                table.set(full, k == 0 ? means[i] : amplitudes[i][k - 1]);
              ++i;
            }
        table.end_row();
      }
    table.flush();
  }

  char LimitCycle::direction() const
  {
    const Values &x = column("velocity_x_m/s"), &y = column("velocity_y_m/s");
    return !y.empty() && whole->rms(y) >= whole->rms(x) ? 'y' : 'x';
  }
} // namespace RollingContact
