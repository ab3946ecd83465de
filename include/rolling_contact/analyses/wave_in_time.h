#ifndef rolling_contact_analyses_wave_in_time_h
#define rolling_contact_analyses_wave_in_time_h

#include <rolling_contact/solvers/contact_solver.h>
#include <rolling_contact/stability/wave_sweep.h>

#include <complex>
#include <vector>

namespace RollingContact
{
  /**
   * A wave whose passage is followed in time: amplitude * cos(k (V t - x)) out
   * of a body that rolls at a speed V, x along the flow. Units: 1/m, m, m/s.
   */
  struct FollowedWave
  {
    double       wave_number = 0., amplitude = 0., speed = 0.;
    unsigned int n_steps = 0; ///< in a period
    /** The state is found to this residual, and the run ends after so many
     * periods if it does not settle. */
    double       tolerance    = 1e-11;
    unsigned int most_periods = 200;
  };

  /**
   * Steps of a period of a wave: at most an element's length of rolling long,
   * at least 60 in the period, by which the midpoint rule takes the wave for
   * 0.1 % slower, and at least two in that of each mode of the pair, as faster
   * ones would not stay stable. Units: m/s, 1/m, m.
   */
  unsigned int steps_of_period(const ReducedPair &pair,
                               const double       speed,
                               const double       wave_number,
                               const double       element);

  /**
   * What a wave does in time, the part of it that goes as the wave does, over
   * its amplitude: growth over k_w in J/m^3, load in N/m, see PassedWave.
   */
  struct WaveInTime
  {
    std::complex<double> growth, load;
    unsigned int         n_periods = 0;
    double change  = 0.;    ///< of growth in the last period, over its size
    bool   settled = false; ///< whether that is small
    /** Nodes that were open, stuck or slid in a part of that period alone. With
     * none of them the answer to the wave is nearly linear. */
    unsigned int n_changed = 0;
  };

  /**
   * Follow a wave that passes the contact of a steady state through time, by
   * the laws of contact as they are: bodies by the modes of @p waves at the
   * speed of this number, with their losses at the frequency of the wave, in
   * equal steps by the implicit midpoint rule of ReducedMotion. It begins in
   * the linear answer to the wave, so that little has to settle, and ends when
   * growth stays the same from period to period.
   *
   * What friction wears off while the wave passes is deposited on the material:
   * that of node i in the middle t of a step at X = x_i - V t, over the nodes'
   * lengths along the flow. Growth is how much of the deposit goes as the wave,
   *
   *   G = 2 / (n r) sum_m sum_i c_j h_i / V (q . v)_i,m exp(i k (x_i - V t_m)),
   *
   * of amplitude r and over n steps m of a period. The approach and the
   * creepages are held, as they are in the linear answer.
   *
   * @p problem, @p state: those of @p waves; @p border: nodes that a patch must
   * not reach. Throws ConvergenceError where a step finds no state, or one that
   * reaches the border.
   */
  WaveInTime wave_in_time(const ContactProblem       &problem,
                          const ContactState         &state,
                          const LinearContactOptions &options,
                          const WaveSweep            &waves,
                          const std::size_t           speed,
                          const FollowedWave         &wave,
                          const std::vector<bool>    &border);
} // namespace RollingContact

#endif
