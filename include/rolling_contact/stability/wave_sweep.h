#ifndef rolling_contact_stability_wave_sweep_h
#define rolling_contact_stability_wave_sweep_h

#include <rolling_contact/stability/wave_growth.h>

#include <functional>
#include <memory>
#include <vector>

namespace RollingContact
{
  /**
   * A wave of unit height as it passes: how it grows, what load it makes, and
   * how the bodies answer at its frequency.
   */
  struct PassedWave
  {
    /** Over the wear coefficient k_w. Units: J/m^3. */
    Growth               growth;
    std::complex<double> load; ///< N/m
    /** |load| over that of a motion of the whole patch at the same rate: what
     * the contact filter leaves of the wave. */
    double filter = 1.;

    /** How a flat punch on the patch answers a force along x and along z, the
     * bodies' own elasticity there left to the punch: wheel and rail together.
     * Units: m/N. */
    std::complex<double> receptance_x, receptance_z;
  };

  /**
   * Waves of all lengths over one steady state, rolled over at some speeds,
   * which its friction does not depend on.
   */
  class WaveSweep
  {
  public:
    /** The bodies as they are at a speed, m/s. */
    using BodiesAtSpeed = std::function<ReducedPair(const double)>;

    /**
     * The @p state of @p problem, linearised as @p options say but for the
     * speed, at all @p speeds (m/s); @p thickness: in 2D, m. Keeps a reference
     * to the problem. Throws InputError, see linear_contact().
     */
    WaveSweep(const ContactProblem       &problem,
              const ContactState         &state,
              const LinearContactOptions &options,
              const double                thickness,
              const std::vector<double>  &speeds,
              const BodiesAtSpeed        &bodies);

    /** The bodies at each speed, for waves of this number: those over other
     * nodes of the same bodies share them. Units: 1/m. */
    std::vector<ModalFactors> modal(const double wave_number) const;

    /** A wave at each speed. Units: 1/m. Throws ConvergenceError. */
    std::vector<PassedWave> at(const double                     wave_number,
                               const std::vector<ModalFactors> &modal) const;

    /** A wave at the speed of this number with whole bodies, see
     * WaveResponse::corrected(). */
    PassedWave corrected(const double        wave_number,
                         const std::size_t   speed,
                         const BodyResponse &bodies,
                         const unsigned int  n_steps) const;

    /** The contact's answer to a wave of unit height at the speed of this
     * number. Units: 1/m. Throws ConvergenceError. */
    WaveAnswer answer(const double wave_number, const std::size_t speed) const;

    /** Waves that pass the touching nodes, as columns b of the normal rows. */
    using Waves =
      std::function<ComplexMatrix(const WaveGrowth &, const double)>;

    /** How the patch reacts to its motions and to waves of this number, at the
     * speeds of these numbers. Units: 1/m. Throws ConvergenceError. */
    std::vector<WaveResponse::Reaction>
    reactions(const double                    wave_number,
              const Waves                    &waves,
              const std::vector<std::size_t> &at_speeds) const;

    /** U^T Phi, how coordinates move the patch at the speed of this number, by
     * columns. */
    const DenseMatrix &motions_of_coordinates(const std::size_t speed) const
    {
      return cases.at(speed)->response.motions_of_coordinates();
    }

    /** The bodies at the speed of this number. */
    const ReducedPair &bodies(const std::size_t speed) const
    {
      return cases.at(speed)->pair;
    }

    /** How waves grow at the speed of this number. */
    const WaveGrowth &growth(const std::size_t speed) const
    {
      return cases.at(speed)->growth;
    }

    /** The contact at the first speed. */
    const LinearContact &contact() const
    {
      return cases.front()->contact;
    }

  private:
    /** Nodal forces of a flat punch, and how the bodies answer them. */
    struct Punch
    {
      Punch(const std::vector<double> &forces,
            const ReducedPair         &pair,
            const DenseMatrix         &motions);

      /** Units: m/N. */
      std::complex<double> receptance(const WaveResponse::AtWave &at) const;

      double          at_rest;    ///< m/N
      Eigen::VectorXd on_motions; ///< U^T forces
    };

    struct AtSpeed
    {
      /** @p other: the same contact and modes at another speed, or nullptr. */
      AtSpeed(const ContactProblem &problem,
              const ContactState   &state,
              LinearContact         contact,
              const double          speed,
              ReducedPair           bodies,
              const double          thickness,
              const AtSpeed        *other);

      /** What an answer at this speed amounts to. */
      PassedWave passed(const double                wave_number,
                        const WaveResponse::AtWave &at,
                        const WaveAnswer           &answer) const;

      LinearContact contact;
      ReducedPair   pair;
      WaveGrowth    growth;
      DenseMatrix   motions;
      WaveResponse  response;
      Punch         punch_x, punch_z;
    };

    std::vector<std::unique_ptr<const AtSpeed>> cases;
  };
} // namespace RollingContact

#endif
