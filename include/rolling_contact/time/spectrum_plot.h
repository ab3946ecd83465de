#ifndef rolling_contact_time_spectrum_plot_h
#define rolling_contact_time_spectrum_plot_h

#include <rolling_contact/time/run_spectra.h>

namespace RollingContact
{
  /**
   * spectrum.svg: third octaves of forces, heights and velocities, densities of
   * forces, and that of the velocity with the strongest line, with its four
   * strongest lines and what they may be of; up to the frequency that is looked
   * at.
   */
  void draw_spectrum(const RunSpectra &spectra, RunContext &context);
} // namespace RollingContact

#endif
