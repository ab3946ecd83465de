#ifndef rolling_contact_report_force_spectrum_h
#define rolling_contact_report_force_spectrum_h

#include <filesystem>

namespace RollingContact
{
  struct RunContext;
  struct SceneParameters;

  /**
   * Spectra of the forces and of the surfaces that move, from @p file,
   * history.csv: spectrum.csv by Welch's method, third_octaves.csv, and
   * spectrum.svg if @p plot. A finding tells how much and at which frequency
   * the load varies. Only for the root.
   */
  void
  write_force_spectrum(const SceneParameters       &scene,
                       const std::filesystem::path &file,
                       RunContext                  &context);
} // namespace RollingContact

#endif
