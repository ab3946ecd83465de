#ifndef rolling_contact_vibration_vibrations_h
#define rolling_contact_vibration_vibrations_h

#include <rolling_contact/scene/situation.h>
#include <rolling_contact/stability/correction.h>
#include <rolling_contact/stability/linear_contact.h>
#include <rolling_contact/stability/pencil.h>
#include <rolling_contact/vibration/rolling_modes.h>

#include <optional>
#include <vector>

namespace RollingContact
{
  /**
   * A vibration about the steady state and what is known of it.
   */
  struct Finding
  {
    StabilityMode                mode;
    std::optional<CorrectedMode> corrected;

    double growth() const
    {
      return corrected ? corrected->growth() : mode.growth();
    }

    bool unstable() const
    {
      return corrected ? corrected->unstable() : mode.growth() > 0.;
    }
  };

  /** The speed and the friction that a scene linearises its states with. */
  LinearContactOptions linear_contact_options(const Situation &scene);

  /**
   * All small vibrations about a steady rolling state, in the frequencies that
   * the scene looks at: from Stability/Lowest frequency to Modes/Maximum
   * frequency.
   */
  class Vibrations
  {
  public:
    /**
     * The state of @p problem disturbed, @p pair: the bodies under the
     * conditions of the scene. Throws InputError, see linear_contact().
     */
    Vibrations(const Situation      &scene,
               ReducedPair           pair,
               const ContactProblem &problem,
               const ContactState   &state);

    const ReducedPair &bodies() const
    {
      return pair;
    }

    const LinearContact &contact() const
    {
      return linear;
    }

    /** All eigenvalues, of any frequency. Units: 1/s. */
    const ComplexValues &eigenvalues() const
    {
      return all;
    }

    /**
     * The eigenvalues that grow and the n_stable least damped of the others.
     */
    ComplexValues least_damped(const std::size_t n_stable) const;

    /**
     * The number of those that grow by more than @p least_growth (1/s).
     */
    std::size_t n_unstable(const double least_growth = 0.) const;

    /**
     * The real eigenvalues that grow: the contact itself, no vibration. Units:
     * 1/s.
     */
    std::vector<double> real_growth() const;

    /**
     * The vibrations of eigenvalues, corrected by the whole bodies if they are
     * given.
     */
    template <int dim>
    std::vector<Finding> find(const ComplexValues    &eigenvalues,
                              const WholeBodies<dim> *bodies) const;

  private:
    bool is_looked_at(const std::complex<double> s) const;

    const double      lowest, highest; ///< rad/s
    CorrectionOptions options;
    ReducedPair       pair;
    LinearContact     linear;
    StabilityPencil   pencil;
    ComplexValues     all;
  };
} // namespace RollingContact

#endif
