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
      "Whether a transient run ends with spectra and third octaves "
      "of its forces: `automatic`, when a surface moves (section "
      "Surfaces), `always` or `never`.");
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
    prm.leave_subsection();
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
