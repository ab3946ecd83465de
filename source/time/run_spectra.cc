#include <rolling_contact/base/text.h>
#include <rolling_contact/run/history_table.h>
#include <rolling_contact/run/run_context.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/time/run_spectra.h>
#include <rolling_contact/time/spectrogram.h>
#include <rolling_contact/time/spectrum_lines.h>
#include <rolling_contact/time/spectrum_plot.h>
#include <rolling_contact/time/spectrum_tables.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace RollingContact
{
  namespace
  {
    using Values = std::vector<double>;

    double root_mean_square(const Signals::PowerSpectrum &spectrum)
    {
      return std::sqrt(spectrum.step * std::accumulate(spectrum.density.begin(),
                                                       spectrum.density.end(),
                                                       0.));
    }

    void note_load(const RunSpectra &spectra, RunContext &context)
    {
      const Signals::PowerSpectrum &load = spectra.signals.front().spectrum;
      std::string text = "of " + std::to_string(spectra.n_rows) + " steps, " +
                         std::to_string(load.n_segments) + " segments of " +
                         std::to_string(spectra.segment) + ", lines " +
                         significant(load.step, 4) + " Hz apart";
      const double rms = root_mean_square(load);
      const auto   highest =
        std::max_element(load.density.begin() + 1, load.density.end());
      if (rms > 0.)
        text += "; N is " + significant(rms, 4) +
                " N (rms) about its mean, most of it around " +
                significant(load.step * (highest - load.density.begin()), 4) +
                " Hz";
      context.report.set_finding("bands", text);
    }
  } // namespace

  double step_of_history(const Situation &scene)
  {
    return scene.inputs->time
      .steps(
        scene.inputs->time.histories(scene.contact, scene.inputs->prm_folder)
          .speed)
      .length;
  }

  double highest_frequency(const Situation &scene)
  {
    const double all = 0.5 / step_of_history(scene);
    return std::min(all,
                    scene.inputs->spectrum.highest_frequency > 0.
                      ? scene.inputs->spectrum.highest_frequency
                    : scene.inputs->has_reduced_bodies()
                      ? scene.inputs->modes.maximum_frequency
                      : all);
  }

  SignalUnits units_of(const SignalKind kind)
  {
    switch (kind)
      {
        case SignalKind::force:
          return {"N2/Hz", "dB_re_1N", 1., "force (dB re 1 N)"};
        case SignalKind::height:
          return {"m2/Hz", "dB_re_1um", 1e-6, "height (dB re 1 \u00b5m)"};
        default:
          return {"(m/s)2/Hz", "dB_re_1nm/s", 1e-9, "velocity (dB re 1 nm/s)"};
      }
  }

  RunSpectra run_spectra(const Situation &scene, const HistoryTable &history)
  {
    RunSpectra spectra;
    spectra.step    = step_of_history(scene);
    spectra.highest = highest_frequency(scene);
    const DrivingFunctions drive =
      scene.inputs->time.histories(scene.contact, scene.inputs->prm_folder);
    if (drive.speed.is_constant())
      spectra.speed = std::abs(drive.speed.value(0.));
    std::vector<std::string> columns;
    for (const RunSignal &signal : run_signals(*scene.inputs))
      columns.push_back(signal.column);
    const HistoryColumns rows = history.columns(columns);
    spectra.n_rows            = rows.at(columns.front()).size();
    spectra.n_rows -=
      std::min(spectra.n_rows,
               scene.inputs->spectrum.skipped_rows(spectra.step));
    const std::size_t asked =
      scene.inputs->spectrum.rows_in_segment(spectra.step);
    spectra.segment =
      asked > 0 ? asked : Signals::chosen_segment(spectra.n_rows);
    for (const RunSignal &signal : run_signals(*scene.inputs))
      {
        const Values         &all = rows.at(signal.column);
        SignalSpectrum        of{signal, {}, {}, {}};
        Signals::LineCriteria criteria;
        criteria.prominence = scene.inputs->spectrum.line_prominence;
        criteria.highest    = spectra.highest;
        of.spectrum =
          Signals::welch(Values(all.end() - spectra.n_rows, all.end()),
                         spectra.step,
                         spectra.segment);
        of.bands = Signals::third_octaves(of.spectrum);
        of.lines = Signals::spectral_lines(of.spectrum, criteria);
        spectra.signals.push_back(of);
      }
    return spectra;
  }

  void write_spectra(const Situation     &scene,
                     const HistoryTable  &history,
                     const ComplexValues &eigenvalues,
                     RunContext          &context)
  {
    // of the rows there are, all the steps that were asked for
    const std::string why =
      scene.inputs->spectrum.why_none({step_of_history(scene), history.size()});
    if (!why.empty())
      {
        context.log.message("No spectra: " + why);
        return;
      }
    RunSpectra spectra = run_spectra(scene, history);
    if (const std::string none = scene.inputs->why_no_eigenvalues();
        none.empty())
      spectra.eigenvalues = eigenvalues;
    else
      context.log.detail("Lines stand without eigenvalues: " + none + ".");
    write_spectrum(spectra, context);
    write_third_octaves(spectra, context);
    write_lines(spectra, context);
    note_load(spectra, context);
    note_strongest_line(spectra, context);
    if (scene.inputs->output.plot)
      draw_spectrum(spectra, context);
    if (scene.inputs->spectrum.spectrogram)
      write_spectrogram(scene, history, context);
  }
} // namespace RollingContact
