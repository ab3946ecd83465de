#ifndef rolling_contact_time_spectrum_lines_h
#define rolling_contact_time_spectrum_lines_h

#include <rolling_contact/time/run_spectra.h>

namespace RollingContact
{
  /**
   * What a line of a spectrum may be of.
   */
  struct LineOrigin
  {
    /** Its number among the multiples of the strongest line of the signal, 1
     * for that itself; 0 for a line that is none. */
    unsigned int multiple = 0;

    double fundamental = 0.; ///< the strongest line, Hz

    /** The eigenvalue that lies nearest to 2 pi i f in the complex plane, 0 if
     * none is known: among neighbours the least damped one counts. Units:
     * 1/s. */
    std::complex<double> eigenvalue = 0.;

    /** Im s / 2 pi. Units: Hz. */
    double eigenfrequency() const;
  };

  /**
   * What the line with this number of a signal may be of. A line is a multiple
   * m f1 of the strongest one if it is off by less than half the distance of
   * the lines of the spectrum and less than f1/20.
   */
  LineOrigin origin_of(const SignalSpectrum &signal,
                       const std::size_t     line,
                       const ComplexValues  &eigenvalues);

  /**
   * The number of the strongest line of a signal that has lines.
   */
  std::size_t strongest_line(const SignalSpectrum &signal);

  /**
   * Among the signals of a kind the one with the strongest line; nullptr if
   * none has lines.
   */
  const SignalSpectrum *loudest(const RunSpectra &spectra,
                                const SignalKind  kind);

  /**
   * lines.csv: the lines of all signals with their levels, and what they may be
   * of; a message in its place where no signal has any.
   */
  void write_lines(const RunSpectra &spectra, RunContext &context);

  /**
   * A finding: the strongest line of the velocities, and the eigenvalue beside
   * it.
   */
  void note_strongest_line(const RunSpectra &spectra, RunContext &context);
} // namespace RollingContact

#endif
