#include <rolling_contact/analyses/corrugation_check.h>
#include <rolling_contact/analyses/disturbed_waves.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/vibration/vibrations.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    const char check_file[] = "corrugation_check.csv";

    std::string name_of(const CheckedWave &it)
    {
      return significant(1e3 * it.wavelength, 3) + " mm at " +
             significant(it.speed, 3) + " m/s" +
             (it.pad_offset
                ? ", pad offset " + significant(*it.pad_offset, 3) + " m"
                : "");
    }

    std::string comparison(const CheckedWave &it)
    {
      return "in time " + significant(std::abs(it.ratio()), 5) +
             " times the growth of a small wave, " +
             significant(it.phase(), 2) + " degrees ahead of it, " +
             std::to_string(it.in_time.n_changed) +
             " nodes changing between open, stick and slip";
    }
  } // namespace

  double CheckedWave::phase() const
  {
    return std::arg(ratio()) * 180 / pi;
  }

  void check_followed_wave(const CorrugationParameters &section,
                           const double                 radius,
                           const double                 fastest,
                           const double                 highest_frequency,
                           const double                 element)
  {
    if (!section.follows_wave())
      return;
    const double      length = section.check_wavelength_round(radius);
    const std::string entry =
      "Corrugation/Check wavelength = " + text_of(section.check_wavelength) +
      " m: ";
    if (fastest / length > highest_frequency)
      throw InputError(
        entry + "at " + significant(fastest, 3) + " m/s it passes with " +
        significant(fastest / length, 4) +
        " Hz, beyond Modes/Maximum frequency = " + text_of(highest_frequency) +
        " Hz; take at least " + significant(fastest / highest_frequency, 3) +
        " m, or modes up to there.");
    if (length < least_elements_of_wave * element)
      throw InputError(
        entry + "elements along x are " + significant(1e3 * element, 3) +
        " mm long, and a wave needs " + significant(least_elements_of_wave, 1) +
        " of them; take at least " +
        significant(least_elements_of_wave * element, 3) +
        " m, or more Mesh/Elements across patch.");
  }

  template <int dim>
  std::vector<CheckedWave> followed_waves(const Situation             &at,
                                          const SteadyState<dim>      &steady,
                                          const WaveSweep             &waves,
                                          const std::vector<double>   &speeds,
                                          const std::optional<double> &offset,
                                          RunContext                  &context)
  {
    const auto  &section = at.inputs->own<CorrugationParameters>();
    const double length  = section.check_wavelength_round(at.wheel.radius);
    FollowedWave wave;
    wave.wave_number  = 2 * pi / length;
    wave.amplitude    = section.check_amplitude;
    wave.tolerance    = std::min(wave.tolerance, at.solver.controls.tolerance);
    const auto border = steady.pair->trace().border_nodes();
    const auto linear =
      waves.at(wave.wave_number, waves.modal(wave.wave_number));
    std::vector<CheckedWave> result;
    for (std::size_t v = 0; v < speeds.size(); ++v)
      {
        wave.speed   = speeds[v];
        wave.n_steps = steps_of_period(waves.bodies(v),
                                       wave.speed,
                                       wave.wave_number,
                                       steady.grading.element_size_x);
        CheckedWave it;
        it.pad_offset = offset;
        it.speed      = speeds[v];
        it.wavelength = length;
        it.amplitude  = wave.amplitude;
        it.growth     = section.wear_coefficient * linear[v].growth.total();
        it.load       = linear[v].load;
        it.in_time    = wave_in_time(steady.problem,
                                  steady.state,
                                  linear_contact_options(at),
                                  waves,
                                  v,
                                  wave,
                                  border);
        it.in_time.growth *= section.wear_coefficient;
        context.log.message("A wave of " + name_of(it) + ": " + comparison(it) +
                            ".");
        if (!it.in_time.settled)
          context.log.warning(
            "The wave of " + name_of(it) +
            " did not settle in time: its growth "
            "changed by " +
            significant(100 * it.in_time.change, 2) + " % in the last of " +
            std::to_string(it.in_time.n_periods) +
            " periods. The steady state may not be stable; see Analysis = "
            "stability.");
        result.push_back(it);
      }
    return result;
  }

  void report_followed_waves(const std::vector<CheckedWave> &found,
                             RunContext                     &context)
  {
    if (found.empty())
      return;
    ResultsTable table(context.folder, check_file);
    for (const CheckedWave &it : found)
      {
        table.set("pad_offset_m", it.pad_offset);
        table.set("speed_m/s", it.speed);
        table.set("wavelength_m", it.wavelength);
        table.set("amplitude_m", it.amplitude);
        table.set("growth", it.growth.real());
        table.set("growth_imaginary", it.growth.imag());
        table.set("growth_in_time", it.in_time.growth.real());
        table.set("growth_in_time_imaginary", it.in_time.growth.imag());
        table.set("growth_ratio", std::abs(it.ratio()));
        table.set("growth_phase_deg", it.phase());
        table.set("load_ratio", std::abs(it.in_time.load / it.load));
        table.set("load_phase_deg",
                  std::arg(it.in_time.load / it.load) * 180 / pi);
        table.set("n_periods", it.in_time.n_periods);
        table.set("change", it.in_time.change);
        table.set("n_changed", it.in_time.n_changed);
        table.end_row();
      }
    table.flush();
    const auto most = std::max_element(found.begin(),
                                       found.end(),
                                       [](const auto &a, const auto &b) {
                                         return std::abs(a.ratio() - 1.) <
                                                std::abs(b.ratio() - 1.);
                                       });
    context.report.set_finding("check",
                               (found.size() > 1 ? "farthest off: " : "") +
                                 name_of(*most) + ", " + comparison(*most));
  }

  template std::vector<CheckedWave>
  followed_waves(const Situation &,
                 const SteadyState<2> &,
                 const WaveSweep &,
                 const std::vector<double> &,
                 const std::optional<double> &,
                 RunContext &);
  template std::vector<CheckedWave>
  followed_waves(const Situation &,
                 const SteadyState<3> &,
                 const WaveSweep &,
                 const std::vector<double> &,
                 const std::optional<double> &,
                 RunContext &);
} // namespace RollingContact
