#include <deal.II/base/parameter_handler.h>

#include <rolling_contact/input/prm_declarations.h>
#include <rolling_contact/scene/spectrum_parameters.h>

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
} // namespace RollingContact
