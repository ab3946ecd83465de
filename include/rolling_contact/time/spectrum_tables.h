#ifndef rolling_contact_time_spectrum_tables_h
#define rolling_contact_time_spectrum_tables_h

#include <rolling_contact/time/run_spectra.h>

namespace RollingContact
{
  /**
   * spectrum.csv: the one-sided power spectral densities of all signals over
   * the frequency.
   */
  void write_spectrum(const RunSpectra &spectra, RunContext &context);

  /**
   * third_octaves.csv: the levels of all signals in bands of IEC 61260-1, empty
   * where a band has less than four lines.
   */
  void write_third_octaves(const RunSpectra &spectra, RunContext &context);
} // namespace RollingContact

#endif
