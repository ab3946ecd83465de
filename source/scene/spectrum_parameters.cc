#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/scene/entries.h>
#include <rolling_contact/scene/spectrum_parameters.h>
#include <rolling_contact/scene/time_parameters.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    const std::vector<NamedValue<WriteSpectrum>> named_ways{
      {"automatic", WriteSpectrum::automatic},
      {"always", WriteSpectrum::always},
      {"never", WriteSpectrum::never}};

    const std::vector<Reader> runs_with_spectra{
      {asks<SpectrumParameters>([](const auto &spectrum) {
         return spectrum.write != WriteSpectrum::never;
       }),
       "Spectrum/Write = never"},
      scenes_with_spectra()};
    const Reader spectrograms{asks<SpectrumParameters>(
                                [](const auto &spectrum) {
                                  return spectrum.spectrogram;
                                }),
                              "Spectrum/Spectrogram = false"};

    /// of a spectrogram: tells times and lines of squeal apart, s
    const double usual_window = 0.01;
  } // namespace

  void SpectrumParameters::declare(Entries &entries)
  {
    entries.section("Spectrum").read_by_analyses("transient").free_on_resume =
      in_all_scenes;
    entries.choice("Write", write, named_ways).help =
      "Whether a transient run ends with spectra, third octaves and lines of "
      "its forces and velocities. `automatic`: when a surface moves (section "
      "Surfaces), a vibration is excited (Time/Excite mode) or points are "
      "named (Velocity points of Wheel and Rail); `always`; `never`.";
    entries.add("Skipped time", skipped_time, "s")
      .at_least(0.)
      .read_by(runs_with_spectra)
      .help =
      "Time at the beginning of the run that spectra leave out, so that the "
      "start has faded.";
    entries.add("Segment length", segment_length, "s")
      .at_least(0.)
      .read_by(runs_with_spectra)
      .help =
      "Length of the segments, which overlap by half. A spectrum is the mean "
      "over them. 0: a quarter of the run without Skipped time.";
    entries.add("Highest frequency", highest_frequency, "Hz")
      .read_by(runs_with_spectra)
      .at_least(0.)
      .help = "Highest frequency of lines and spectrograms. 0: Modes/Maximum "
              "frequency for bodies by their modes, no limit for full ones.";
    entries.add("Line prominence", line_prominence, "dB")
      .read_by(runs_with_spectra)
      .at_least(0.)
      .help = "Least prominence of a line in lines.csv: how far a peak of the "
              "spectrum rises above the ground between it and higher peaks.";
    entries.add("Spectrogram", spectrogram).read_by(runs_with_spectra).help =
      "Whether the spectrum of one signal over time is written and drawn, as "
      "spectrogram.csv and spectrogram.svg.";
    entries.add("Spectrogram signal", spectrogram_signal)
      .read_by(runs_with_spectra)
      .read_by(spectrograms)
      .help =
      "Column of history.csv that the spectrogram shows: a force, a velocity "
      "or the height of the surfaces, such as velocity_y_m/s. Empty: the "
      "velocity of the contact across, in 2D along.";
    entries.add("Spectrogram window", spectrogram_window, "s")
      .read_by(runs_with_spectra)
      .read_by(spectrograms)
      .at_least(0.)
      .help =
      "Length of the windows of the spectrogram, which overlap by three "
      "quarters; each gives one column. The distance of its lines in "
      "frequency is the inverse. 0: 0.01 s, or a quarter of the run without "
      "Skipped time if that is less.";
  }

  std::size_t SpectrumParameters::skipped_rows(const double time_step) const
  {
    return std::llround(skipped_time / time_step);
  }

  std::size_t SpectrumParameters::rows_in_segment(const double time_step) const
  {
    return std::llround(segment_length / time_step);
  }

  std::size_t SpectrumParameters::rows_in_window(const double      time_step,
                                                 const std::size_t n_rows) const
  {
    return spectrogram_window > 0.
             ? std::llround(spectrogram_window / time_step)
             : std::clamp<std::size_t>(std::llround(usual_window / time_step),
                                       least_rows,
                                       std::max(least_rows, n_rows / 4));
  }

  std::string SpectrumParameters::why_none(const TimeSteps &steps) const
  {
    const double length  = steps.length * steps.number;
    const bool   is_long = skipped_time > length || segment_length > length;
    if (!is_long)
      {
        const std::size_t segment = rows_in_segment(steps.length);
        const bool        whole   = segment == 0 || segment >= least_rows;
        if (whole &&
            skipped_rows(steps.length) + std::max(least_rows, segment) <=
              steps.number)
          return "";
      }
    return "the run lasts " + significant(length, 6) + " s, " +
           std::to_string(steps.number) +
           " steps, and a spectrum needs 32 steps in a segment and a whole "
           "segment behind what is skipped. Skip less, take another segment or a "
           "longer run, or Spectrum/Write = never.";
  }
} // namespace RollingContact
