#include <rolling_contact/analyses/corrugation.h>
#include <rolling_contact/analyses/disturbed_waves.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/run/progress.h>
#include <rolling_contact/scene/shared_rules.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    const char corrugation_file[] = "corrugation.csv";
    const char peaks_file[]       = "corrugation_peaks.csv";

    /// part of the nodes about to slip or stick from which on growth is that
    /// of one side
    const double many_at_border = 0.05;

    /// answers of whole bodies to a wave, each from the one before
    const unsigned int whole_steps = 3;
  } // namespace

  template <int dim>
  Corrugation<dim>::Corrugation(const Situation &scene, RunContext &context)
    : scene(scene)
    , context(context)
    , section(scene.inputs->own<CorrugationParameters>())
    , wavelengths(section.wavelengths_round(scene.wheel.radius))
    , speeds(section.speeds_or(std::abs(scene.contact.rolling_speed())))
  {}

  template <int dim>
  void Corrugation<dim>::require_elements(const SteadyState<dim> &steady) const
  {
    const double element = steady.grading.element_size_x;
    if (wavelengths.front() < least_elements_of_wave * element)
      throw InputError(
        "Corrugation/Wavelengths = " + section.wavelengths +
        ": elements along x are " + significant(1e3 * element, 3) +
        " mm long, and a wave needs " + significant(least_elements_of_wave, 1) +
        " of them; the shortest must have at least " +
        significant(1e3 * least_elements_of_wave * element, 3) +
        " mm, or take more Mesh/Elements across patch.");
    check_followed_wave(section, scene.wheel.radius, 0., 0., element);
  }

  template <int dim>
  void Corrugation<dim>::warn_of_border(const LinearContact &contact) const
  {
    const double n        = contact.touching.size();
    const double n_border = contact.n_slipping + contact.n_sticking;
    if (n_border > many_at_border * n)
      context.log.warning(
        significant(100 * n_border / n, 2) +
        " % of the touching nodes are about to slip or to stick, where growth "
        "differs on either side: the creepage is close to saturation. Change "
        "Contact/Creepage or the load by a few percent and compare.");
  }

  template <int dim>
  std::vector<CorrugationRow>
  Corrugation<dim>::sweep(const WaveSweep              &whole,
                          const std::vector<WaveSweep> &halves,
                          const std::optional<double>  &pad_offset) const
  {
    const double                k_w = section.wear_coefficient;
    std::vector<CorrugationRow> found(speeds.size() * wavelengths.size());
    for (std::size_t j = 0; j < wavelengths.size(); ++j)
      {
        throw_if_interrupted();
        const double                         k      = 2 * pi / wavelengths[j];
        const auto                           modal  = whole.modal(k);
        const auto                           passed = whole.at(k, modal);
        std::vector<std::vector<PassedWave>> of_halves;
        for (const WaveSweep &half : halves)
          try
            {
              of_halves.push_back(half.at(k, modal));
            }
          catch (const ConvergenceError &)
            {} // it tells nothing of errors
        for (std::size_t v = 0; v < speeds.size(); ++v)
          {
            CorrugationRow &row = found[v * wavelengths.size() + j];
            row.pad_offset      = pad_offset;
            row.speed           = speeds[v];
            row.wavelength      = wavelengths[j];
            row.passed          = passed[v];
            row.passed.growth.by_traction *= k_w;
            row.passed.growth.by_slip *= k_w;
            std::vector<double> rates;
            for (const auto &half : of_halves)
              rates.push_back(k_w * half[v].growth.total().real());
            row.uncertainty = uncertainty_by_halves(row.rate(), rates);
          }
      }
    return found;
  }

  template <int dim>
  void Corrugation<dim>::prove_fastest(const Situation             &at,
                                       const RollingModes<dim>     &rolling,
                                       const WaveSweep             &waves,
                                       std::vector<CorrugationRow> &found) const
  {
    CorrugationRow &most =
      *std::max_element(found.begin(), found.end(), grows_less);
    RollingConditions conditions = conditions_of_waves(at, most.speed);
    conditions.hysteretic        = false; // they begin with viscous modes
    const WholeBodies<dim> bodies(rolling, conditions);
    const std::size_t      speed =
      std::find(speeds.begin(), speeds.end(), most.speed) - speeds.begin();
    const PassedWave passed = waves.corrected(
      2 * pi / most.wavelength,
      speed,
      [&](const ComplexValues &s, const std::vector<ComplexVector> &forces) {
        return bodies.response(s, forces);
      },
      whole_steps);
    most.of_whole_bodies =
      section.wear_coefficient * passed.growth.total().real();
  }

  template <int dim>
  void Corrugation<dim>::run_at(const Situation &at)
  {
    const std::optional<double> pad_offset = pad_offset_of(at);
    if (pad_offset && !section.pad_offsets.empty())
      context.log.message("Pads at " + significant(*pad_offset, 4) + " m.");
    SteadyState<dim> steady = track.state_at(at, context);
    require_elements(steady);
    const ModalBodies<dim> &modal = track.modes_of(steady, at, context);
    const RollingModes<dim> rolling(modal,
                                    *steady.pair,
                                    steady.problem.operators.W().dense());
    PhaseTimer::Scope       phase(context.timer, Phase::response);
    const auto              reduced = [&](const double speed) {
      return rolling.reduced(conditions_of_waves(at, speed));
    };
    const WaveSweep waves =
      waves_over(at, steady.problem, steady.state, speeds, reduced);
    warn_of_border(waves.contact());
    warn_of_fixed_edges(waves.contact(), at.contact.slip_operator, context.log);
    auto found =
      sweep(waves, waves_over_halves(at, steady, speeds, reduced), pad_offset);
    if (at.inputs->stability.correct)
      prove_fastest(at, rolling, waves, found);
    rows.insert(rows.end(), found.begin(), found.end());
    if (!section.follows_wave())
      return;
    const auto in_time = followed_waves(
      at, steady, waves, speeds, rows.back().pad_offset, context);
    followed.insert(followed.end(), in_time.begin(), in_time.end());
  }

  template <int dim>
  void Corrugation<dim>::run()
  {
    const auto places = section.places().situations(scene);
    for (const Situation &place : places)
      run_at(place);
    if (std::all_of(rows.begin(), rows.end(), [](const CorrugationRow &row) {
          return row.passed.growth.total() == 0.;
        }))
      throw InputError(
        "Analysis = corrugation: nothing slides, so that no wave "
        "changes; give Contact/Creepage x, Creepage y or Spin.");

    ResultsTable table(context.folder, corrugation_file),
      peaks(context.folder, peaks_file);
    for (const CorrugationRow &row : rows)
      add_row(row, section, table);
    for (const std::size_t i : peaks_of_growth(rows))
      add_row(rows[i], section, peaks);
    table.flush();
    peaks.flush();
    context.log.message(peaks.screen_table({"pad_offset_m",
                                            "speed_m/s",
                                            "wavelength_m",
                                            "frequency_Hz",
                                            "growth_of_passages",
                                            "growth_dB/1e6"}));
    context.report.set_finding("waves", verdict(rows, section));
    report_followed_waves(followed, context);
    note_errors();
    if (scene.inputs->output.plot)
      plot_growth(rows, section, context);
  }

  template <int dim>
  void Corrugation<dim>::note_errors() const
  {
    const CorrugationRow &most =
      *std::max_element(rows.begin(), rows.end(), grows_less);
    double                largest = 0.;
    std::optional<double> of_patch, of_bodies;
    const auto keep_larger = [](std::optional<double> &all, const double one) {
      all = std::max(all.value_or(0.), one);
    };
    for (const CorrugationRow &row : rows)
      {
        largest = std::max(largest, std::abs(row.passed.growth.total()));
        if (row.uncertainty)
          keep_larger(of_patch, *row.uncertainty);
        if (row.of_whole_bodies)
          keep_larger(of_bodies, std::abs(*row.of_whole_bodies - row.rate()));
      }
    if (of_patch)
      context.report.errors.push_back(
        {"growth of waves",
         *of_patch / largest,
         "the largest |G|",
         "elements of twice the length",
         true,
         most.uncertainty
           ? significant(*most.uncertainty / std::abs(most.rate()), 2) +
               " of the one that grows most"
           : ""});
    else
      warn_of_unknown_halves("growth", context.log);
    if (of_bodies)
      context.report.errors.push_back({"growth of waves by modes",
                                       *of_bodies / largest,
                                       "the largest |G|",
                                       "whole bodies",
                                       false,
                                       "where it is largest"});
  }

  template class Corrugation<2>;
  template class Corrugation<3>;

  namespace
  {
    void check_waves(const SceneParameters &scene)
    {
      const auto  &section = scene.own<CorrugationParameters>();
      const double fastest =
        section.speeds_or(std::abs(scene.contact.speed.value_or(0.))).back();
      const double shortest =
        section.wavelengths_round(scene.wheel.radius).front();
      const double highest = fastest / shortest;
      if (highest > scene.modes.maximum_frequency)
        throw InputError(
          "Modes/Maximum frequency = " +
          text_of(scene.modes.maximum_frequency) + " Hz: waves of " +
          significant(1e3 * shortest, 3) + " mm at " + significant(fastest, 3) +
          " m/s pass with " + significant(highest, 4) +
          " Hz; give as much, or longer Corrugation/Wavelengths.");
      check_followed_wave(section,
                          scene.wheel.radius,
                          fastest,
                          scene.modes.maximum_frequency,
                          0.);
    }

    void check_wearing(const SceneParameters &scene)
    {
      const std::string why     = "Analysis = corrugation: ";
      const auto       &contact = scene.contact;
      if (contact.friction_coefficient == 0.)
        throw InputError(why + "Contact/Friction coefficient = 0: without "
                               "friction nothing wears; give one above 0.");
      const Creepages asked = contact.asked_creepages();
      if (!scene.profiles.in_use() && !contact.forces.any() && asked.x == 0. &&
          asked.y == 0. && asked.spin == 0.)
        throw InputError(why + "Contact/Creepage x, Creepage y and Spin are 0: "
                               "without creepage nothing wears; give one.");
      const auto &section = scene.own<CorrugationParameters>();
      check_speeds_of_state(scene, "Corrugation/Speeds", section.speeds);
      section.places().check(scene.rail);
    }
  } // namespace

  AnalysisKind corrugation_kind()
  {
    AnalysisKind kind = kind_of<Corrugation>(
      "corrugation",
      "whether waves on rail or wheel grow by wear, for each wavelength, "
      "speed and place in the track, see section Corrugation");
    kind.sections = {"Modes", "Stability", "Corrugation"};
    kind.own_section.emplace(CorrugationParameters());
    kind.axes = [](const SceneParameters &scene) -> std::vector<TableAxis> {
      return scene.own<CorrugationParameters>().places().axes();
    };
    kind.linearises   = true;
    kind.passes_waves = true;
    kind.has_dampers  = true;
    kind.on_ranks     = false;
    kind.rules        = {&check_linearised_state, &check_waves, &check_wearing};
    return kind;
  }
} // namespace RollingContact
