#include <rolling_contact/algebra/third_octaves.h>
#include <rolling_contact/analyses/rolling_noise_report.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/run/figure.h>
#include <rolling_contact/time/sound_pressure.h>
#include <rolling_contact/time/sound_report.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    const double reference_roughness = 1e-6; ///< m

    /// below the total by so much a power is one of rounding
    const double least_share = 1e-18;

    void set_power(ResultsTable      &table,
                   const std::string &column,
                   const double       power,
                   const double       total)
    {
      table.set_if(power > least_share * total,
                   column,
                   Sound::power_level(power));
    }

    void add_bands(const NoiseOfSpeed &of_speed, ResultsTable &table)
    {
      const NoisePowers all = of_speed.sum();
      for (const NoiseBand &band : of_speed.bands)
        {
          const NoisePowers &powers = band.powers;
          table.set("speed_m/s", of_speed.speed);
          table.set("centre_frequency_Hz", band.centre);
          table.set("wavelength_m", of_speed.speed / band.centre);
          table.set("roughness_dB_re_1um",
                    Signals::level(band.roughness, reference_roughness));
          table.set("contact_filter_dB",
                    10 * std::log10(powers[NoisePowers::load] /
                                    powers[NoisePowers::load_of_one]));
          table.set("load_N", std::sqrt(powers[NoisePowers::load]));
          for (const auto &[column, power] :
               {std::pair("wheel_dB_re_1pW", powers[NoisePowers::wheel]),
                std::pair("rail_dB_re_1pW", powers[NoisePowers::rail]),
                std::pair("total_dB_re_1pW", powers.total()),
                std::pair("total_dBA_re_1pW", powers.weighted())})
            set_power(table, column, power, all.total());
          table.end_row();
        }
    }

    double level_at_distance(const NoiseOfSpeed    &of_speed,
                             const SoundParameters &sound)
    {
      return Sound::pressure_level(Sound::mean_square_pressure(
        of_speed.sum().weighted(), air_of(sound), sound.distance));
    }

    void add_speed(const NoiseOfSpeed    &of_speed,
                   const SoundParameters &sound,
                   ResultsTable          &table)
    {
      const NoisePowers all = of_speed.sum();
      table.set("speed_m/s", of_speed.speed);
      for (const auto &[column, power] :
           {std::pair("wheel_dBA_re_1pW", all[NoisePowers::weighted_wheel]),
            std::pair("rail_dBA_re_1pW", all[NoisePowers::weighted_rail]),
            std::pair("total_dBA_re_1pW", all.weighted()),
            std::pair("total_dB_re_1pW", all.total())})
        set_power(table, column, power, all.total());
      table.set("uncertainty_dB", of_speed.uncertainty);
      if (of_speed.range)
        table.set("range_over_bay_dB", *of_speed.range);
      table.set_if(all.weighted() > 0.,
                   "sound_pressure_dBA_re_20uPa",
                   level_at_distance(of_speed, sound));
      table.set("load_N", std::sqrt(all[NoisePowers::load]));
      table.set("lowest_band_Hz", of_speed.bands.front().centre);
      table.set("highest_band_Hz", of_speed.bands.back().centre);
      table.end_row();
    }

    void draw(const std::vector<NoiseOfSpeed> &speeds, RunContext &context)
    {
      Figure bands("Rolling noise, an estimate",
                   "frequency (Hz)",
                   "sound power (dB(A) re 1 pW)"),
        over_speed("", "speed (m/s)", "sound power (dB(A) re 1 pW)");
      for (const NoiseOfSpeed &it : speeds)
        {
          std::vector<double> centres, levels;
          for (const NoiseBand &band : it.bands)
            {
              centres.push_back(band.centre);
              levels.push_back(Sound::power_level(band.powers.weighted()));
            }
          bands.add_curve(significant(it.speed, 3) + " m/s",
                          centres,
                          levels,
                          CurveStyle::line_and_points);
        }
      bands.set_scales(AxisScale::logarithmic, AxisScale::linear);
      if (speeds.size() > 1)
        {
          const auto add = [&](const std::string &label, const auto &power) {
            std::vector<double> at, levels;
            for (const NoiseOfSpeed &it : speeds)
              {
                at.push_back(it.speed);
                levels.push_back(Sound::power_level(power(it.sum())));
              }
            over_speed.add_curve(label,
                                 at,
                                 levels,
                                 CurveStyle::line_and_points);
          };
          add("wheel",
              [](const auto &sum) { return sum[NoisePowers::weighted_wheel]; });
          add("rail",
              [](const auto &sum) { return sum[NoisePowers::weighted_rail]; });
          add("both", [](const auto &sum) { return sum.weighted(); });
          over_speed.set_scales(AxisScale::logarithmic, AxisScale::linear);
          bands.add_separate_panel(over_speed);
        }
      bands.draw(context, "rolling_noise");
    }

    /** A rigid body radiates nothing. */
    std::string text_of_level(const double power)
    {
      return power > 0. ? significant(Sound::power_level(power), 4) + " dB(A)"
                        : "nothing";
    }

    std::string finding(const std::vector<NoiseOfSpeed> &speeds,
                        const SoundParameters           &sound)
    {
      const NoiseOfSpeed &last  = speeds.back();
      const NoisePowers   all   = last.sum();
      const auto          slope = slope_of(speeds);
      return "at " + significant(last.speed, 3) + " m/s power of the wheel " +
             text_of_level(all[NoisePowers::weighted_wheel]) + ", the rail " +
             text_of_level(all[NoisePowers::weighted_rail]) + ", together " +
             significant(Sound::power_level(all.weighted()), 4) +
             (last.uncertainty ? " +- " + significant(*last.uncertainty, 2)
                               : "") +
             " dB(A) re 1 pW; at " + significant(sound.distance, 4) + " m " +
             significant(level_at_distance(last, sound), 4) +
             " dB(A) re 20 uPa" +
             (slope ? "; " + significant(*slope, 3) + " dB per decade of speed"
                    : "") +
             ": radiation is an estimate to 3 dB at best";
    }
  } // namespace

  NoisePowers NoiseOfSpeed::sum() const
  {
    NoisePowers result;
    for (const NoiseBand &band : bands)
      result.values += band.powers.values;
    return result;
  }

  NoiseOfSpeed mean_of_places(const std::vector<NoiseOfSpeed> &places)
  {
    NoiseOfSpeed        mean = places.front();
    std::vector<double> levels;
    for (const NoiseOfSpeed &place : places)
      {
        levels.push_back(Sound::power_level(place.sum().weighted()));
        if (!place.uncertainty || !mean.uncertainty)
          mean.uncertainty.reset();
        else
          mean.uncertainty = std::max(*mean.uncertainty, *place.uncertainty);
      }
    if (places.size() < 2)
      return mean;
    for (std::size_t b = 0; b < mean.bands.size(); ++b)
      {
        mean.bands[b].powers.values.setZero();
        for (const NoiseOfSpeed &place : places)
          mean.bands[b].powers.values +=
            place.bands[b].powers.values / double(places.size());
      }
    const auto [least, largest] =
      std::minmax_element(levels.begin(), levels.end());
    mean.range = *largest - *least;
    return mean;
  }

  std::optional<double> slope_of(const std::vector<NoiseOfSpeed> &speeds)
  {
    if (speeds.size() < 2)
      return {};
    Eigen::ArrayXd x(speeds.size()), y(speeds.size());
    for (std::size_t i = 0; i < speeds.size(); ++i)
      {
        x[i] = std::log10(speeds[i].speed);
        y[i] = Sound::power_level(speeds[i].sum().weighted());
      }
    x -= x.mean();
    return (x * y).sum() / x.square().sum();
  }

  void report_noise(const std::vector<NoiseOfSpeed> &speeds,
                    const SoundParameters           &sound,
                    const bool                       picture,
                    RunContext                      &context)
  {
    ResultsTable bands(context.folder, "rolling_noise.csv"),
      of_speeds(context.folder, "rolling_noise_speeds.csv");
    for (const NoiseOfSpeed &it : speeds)
      {
        add_bands(it, bands);
        add_speed(it, sound, of_speeds);
      }
    bands.flush();
    of_speeds.flush();
    context.log.message(of_speeds.screen_table({"speed_m/s",
                                                "wheel_dBA_re_1pW",
                                                "rail_dBA_re_1pW",
                                                "total_dBA_re_1pW",
                                                "uncertainty_dB",
                                                "load_N"}));
    context.report.set_finding("noise", finding(speeds, sound));
    if (picture)
      draw(speeds, context);
  }
} // namespace RollingContact
