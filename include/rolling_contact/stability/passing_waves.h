#ifndef rolling_contact_stability_passing_waves_h
#define rolling_contact_stability_passing_waves_h

#include <rolling_contact/stability/wave_sweep.h>

#include <utility>
#include <vector>

namespace RollingContact
{
  /**
   * Heights of waves of unit mean square at nodes with these places along the
   * flow and across it, of which lines along the flow cohere by
   * exp(-c k |y - y'|): columns b of waves that are incoherent with each other,
   *
   *   sum_m b_im b_jm^* = exp(-i k (x_i - x_j) - c k |y_i - y_j|).
   *
   * With c = 0 there is one, the plane wave; otherwise one for each line.
   * Units: 1/m, 1, m.
   */
  ComplexMatrix random_waves(const std::vector<double> &along,
                             const std::vector<double> &across,
                             const double               wave_number,
                             const double               coherence);

  /**
   * Bodies under waves that pass at one speed, at many frequencies. What the
   * patch does is smooth in the wave number: it is found at equal ratios and
   * interpolated by cubics; the modes are exact at each frequency.
   */
  struct PassingWaves
  {
    /** Columns: waves that are incoherent with each other. */
    struct Passed
    {
      ComplexMatrix    amplitudes; ///< of all coordinates, m kg^(1/2)
      Eigen::VectorXcd loads;      ///< normal ones, N
      ComplexMatrix    watched;    ///< forces on ReducedPair::watched, N
    };

    /** Units: Hz. */
    ModalFactors modal(const double frequency) const;

    /** @p modal: those of the bodies at this frequency, which waves over other
     * nodes share. Units: Hz. */
    Passed at(const double frequency, const ModalFactors &modal) const;

    const WaveSweep &sweep;
    std::size_t      number; ///< of the speed in it
    double           speed;  ///< m/s

    /** Four or more, of wave numbers from first (1/m) on, each ratio times the
     * one before. */
    double                              first, ratio;
    std::vector<WaveResponse::Reaction> reactions;
  };

  /**
   * Passing waves at all speeds (m/s) of a sweep, each with wave numbers
   * between two (1/m), by reactions at nine waves a third octave, whose factors
   * all speeds share. Keeps a reference to the sweep. Throws ConvergenceError.
   */
  std::vector<PassingWaves>
  passing_waves(const WaveSweep                              &sweep,
                const std::vector<double>                    &speeds,
                const std::vector<std::pair<double, double>> &wave_numbers,
                const WaveSweep::Waves                       &waves);
} // namespace RollingContact

#endif
