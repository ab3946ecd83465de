#ifndef rolling_contact_algebra_low_pass_h
#define rolling_contact_algebra_low_pass_h

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
   * Values at equal spacing without their short waves; they go on periodically
   * after a spacing more.
   */
  std::vector<double> low_pass_periodic(const std::vector<double> &values,
                                        const double               spacing,
                                        const CutOff              &cut_off);

  /** Low pass of values that continue as mirror images beyond both ends. */
  std::vector<double> low_pass_mirrored(const std::vector<double> &values,
                                        const double               spacing,
                                        const CutOff              &cut_off);

  /**
   * Root mean square of the values about zero.
   */
  double root_mean_square(const std::vector<double> &values);
} // namespace RollingContact::Signals

#endif
