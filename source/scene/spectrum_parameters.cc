#include <deal.II/base/parameter_handler.h>

#include <rolling_contact/base/text.h>
#include <rolling_contact/input/prm_declarations.h>
#include <rolling_contact/scene/spectrum_parameters.h>
#include <rolling_contact/scene/time_parameters.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    const std::vector<NamedValue<WriteSpectrum>> named_ways{
      {"automatic", WriteSpectrum::automatic},
      {"always", WriteSpectrum::always},
      {"never", WriteSpectrum::never}};

    /// of a spectrogram: tells times and lines of squeal apart, s
    const double usual_window = 0.01;
  } // namespace



  void
  SpectrumParameters::declare(ParameterHandler &prm)
  {
    const Patterns::Double not_negative(0.);
    prm.enter_subsection("Spectrum");
    declare_choice(
      prm,
      "Write",
      write,
      named_ways,
      "Whether a transient run ends with spectra, third octaves and lines of "
      "its forces and velocities: `automatic`, when a surface moves (section "
      "Surfaces), a vibration is excited (Time/Excite mode) or points are named "
      "(Velocity points of Wheel and Rail), `always` or `never`.");
    prm.add_parameter("Skipped time",
                      skipped_time,
                      "Beginning of the run that spectra leave out: what is "
                      "left of the start. Units: s.",
                      not_negative);
    prm.add_parameter(
      "Segment length",
      segment_length,
      "Length of the segments, which overlap by half, that a "
      "spectrum is the mean of; 0 takes a quarter of what there "
      "is. Units: s.",
      not_negative);
    declare_lines(prm);
    prm.leave_subsection();
  }



  void
  SpectrumParameters::declare_lines(ParameterHandler &prm)
  {
    const Patterns::Double not_negative(0.);
    prm.add_parameter(
      "Highest frequency",
      highest_frequency,
      "Up to which lines are looked for and spectrograms reach; 0 takes "
      "Modes/Maximum frequency for bodies by their modes, and all there is for "
      "full ones. Units: Hz.",
      not_negative);
    prm.add_parameter(
      "Line prominence",
      line_prominence,
      "What a peak of a spectrum rises at least, above the deeper ground "
      "between it and higher ones, to be a line of lines.csv. Units: dB.",
      not_negative);
    prm.add_parameter(
      "Spectrogram",
      spectrogram,
      "Whether the spectrum over time of one signal is written and drawn, "
      "spectrogram.csv and spectrogram.svg.");
    prm.add_parameter(
      "Spectrogram signal",
      spectrogram_signal,
      "A column of history.csv with a force, a velocity or the height of the "
      "surfaces, such as velocity_y_m/s; empty takes the velocity of the contact "
      "across, in 2D along.");
    prm.add_parameter(
      "Spectrogram window",
      spectrogram_window,
      "Length of the windows, which overlap by three quarters, that a column "
      "of the spectrogram is of; its lines are as far apart as the inverse of "
      "it. 0 takes 0.01 s, or a quarter of what there is if that is less. Units: s.",
      not_negative);
  }



  std::size_t
  SpectrumParameters::skipped_rows(const double time_step) const
  {
    return std::llround(skipped_time / time_step);
  }



  std::size_t
  SpectrumParameters::rows_in_segment(const double time_step) const
  {
    return std::llround(segment_length / time_step);
  }



  std::size_t
  SpectrumParameters::rows_in_window(const double      time_step,
                                     const std::size_t n_rows) const
  {
    return spectrogram_window > 0.
             ? std::llround(spectrogram_window / time_step)
             : std::clamp<std::size_t>(std::llround(usual_window / time_step),
                                       least_rows,
                                       std::max(least_rows, n_rows / 4));
  }



  std::string
  SpectrumParameters::why_none(const TimeSteps &steps) const
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
