#include <rolling_contact/algebra/adaptive_integral.h>
#include <rolling_contact/analyses/disturbed_waves.h>
#include <rolling_contact/analyses/rolling_noise.h>
#include <rolling_contact/analyses/roughness_bands.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/scene/shared_rules.h>
#include <rolling_contact/time/a_weighting.h>
#include <rolling_contact/time/radiating_surface.h>
#include <rolling_contact/time/sound_pressure.h>
#include <rolling_contact/time/sound_report.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /// of powers of a band, by the error that its rule estimates
    const double tolerance = 0.001;

    /// lines of a band at which patches of longer elements are compared
    const int compared_lines = 9;
  } // namespace

  RollingNoise::RollingNoise(const Situation &scene, RunContext &context)
    : scene(scene)
    , context(context)
    , section(scene.inputs->own<RollingNoiseParameters>())
    , speeds(section.speeds_or(std::abs(scene.contact.rolling_speed())))
    , air(air_of(scene.inputs->sound))
    , roughness(roughness_of(scene))
  {}

  std::vector<Signals::ThirdOctave>
  RollingNoise::bands_at(const double speed) const
  {
    return bands_of_waves(roughness,
                          speed,
                          scene.inputs->modes.maximum_frequency);
  }

  void RollingNoise::find_radiators(const RollingModes<3> &rolling)
  {
    radiators.clear();
    for (const Side side : both_sides)
      if (const VibratingBody<3> *body = rolling.bodies().body(side))
        {
          Radiator radiator{side};
          if (body->is_without_ends())
            radiator.rail = std::make_shared<Sound::RadiatingRail>(
              *body, air, scene.inputs->stability.added_damping);
          else
            {
              radiator.body =
                Sound::radiating_body(*body,
                                      scene.inputs->modes.maximum_frequency,
                                      air);
              radiator.first = rolling.first_column(side);
            }
          if (radiator.rail || !radiator.body.frequencies.empty())
            radiators.push_back(std::move(radiator));
        }
    if (radiators.empty())
      throw InputError("Modes/Maximum frequency = " +
                       text_of(scene.inputs->modes.maximum_frequency) +
                       " Hz: no body has a mode below it, and the sound is "
                       "estimated from modes; give a higher frequency.");
  }

  double RollingNoise::Radiator::power(const PassingWaves::Passed &passed,
                                       const Eigen::Index          n_waves,
                                       const double                frequency,
                                       const Sound::Air           &air) const
  {
    if (rail)
      {
        const ComplexMatrix forces = passed.watched.leftCols(n_waves);
        return (forces.adjoint() * rail->power_form(frequency) * forces)
          .trace()
          .real();
      }
    return Sound::radiated_power(
      body,
      2 * pi * frequency *
        passed.amplitudes.block(first, 0, body.frequencies.size(), n_waves),
      frequency,
      air);
  }

  std::vector<PassingWaves>
  RollingNoise::passing_waves(const WaveSweep &sweep) const
  {
    std::vector<std::pair<double, double>> wave_numbers;
    for (const double speed : speeds)
      {
        const auto bands = bands_at(speed);
        wave_numbers.emplace_back(2 * pi * bands.front().lower_edge() / speed,
                                  2 * pi * bands.back().upper_edge() / speed);
      }
    const bool by_table = section.filter == ContactFilter::table;
    return RollingContact::passing_waves(
      sweep,
      speeds,
      wave_numbers,
      [&](const WaveGrowth &patch, const double wave_number) {
        ComplexMatrix waves = random_waves(patch.along(),
                                           patch.across(),
                                           by_table ? 0. : wave_number,
                                           section.coherence_of_waves());
        // at last the patch moves as one
        waves.conservativeResize(Eigen::NoChange, waves.cols() + 1);
        waves.rightCols(1).setOnes();
        return waves;
      });
  }

  Eigen::ArrayXd RollingNoise::unit_powers(const PassingWaves &waves,
                                           const ModalFactors &modal,
                                           const double        frequency,
                                           const double        speed) const
  {
    const auto         passed = waves.at(frequency, modal);
    const Eigen::Index n      = passed.loads.size() - 1;
    const double       filter =
      section.filter == ContactFilter::table
              ? std::pow(10., directive_contact_filter(load, speed / frequency) / 10)
              : 1.;
    Eigen::ArrayXd result = Eigen::ArrayXd::Zero(NoisePowers::weighted_wheel);
    for (const Radiator &it : radiators)
      result[it.side == Side::wheel ? NoisePowers::wheel : NoisePowers::rail] =
        filter * it.power(passed, n, frequency, air);
    result[NoisePowers::load] = filter * passed.loads.head(n).squaredNorm();
    result[NoisePowers::load_of_one] = std::norm(passed.loads[n]);
    return result;
  }

  NoiseBand RollingNoise::band_at(const PassingWaves         &waves,
                                  const Signals::ThirdOctave &third_octave,
                                  const double                speed)
  {
    throw_if_interrupted();
    const auto all = adaptive_integral(
      [&](const double logarithm) {
        const double f       = std::exp(logarithm),
                     density = roughness.density(speed / f),
                     a       = Sound::a_weighting(f);
        const Eigen::ArrayXd powers =
          density * unit_powers(waves, waves.modal(f), f, speed);
        Eigen::ArrayXd values(NoisePowers::n_values + 1);
        values << powers, a * powers.head(2), density;
        return values;
      },
      std::log(third_octave.lower_edge()),
      std::log(third_octave.upper_edge()),
      NoisePowers::load,
      tolerance);
    n_coarse += all.converged ? 0 : 1;
    NoiseBand band;
    band.centre        = third_octave.centre;
    band.roughness     = all.value[NoisePowers::n_values];
    band.powers.values = all.value.head(NoisePowers::n_values);
    return band;
  }

  std::optional<double> RollingNoise::uncertainty_at(
    const std::size_t                             v,
    const std::vector<PassingWaves>              &whole,
    const std::vector<std::vector<PassingWaves>> &halves,
    const NoiseOfSpeed                           &found) const
  {
    if (halves.empty())
      return {};
    // of all bands the weighted powers, each as its lines say
    std::vector<double> of_halves(halves.size(), 0.);
    for (const NoiseBand &band : found.bands)
      {
        double              of_whole = 0.;
        std::vector<double> sums(halves.size(), 0.);
        for (int i = 0; i < compared_lines; ++i)
          {
            const double f =
              band.centre *
              std::pow(10., 0.1 * ((i + 0.5) / compared_lines - 0.5));
            const ModalFactors modal = whole[v].modal(f);
            const auto         power = [&](const PassingWaves &waves) {
              const auto powers = unit_powers(waves, modal, f, found.speed);
              return powers[NoisePowers::wheel] + powers[NoisePowers::rail];
            };
            of_whole += power(whole[v]);
            for (std::size_t j = 0; j < halves.size(); ++j)
              sums[j] += power(halves[j][v]);
          }
        for (std::size_t j = 0; j < halves.size(); ++j)
          of_halves[j] += band.powers.weighted() * sums[j] / of_whole;
      }
    std::vector<double> levels;
    for (const double power : of_halves)
      levels.push_back(Sound::power_level(power));
    return uncertainty_by_halves(Sound::power_level(found.sum().weighted()),
                                 levels);
  }

  std::vector<NoiseOfSpeed> RollingNoise::noise_at(const Situation &at)
  {
    SteadyState<3> steady = track.state_at(at, context);
    load                  = steady.result.normal_force;
    const double resolved =
      least_elements_of_wave * steady.grading.element_size_x;
    if (roughness.shortest < resolved)
      {
        context.log.message("Waves shorter than " +
                            significant(1e3 * resolved, 3) + " mm, " +
                            significant(least_elements_of_wave, 1) +
                            " elements along x, are left out.");
        roughness.shortest = resolved;
      }
    require_bands(scene, roughness, speeds);
    const ModalBodies<3> &modal = track.modes_of(steady, at, context);
    const RollingModes<3> rolling(modal,
                                  *steady.pair,
                                  steady.problem.operators.W().dense());
    find_radiators(rolling);
    PhaseTimer::Scope phase(context.timer, Phase::response);
    const auto        reduced = [&](const double speed) {
      ReducedPair pair = rolling.reduced(conditions_of_waves(at, speed));
      if (const auto *rail = modal.body(Side::rail);
          rail != nullptr && rail->is_without_ends())
        pair.watched = rolling.relative_motions_of_waves(Side::rail);
      return pair;
    };
    const WaveSweep sweep =
      waves_over(at, steady.problem, steady.state, speeds, reduced);
    warn_of_fixed_edges(sweep.contact(),
                        scene.contact.slip_operator,
                        context.log);
    const auto waves = passing_waves(sweep);
    const auto sweeps_of_halves =
      waves_over_halves(at, steady, speeds, reduced);
    std::vector<std::vector<PassingWaves>> of_halves;
    for (const WaveSweep &half : sweeps_of_halves)
      of_halves.push_back(passing_waves(half));

    std::vector<NoiseOfSpeed> found;
    for (std::size_t v = 0; v < speeds.size(); ++v)
      {
        NoiseOfSpeed of_speed;
        of_speed.speed = speeds[v];
        for (const auto &band : bands_at(speeds[v]))
          of_speed.bands.push_back(band_at(waves[v], band, speeds[v]));
        of_speed.uncertainty = uncertainty_at(v, waves, of_halves, of_speed);
        found.push_back(std::move(of_speed));
      }
    return found;
  }

  void RollingNoise::run()
  {
    std::vector<std::vector<NoiseOfSpeed>> places(speeds.size());
    const auto situations = section.places().situations(scene);
    for (const Situation &at : situations)
      {
        const auto found = noise_at(at);
        for (std::size_t v = 0; v < speeds.size(); ++v)
          places[v].push_back(found[v]);
      }
    std::vector<NoiseOfSpeed> found;
    for (const auto &of_speed : places)
      found.push_back(mean_of_places(of_speed));
    report(found);
  }

  void RollingNoise::report(const std::vector<NoiseOfSpeed> &found)
  {
    if (n_coarse > 0)
      context.log.warning(std::to_string(n_coarse) +
                          " third octaves have resonances too sharp for the "
                          "frequencies that were computed: their powers are "
                          "known to no better than " +
                          significant(100 * tolerance, 2) + " %.");
    std::optional<double> largest;
    for (const NoiseOfSpeed &it : found)
      if (it.uncertainty)
        largest = std::max(largest.value_or(0.), *it.uncertainty);
    if (largest)
      context.report.errors.push_back({"sound power",
                                       std::pow(10., *largest / 10) - 1,
                                       "itself",
                                       "elements of twice the length",
                                       true,
                                       significant(*largest, 2) +
                                         " dB, without the error of the "
                                         "radiation estimate"});
    else
      warn_of_unknown_halves("the noise", context.log);
    report_noise(found,
                 scene.inputs->sound,
                 scene.inputs->output.plot,
                 context);
  }

  namespace
  {
    void check_noise(const SceneParameters &scene)
    {
      const auto &section = scene.own<RollingNoiseParameters>();
      if (scene.dimension == 2)
        throw InputError("Dimension = 2: Analysis = rolling noise needs the "
                         "surfaces that radiate; take Dimension = 3.");
      scene.sound.check_air();
      check_speeds_of_state(scene, "Rolling noise/Speeds", section.speeds);
      section.places().check(scene.rail);
    }

    void check_roughness(const Situation &scene)
    {
      const auto &section = scene.inputs->own<RollingNoiseParameters>();
      require_bands(scene,
                    roughness_of(scene),
                    section.speeds_or(std::abs(scene.contact.rolling_speed())));
      if (section.filter == ContactFilter::table && scene.contact.normal_load)
        directive_contact_filter(*scene.contact.normal_load, 1.);
    }
  } // namespace

  AnalysisKind rolling_noise_kind()
  {
    AnalysisKind kind = kind_of<RollingNoise>(
      "rolling noise",
      "the sound of wheel and rail that the roughness of their surfaces "
      "makes, over frequency and speed, see section Rolling noise");
    kind.sections = {"Modes", "Stability", "Rolling noise", "Sound"};
    kind.own_section.emplace(RollingNoiseParameters());
    kind.axes = [](const SceneParameters &scene) {
      return scene.own<RollingNoiseParameters>().places().axes();
    };
    kind.linearises      = true;
    kind.passes_waves    = true;
    kind.has_dampers     = true;
    kind.on_ranks        = false;
    kind.rules           = {&check_linearised_state, &check_noise};
    kind.check_situation = &check_roughness;
    return kind;
  }
} // namespace RollingContact
