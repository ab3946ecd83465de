#ifndef rolling_contact_algebra_spectrogram_h
#define rolling_contact_algebra_spectrogram_h

#include <rolling_contact/algebra/welch.h>

#include <vector>

namespace RollingContact::Signals
{
  /**
   * Spectra of windows one after the other.
   */
  struct Spectrogram
  {
    double frequency_step = 0.; ///< Hz

    /** Middles of the windows from the time of the first value on. Units: s. */
    std::vector<double> times;

    /**
     * Mean square at each line k * frequency_step of each window: the spectral
     * density times the noise bandwidth of Hann's window, 1.5 lines, so that a
     * tone on a line shows its own mean square and one between two lines up to
     * 1.4 dB less. Units: square of the values'.
     */
    std::vector<std::vector<double>> mean_squares;
  };

  /**
   * Short-time spectra of values at equal time steps, each about the mean of
   * its window under Hann's. Windows of so many values overlap by three
   * quarters, or less where there would be more than @p most of them. Units: s.
   */
  Spectrogram spectrogram(const std::vector<double> &values,
                          const double               time_step,
                          const std::size_t          window,
                          const std::size_t          most = 400);
} // namespace RollingContact::Signals

#endif
