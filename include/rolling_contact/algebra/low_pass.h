#ifndef rolling_contact_algebra_low_pass_h
#define rolling_contact_algebra_low_pass_h

#include <rolling_contact/algebra/fourier.h>

#include <vector>

namespace RollingContact::Signals
{
  /**
   * Waves at least as long as @p passed keep their amplitude, those as short as
   * @p stopped or shorter have none, with half a cosine over the wave number in
   * between. No wave is shifted. Units: of length, passed > stopped >= 0.
   */
  struct CutOff
  {
    double passed  = 0.;
    double stopped = 0.;

    /**
     * What becomes of an amplitude. Units: waves per length; 1.
     */
    double gain(const double wave_number) const;
  };

  /**
   * Values on a grid, row by row, without their short waves: one with k waves
   * per length along and l across keeps what the cut-off leaves of
   * sqrt(k^2 + (stretch l)^2).
   */
  std::vector<double> low_pass(std::vector<double>  values,
                               const GridDirection &along,
                               const GridDirection &across,
                               const CutOff        &cut_off,
                               const double         stretch = 1.);

  /**
   * Root mean square of the values about zero.
   */
  double root_mean_square(const std::vector<double> &values);
} // namespace RollingContact::Signals

#endif
