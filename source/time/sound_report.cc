#include <rolling_contact/algebra/third_octaves.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/run/figure.h>
#include <rolling_contact/run/run_context.h>
#include <rolling_contact/time/a_weighting.h>
#include <rolling_contact/time/sound_pressure.h>
#include <rolling_contact/time/sound_report.h>
#include <rolling_contact/time/wav_file.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace RollingContact
{
  namespace
  {
    using Values = std::vector<double>;
    using Bands  = std::vector<Signals::ThirdOctave>;

    const std::string wav_name = "pressure.wav";

    /// of a sound that repeats itself
    const double audible_s = 3.;

    /// below the highest by so much a power is one of rounding
    const double negligible = 1e-18;

    using Sound::power_level;
    using Sound::pressure_level;

    /** Sum of the lines of a spectrum, weighted with A if so. */
    double sum_of(const Signals::PowerSpectrum &spectrum, const bool weighted)
    {
      double sum = 0.;
      for (std::size_t k = 1; k < spectrum.density.size(); ++k)
        sum += spectrum.density[k] * spectrum.step *
               (weighted ? Sound::a_weighting(k * spectrum.step) : 1.);
      return sum;
    }

    Signals::PowerSpectrum weighted(Signals::PowerSpectrum spectrum)
    {
      for (std::size_t k = 1; k < spectrum.density.size(); ++k)
        spectrum.density[k] *= Sound::a_weighting(k * spectrum.step);
      return spectrum;
    }

    Signals::PowerSpectrum
    sum_of_bodies(const std::vector<SoundingBody> &bodies)
    {
      Signals::PowerSpectrum sum;
      for (const SoundingBody &body : bodies)
        {
          const Signals::PowerSpectrum &spectrum = body.sound.spectrum;
          sum.step                               = spectrum.step;
          sum.density.resize(std::max(sum.density.size(),
                                      spectrum.density.size()),
                             0.);
          for (std::size_t k = 0; k < spectrum.density.size(); ++k)
            sum.density[k] += spectrum.density[k];
        }
      return sum;
    }

    /**
     * The tables, the picture and the file to be listened to.
     */
    class SoundReport
    {
    public:
      SoundReport(const Situation                 &scene,
                  const std::vector<SoundingBody> &bodies,
                  RunContext                      &context);

      void write_bands() const;
      void write_modes() const;
      void write_wav(const double duration, const double period) const;
      void draw() const;
      void note(const double duration) const;

    private:
      /** The cell of a level; empty for no power. */
      void set_level(ResultsTable      &table,
                     const std::string &column,
                     const double       power) const;

      const Situation                 &scene;
      const std::vector<SoundingBody> &bodies;
      RunContext                      &context;
      const Sound::Air                 air;
      double                           power = 0., weighted_power;
      /** By table column: bodies, total, total with A. */
      std::vector<std::pair<std::string, Bands>> bands;
    };

    SoundReport::SoundReport(const Situation                 &scene,
                             const std::vector<SoundingBody> &bodies,
                             RunContext                      &context)
      : scene(scene)
      , bodies(bodies)
      , context(context)
      , air(air_of(scene.inputs->sound))
    {
      for (const SoundingBody &body : bodies)
        {
          power += body.sound.power;
          bands.emplace_back(name_of(body.side) + "_dB_re_1pW",
                             Signals::third_octaves(body.sound.spectrum));
        }
      const Signals::PowerSpectrum total = sum_of_bodies(bodies);
      weighted_power                     = sum_of(total, true);
      bands.emplace_back("total_dB_re_1pW", Signals::third_octaves(total));
      bands.emplace_back("total_dBA_re_1pW",
                         Signals::third_octaves(weighted(total)));
    }

    void SoundReport::set_level(ResultsTable      &table,
                                const std::string &column,
                                const double       value) const
    {
      table.set_if(value > negligible * power, column, power_level(value));
    }

    void SoundReport::write_bands() const
    {
      const Sound::AudibleRange range = audible_range(scene);
      ResultsTable              table(context.folder, "sound.csv");
      const Bands              &first = bands.front().second;
      for (std::size_t k = 0; k < first.size(); ++k)
        {
          if (first[k].upper_edge() < range.lowest ||
              first[k].lower_edge() > range.highest)
            continue;
          table.set("centre_frequency_Hz", first[k].centre);
          table.set("lower_edge_Hz", first[k].lower_edge());
          table.set("upper_edge_Hz", first[k].upper_edge());
          for (const auto &[column, values] : bands)
            set_level(table, column, values[k].mean_square.value_or(0.));
          table.end_row();
        }
      table.flush();
    }

    void SoundReport::write_modes() const
    {
      ResultsTable table(context.folder, "sound_modes.csv");
      for (const SoundingBody &body : bodies)
        for (std::size_t j = 0; j < body.radiating.frequencies.size(); ++j)
          {
            const ModeCharacter &character = body.characters[j];
            table.set("body", name_of(body.side));
            table.set("mode", j + 1);
            table.set("frequency_Hz", body.radiating.frequencies[j]);
            table.set("nodal_diameters", character.nodal_diameters);
            table.set("axial_share", character.axial_share);
            table.set("radial_share", character.radial_share);
            set_level(table, "alone_dB_re_1pW", body.sound.alone[j]);
            table.set("power_share",
                      power > 0. ? body.sound.part[j] / power : 0.);
            table.end_row();
          }
      table.flush();
    }

    void SoundReport::write_wav(const double duration,
                                const double period) const
    {
      const SoundParameters        &wanted = scene.inputs->sound;
      std::vector<Sound::BodySound> sounds;
      for (const SoundingBody &body : bodies)
        sounds.push_back(body.sound);
      const double rate = wanted.sampling_rate;
      Values       pressure =
        Sound::pressure_over_time(sounds, duration, air, wanted.distance, rate);
      if (period > 0.)
        pressure = Sound::repeated_periods(pressure,
                                           period * rate,
                                           std::llround(audible_s * rate));
      const double full_scale =
        wanted.full_scale_pressure.value_or(Sound::full_scale_above(pressure));
      const std::string scale =
        "full scale (2^23) is " + significant(full_scale, 6) + " Pa";
      context.folder.write_atomically(
        wav_name,
        Sound::wav_file(pressure,
                        wanted.sampling_rate,
                        full_scale,
                        "Sound pressure at " + significant(wanted.distance, 6) +
                          " m, an estimate; " + scale));
      context.results.set("wav_full_scale_Pa", full_scale);
      context.log.message(
        wav_name + ": " + significant(pressure.size() / rate, 4) + " s" +
        (period > 0. ? " of repeated periods, " : ", ") +
        std::to_string(wanted.sampling_rate) + " Hz, " + scale + ".");
      const std::size_t n = Sound::n_beyond(pressure, full_scale);
      if (n > 0)
        context.log.warning(
          "Sound/Full scale pressure = " + significant(full_scale, 6) +
          " Pa: " + std::to_string(n) +
          " samples of pressure.wav are higher and were cut; take " +
          significant(Sound::full_scale_above(pressure), 3) + ".");
    }

    /** Levels of bands for the eye, from the first one that has any: a gap for
     * what is far below the rest. */
    std::pair<Values, Values> shown_levels(const Bands &bands)
    {
      const double range = 1e-8;
      double       most  = 0.;
      for (const Signals::ThirdOctave &band : bands)
        most = std::max(most, band.mean_square.value_or(0.));
      Values centres, levels;
      for (const Signals::ThirdOctave &band : bands)
        {
          const bool shown = band.mean_square.value_or(0.) > range * most;
          if (!shown && centres.empty())
            continue;
          centres.push_back(band.centre);
          levels.push_back(shown ? power_level(*band.mean_square)
                                 : std::numeric_limits<double>::quiet_NaN());
        }
      return {centres, levels};
    }

    void SoundReport::draw() const
    {
      const std::string frequency = "frequency (Hz)",
                        level     = "sound power (dB re 1 pW)";
      Figure figure("Sound power in third octaves and by mode, an estimate",
                    frequency,
                    level),
        modes("", frequency, level);
      const std::vector<std::pair<std::string, std::string>> names{
        {"wheel_dB_re_1pW", "wheel"},
        {"rail_dB_re_1pW", "rail"},
        {"total_dBA_re_1pW", "both, A-weighted"}};
      for (const auto &[column, label] : names)
        for (const auto &[other, values] : bands)
          if (other == column)
            {
              const auto [centres, levels] = shown_levels(values);
              figure.add_curve(label,
                               centres,
                               levels,
                               CurveStyle::line_and_points);
            }
      for (const SoundingBody &body : bodies)
        {
          Values levels;
          for (const double alone : body.sound.alone)
            levels.push_back(alone > 1e-9 * power
                               ? power_level(alone)
                               : std::numeric_limits<double>::quiet_NaN());
          modes.add_curve("modes of the " + name_of(body.side),
                          body.radiating.frequencies,
                          levels,
                          CurveStyle::points);
        }
      figure.set_scales(AxisScale::logarithmic, AxisScale::linear);
      modes.set_scales(AxisScale::logarithmic, AxisScale::linear);
      figure.add_separate_panel(modes);
      figure.draw(context, "sound");
    }

    void SoundReport::note(const double duration) const
    {
      ResultsTable &results = context.results;
      const double  mean_square =
                     Sound::mean_square_pressure(power,
                                                 air,
                                                 scene.inputs->sound.distance),
                   weighted_square =
                     Sound::mean_square_pressure(weighted_power,
                                                 air,
                                                 scene.inputs->sound.distance);
      std::string text;
      for (const SoundingBody &body : bodies)
        {
          set_level(results,
                    "sound_power_" + name_of(body.side) + "_dB_re_1pW",
                    body.sound.power);
          const double of_body = sum_of(body.sound.spectrum, true);
          text += "the " + name_of(body.side) + " " +
                  (of_body > negligible * power
                     ? significant(power_level(of_body), 4) + " dB(A)"
                     : std::string("nothing")) +
                  ", ";
        }
      set_level(results, "sound_power_dB_re_1pW", power);
      set_level(results, "sound_power_dBA_re_1pW", weighted_power);
      results.set("sound_pressure_Pa", std::sqrt(mean_square));
      results.set_if(weighted_power > 0.,
                     "sound_pressure_dBA_re_20uPa",
                     pressure_level(weighted_square));
      if (power > 0.)
        text = "power of " + text + "together " +
               significant(power_level(weighted_power), 4) +
               " dB(A) re 1 pW; at " +
               significant(scene.inputs->sound.distance, 4) + " m " +
               significant(pressure_level(weighted_square), 4) +
               " dB(A) re 20 uPa: an estimate to 3 dB at best, of " +
               significant(duration, 3) + " s";
      else
        text = "none, the bodies are at rest";
      context.report.set_finding("sound", text);
    }
  } // namespace

  Sound::Air air_of(const SoundParameters &parameters)
  {
    return {parameters.air_density, parameters.speed_of_sound};
  }

  Sound::AudibleRange audible_range(const Situation &scene)
  {
    Sound::AudibleRange range;
    range.highest = scene.inputs->modes.maximum_frequency;
    return range;
  }

  void report_sound(const Situation                 &scene,
                    const std::vector<SoundingBody> &bodies,
                    const double                     duration,
                    const double                     period,
                    RunContext                      &context)
  {
    const SoundReport report(scene, bodies, context);
    report.write_bands();
    report.write_modes();
    report.note(duration);
    if (scene.inputs->sound.wav_file)
      report.write_wav(duration, period);
    if (scene.inputs->output.plot)
      report.draw();
  }
} // namespace RollingContact
