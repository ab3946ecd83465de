#include <rolling_contact/base/text.h>
#include <rolling_contact/plot/figure.h>
#include <rolling_contact/report/force_spectrum.h>
#include <rolling_contact/report/history_plot.h>
#include <rolling_contact/signals/third_octaves.h>
#include <rolling_contact/state/checkpoint.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace RollingContact
{
  namespace
  {
    using Values = std::vector<double>;

    /** A column of history.csv and how its spectra are named. */
    struct Signal
    {
      std::string column, label, density, level;
      double      reference; ///< of the level, in the column's unit
      bool        is_force;
    };



    std::vector<Signal>
    signals_of(const SceneParameters &scene)
    {
      std::vector<Signal> signals{{"normal_force_N",
                                   "load N",
                                   "normal_force_psd_N2/Hz",
                                   "normal_force_dB_re_1N",
                                   1.,
                                   true}};
      if (scene.contact.friction_coefficient > 0.)
        signals.push_back({"force_x_N",
                           "longitudinal T",
                           "force_x_psd_N2/Hz",
                           "force_x_dB_re_1N",
                           1.,
                           true});
      if (scene.contact.friction_coefficient > 0. && scene.dimension == 3)
        signals.push_back({"force_y_N",
                           "lateral T",
                           "force_y_psd_N2/Hz",
                           "force_y_dB_re_1N",
                           1.,
                           true});
      if (scene.surfaces.in_use())
        signals.push_back({"surface_height_m",
                           "height of the surfaces",
                           "surface_height_psd_m2/Hz",
                           "surface_height_dB_re_1um",
                           1e-6,
                           false});
      return signals;
    }



    /** Steps of a scene's history that its spectra are of. */
    struct Sampling
    {
      double      step;    ///< s
      std::size_t skipped; ///< rows
      std::size_t segment; ///< rows; 0: to be chosen
    };



    Sampling
    sampling_of(const SceneParameters &scene)
    {
      const double step =
        scene.time
          .steps(scene.time.histories(scene.contact, scene.prm_folder).speed)
          .length;
      return {step,
              scene.spectrum.skipped_rows(step),
              scene.spectrum.rows_in_segment(step)};
    }



    /**
     * The tables and the picture.
     */
    class Spectra
    {
    public:
      Spectra(const SceneParameters       &scene,
              const std::filesystem::path &file,
              RunContext                  &context);

      void
      write_lines() const;
      void
      write_bands() const;
      void
      draw() const;
      void
      note() const;

    private:
      /** Distance between crests; nothing where the speed changes. */
      void
      set_wavelength(const std::string &column,
                     const double       frequency,
                     ResultsTable      &table) const;

      RunContext                                    &context;
      const std::vector<Signal>                      signals;
      const Sampling                                 sampling;
      std::optional<double>                          speed; ///< if constant
      std::size_t                                    n_rows, segment;
      std::vector<Signals::PowerSpectrum>            spectra;
      std::vector<std::vector<Signals::ThirdOctave>> bands;
    };



    Spectra::Spectra(const SceneParameters       &scene,
                     const std::filesystem::path &file,
                     RunContext                  &context)
      : context(context)
      , signals(signals_of(scene))
      , sampling(sampling_of(scene))
    {
      const DrivingFunctions drive =
        scene.time.histories(scene.contact, scene.prm_folder);
      if (drive.speed.is_constant())
        speed = std::abs(drive.speed.value(0.));
      std::vector<std::string> columns;
      for (const Signal &signal : signals)
        columns.push_back(signal.column);
      const HistoryColumns history = read_history(file, columns);
      n_rows                       = history.at("normal_force_N").size();
      n_rows -= std::min(n_rows, sampling.skipped);
      segment = sampling.segment > 0 ? sampling.segment
                                     : Signals::chosen_segment(n_rows);
      for (const Signal &signal : signals)
        {
          const Values &all = history.at(signal.column);
          spectra.push_back(Signals::welch(
            Values(all.end() - n_rows, all.end()), sampling.step, segment));
          bands.push_back(Signals::third_octaves(spectra.back()));
        }
    }



    void
    Spectra::set_wavelength(const std::string &column,
                            const double       frequency,
                            ResultsTable      &table) const
    {
      if (speed && *speed > 0. && frequency > 0.)
        table.set(column, *speed / frequency);
      else
        table.leave_empty(column);
    }



    void
    Spectra::write_lines() const
    {
      ResultsTable table(context.folder, "spectrum.csv");
      for (std::size_t k = 0; k < spectra.front().density.size(); ++k)
        {
          const double frequency = k * spectra.front().step;
          table.set("frequency_Hz", frequency);
          set_wavelength("wavelength_m", frequency, table);
          for (std::size_t i = 0; i < signals.size(); ++i)
            table.set(signals[i].density, spectra[i].density[k]);
          table.end_row();
        }
      table.flush();
    }



    void
    Spectra::write_bands() const
    {
      ResultsTable table(context.folder, "third_octaves.csv");
      for (std::size_t k = 0; k < bands.front().size(); ++k)
        {
          const Signals::ThirdOctave &band = bands.front()[k];
          table.set("centre_frequency_Hz", band.centre);
          table.set("lower_edge_Hz", band.lower_edge());
          table.set("upper_edge_Hz", band.upper_edge());
          set_wavelength("centre_wavelength_m", band.centre, table);
          for (std::size_t i = 0; i < signals.size(); ++i)
            if (const auto value = bands[i][k].mean_square;
                value && *value > 0.)
              table.set(signals[i].level,
                        Signals::level(*value, signals[i].reference));
            else
              table.leave_empty(signals[i].level);
          table.end_row();
        }
      table.flush();
    }



    /** Levels of bands for the eye: none of rounding, far below the rest. */
    Values
    shown_levels(const std::vector<Signals::ThirdOctave> &bands,
                 const double                             reference)
    {
      const double least = 1e-10; // 100 dB below the highest
      double       most  = 0.;
      for (const Signals::ThirdOctave &band : bands)
        most = std::max(most, band.mean_square.value_or(0.));
      Values levels;
      for (const Signals::ThirdOctave &band : bands)
        levels.push_back(band.mean_square.value_or(0.) > least * most
                           ? Signals::level(*band.mean_square, reference)
                           : std::numeric_limits<double>::quiet_NaN());
      return levels;
    }



    void
    Spectra::draw() const
    {
      const std::string frequency = "frequency (Hz)";
      Figure            forces("Third octaves and power spectral density",
                    frequency,
                    "force (dB re 1 N)"),
        heights("", frequency, "height (dB re 1 \u00b5m)"),
        lines("", frequency, "density (N\u00b2/Hz)");
      bool has_heights = false;
      for (std::size_t i = 0; i < signals.size(); ++i)
        {
          Values centres, frequencies;
          for (const Signals::ThirdOctave &band : bands[i])
            centres.push_back(band.centre);
          (signals[i].is_force ? forces : heights)
            .add_curve(signals[i].label,
                       centres,
                       shown_levels(bands[i], signals[i].reference),
                       CurveStyle::line_and_points);
          has_heights = has_heights || !signals[i].is_force;
          for (std::size_t k = 0; k < spectra[i].density.size(); ++k)
            frequencies.push_back(k * spectra[i].step);
          if (signals[i].is_force)
            lines.add_curve(signals[i].label, frequencies, spectra[i].density);
        }
      forces.set_scales(AxisScale::logarithmic, AxisScale::linear);
      heights.set_scales(AxisScale::logarithmic, AxisScale::linear);
      lines.set_scales(AxisScale::logarithmic, AxisScale::logarithmic);
      if (has_heights)
        forces.add_separate_panel(heights);
      forces.add_separate_panel(lines);
      forces.draw(context, "spectrum");
    }



    void
    Spectra::note() const
    {
      const Signals::PowerSpectrum &load = spectra.front();
      std::string text = "of " + std::to_string(n_rows) + " steps, " +
                         std::to_string(load.n_segments) + " segments of " +
                         std::to_string(segment) + ", lines " +
                         significant(load.step, 4) + " Hz apart";
      const double rms = std::sqrt(
        load.step *
        std::accumulate(load.density.begin(), load.density.end(), 0.));
      const auto highest =
        std::max_element(load.density.begin() + 1, load.density.end());
      if (rms > 0.)
        text += "; N is " + significant(rms, 4) +
                " N (rms) about its mean, most of it around " +
                significant(load.step * (highest - load.density.begin()), 4) +
                " Hz";
      context.report.set_finding("bands", text);
    }
  } // namespace



  void
  write_force_spectrum(const SceneParameters       &scene,
                       const std::filesystem::path &file,
                       RunContext                  &context)
  {
    // of the rows there are, all the steps that were asked for
    const auto n_rows = read_history(file, {"time_s"}).at("time_s").size();
    const std::string why =
      scene.spectrum.why_none({sampling_of(scene).step, n_rows});
    if (!why.empty())
      {
        context.log.message("No spectra: " + why);
        return;
      }
    const Spectra spectra(scene, file, context);
    spectra.write_lines();
    spectra.write_bands();
    spectra.note();
    if (scene.output.plot)
      spectra.draw();
  }
} // namespace RollingContact
