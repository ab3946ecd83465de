#ifndef rolling_contact_algebra_spectral_lines_h
#define rolling_contact_algebra_spectral_lines_h

#include <rolling_contact/algebra/welch.h>

#include <vector>

namespace RollingContact::Signals
{
  /**
   * A peak of a spectrum.
   */
  struct SpectralLine
  {
    double frequency   = 0.; ///< Hz, between the lines of the spectrum
    double mean_square = 0.; ///< of the values in the peak, their unit squared
    double prominence  = 0.; ///< dB above the deeper ground, see below
  };

  /**
   * What makes a peak a line. Units: dB, Hz.
   */
  struct LineCriteria
  {
    double      prominence = 10.;
    double      range      = 60.; ///< below the highest density
    double      highest    = 0.;  ///< frequency; 0: of the spectrum
    std::size_t most       = 24;  ///< the strongest ones
  };

  /**
   * The peaks of a spectrum under Hann's window, by frequency. With the larger
   * of the two neighbours of the highest density P_k and the ratio
   * a = sqrt(P_neighbour / P_k), a tone lies d = (2 a - 1) / (a + 1) steps from
   * k towards that neighbour: exactly, but for what leaks from others. The mean
   * square is that of the lines down to the ground on both sides, two at most,
   * which a tone of amplitude A fills with A^2/2. The prominence is the
   * height of the peak above the higher one of the two lowest densities between
   * it and higher peaks, or the end of the spectrum. The lowest two lines, in
   * which the mean is, have no peak.
   */
  std::vector<SpectralLine> spectral_lines(const PowerSpectrum &spectrum,
                                           const LineCriteria  &criteria);
} // namespace RollingContact::Signals

#endif
