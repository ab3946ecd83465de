#ifndef rolling_contact_algebra_third_octaves_h
#define rolling_contact_algebra_third_octaves_h

#include <rolling_contact/algebra/welch.h>

#include <optional>
#include <vector>

namespace RollingContact::Signals
{
  /**
   * A third-octave band of base ten, IEC 61260-1: exact centre 10^(k/10) Hz and
   * edges 10^(1/20) below and above it.
   */
  struct ThirdOctave
  {
    double centre = 0.; ///< Hz
    /**
     * Mean square of the signal between the edges of the band, in the square of
     * its unit; none if fewer than four lines of the spectrum lie there.
     */
    std::optional<double> mean_square;

    double lower_edge() const;

    double upper_edge() const;
  };

  /**
   * The bands from the first one with lines of the spectrum to the last one
   * whose upper edge the spectrum reaches. A line stands for the frequencies
   * within half a step of it, and counts in each band by its share.
   */
  std::vector<ThirdOctave> third_octaves(const PowerSpectrum &spectrum);

  /**
   * Level of a mean square in dB re the square of @p reference.
   */
  double level(const double mean_square, const double reference);
} // namespace RollingContact::Signals

#endif
