#ifndef rolling_contact_time_run_spectra_h
#define rolling_contact_time_run_spectra_h

#include <rolling_contact/algebra/dense_matrix.h>
#include <rolling_contact/algebra/spectral_lines.h>
#include <rolling_contact/algebra/third_octaves.h>
#include <rolling_contact/scene/run_signals.h>

#include <optional>
#include <vector>

namespace RollingContact
{
  class HistoryTable;
  struct RunContext;
  struct Situation;

  /**
   * How values of a kind of signal and their levels are named.
   */
  struct SignalUnits
  {
    std::string density;   ///< of a power spectral density, N2/Hz
    std::string level;     ///< of a level, dB_re_1N
    double      reference; ///< that of the level, in the unit of the signal
    std::string axis;      ///< of a level in a picture
  };

  SignalUnits units_of(const SignalKind kind);

  /**
   * A signal of a run and what is in it.
   */
  struct SignalSpectrum
  {
    RunSignal                          signal;
    Signals::PowerSpectrum             spectrum;
    std::vector<Signals::ThirdOctave>  bands;
    std::vector<Signals::SpectralLine> lines; ///< by frequency
  };

  /**
   * The spectra of a run, all of the same rows of history.csv and with the same
   * segments.
   */
  struct RunSpectra
  {
    double      step    = 0.; ///< of time, s
    std::size_t n_rows  = 0;
    std::size_t segment = 0; ///< rows

    std::optional<double> speed;        ///< of rolling if constant, m/s
    double                highest = 0.; ///< frequency to look at, Hz

    std::vector<SignalSpectrum> signals;

    /**
     * Eigenvalues of the vibrations about the state that the run started from;
     * empty if they are not known. Units: 1/s.
     */
    ComplexValues eigenvalues;
  };

  /**
   * Length of the steps of a scene's history. Units: s.
   */
  double step_of_history(const Situation &scene);

  /**
   * Up to which frequency a scene's run is looked at, see Spectrum/Highest
   * frequency; half the sampling rate at most. Units: Hz.
   */
  double highest_frequency(const Situation &scene);

  /**
   * The spectra of the rows of history.csv.
   */
  RunSpectra run_spectra(const Situation &scene, const HistoryTable &history);

  /**
   * Spectra of forces, velocities and heights of surfaces: spectrum.csv by
   * Welch's method, third_octaves.csv, lines.csv, with Output/Plot
   * spectrum.svg, and a spectrogram if one is asked for.
   * @p eigenvalues of the state that the run started from, as
   * StabilityPencil::eigenvalues(), stand beside the lines; empty where they
   * are not known. Findings tell how much and at which frequency the load
   * varies and what is the strongest line of the velocities. Only for the root.
   */
  void write_spectra(const Situation     &scene,
                     const HistoryTable  &history,
                     const ComplexValues &eigenvalues,
                     RunContext          &context);
} // namespace RollingContact

#endif
