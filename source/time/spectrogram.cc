#include <rolling_contact/algebra/spectrogram.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/run/figure.h>
#include <rolling_contact/run/history_table.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/time/run_spectra.h>
#include <rolling_contact/time/spectrogram.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    using Values = std::vector<double>;

    /// below the highest level: what is one colour, dB
    const double shown_range = 80.;

    const char table_file[] = "spectrogram.csv";

    /**
     * Levels of a signal over time and frequency; frequencies without the
     * lowest line, in which the mean is.
     */
    class LevelsOverTime
    {
    public:
      LevelsOverTime(const RunSignal            &signal,
                     const Signals::Spectrogram &spectrogram,
                     const double                begin,
                     const double                highest)
        : signal(signal)
        , units(units_of(signal.kind))
      {
        for (const double time : spectrogram.times)
          times.push_back(begin + time);
        const std::size_t n = spectrogram.mean_squares.front().size();
        for (std::size_t k = 1; k < n; ++k)
          if (k * spectrogram.frequency_step <= highest * (1 + 1e-9))
            frequencies.push_back(k * spectrogram.frequency_step);
        for (std::size_t k = 0; k < frequencies.size(); ++k)
          for (const Values &window : spectrogram.mean_squares)
            mean_squares.push_back(window[k + 1]);
      }

      void write(RunContext &context) const
      {
        ResultsTable table(context.folder, table_file);
        for (std::size_t i = 0; i < times.size(); ++i)
          for (std::size_t k = 0; k < frequencies.size(); ++k)
            {
              const double value = mean_squares[k * times.size() + i];
              table.set("time_s", times[i]);
              table.set("frequency_Hz", frequencies[k]);
              table.set_if(value > 0., "level_" + units.level, level(value));
              table.end_row();
            }
        table.flush();
      }

      void draw(RunContext &context) const
      {
        Values shown = times, levels;
        for (double &time : shown)
          time *= 1e3;
        const double most =
          *std::max_element(mean_squares.begin(), mean_squares.end());
        if (!(most > 0.) || times.size() < 2 || frequencies.size() < 2)
          {
            context.log.message("The spectrogram has no picture: it is of one "
                                "window or one line, or of a signal that is "
                                "0.");
            return;
          }
        const double least = level(most) - shown_range;
        for (const double value : mean_squares)
          levels.push_back(value > 0. ? std::max(least, level(value)) : least);
        Figure figure("Spectrogram of " + signal.label,
                      "time (ms)",
                      "frequency (Hz)");
        figure.add_map(units.axis, shown, frequencies, levels);
        figure.draw(context, "spectrogram");
      }

    private:
      double level(const double mean_square) const
      {
        return 10 *
               std::log10(mean_square / (units.reference * units.reference));
      }

      const RunSignal   signal;
      const SignalUnits units;
      Values            times, frequencies;
      Values            mean_squares; ///< over times, then frequencies
    };
  } // namespace

  void write_spectrogram(const Situation    &scene,
                         const HistoryTable &history,
                         RunContext         &context)
  {
    const RunSignal      signal = spectrogram_signal(*scene.inputs);
    const HistoryColumns rows =
      history.columns({signal.column, "force_time_s"});
    const Values &all         = rows.at(signal.column),
                 &times       = rows.at("force_time_s");
    const double      step    = step_of_history(scene);
    const std::size_t skipped = scene.inputs->spectrum.skipped_rows(step),
                      n_rows  = all.size() - std::min(all.size(), skipped),
                      window =
                        scene.inputs->spectrum.rows_in_window(step, n_rows);
    if (n_rows < window)
      {
        context.log.message(
          "No spectrogram: " + std::to_string(n_rows) +
          " steps are left, and a window has " + std::to_string(window) +
          ". Skip less (Spectrum/Skipped time), or take a shorter "
          "Spectrum/Spectrogram window.");
        return;
      }
    const Signals::Spectrogram spectrogram =
      Signals::spectrogram(Values(all.end() - n_rows, all.end()), step, window);
    if (spectrogram.frequency_step > highest_frequency(scene))
      {
        context.log.message(
          "No spectrogram: its lines would be " +
          significant(spectrogram.frequency_step, 4) +
          " Hz apart, and Spectrum/Highest frequency is " +
          significant(highest_frequency(scene), 4) +
          " Hz. Raise it, or take a longer Spectrum/Spectrogram window.");
        return;
      }
    const LevelsOverTime levels(signal,
                                spectrogram,
                                times[all.size() - n_rows],
                                highest_frequency(scene));
    levels.write(context);
    if (scene.inputs->output.plot)
      levels.draw(context);
  }
} // namespace RollingContact
