#ifndef rolling_contact_vibration_excitation_h
#define rolling_contact_vibration_excitation_h

#include <rolling_contact/stability/pencil.h>
#include <rolling_contact/vibration/reduced_motion.h>

namespace RollingContact
{
  /**
   * A free vibration of bodies and contact about a steady state, the real part
   * of a multiple of a StabilityMode times exp(s t), with all that a motion in
   * time needs to begin in it.
   */
  class Excitation
  {
  public:
    /**
     * The multiple of @p mode for which the largest component of the velocity
     * of wheel over rail at a touching node is @p velocity at t = 0, and real
     * there. Throws InputError if the mode does not move the contact. Units:
     * m/s.
     */
    Excitation(const ReducedPair   &pair,
               const LinearContact &contact,
               const StabilityMode &mode,
               const double         velocity);

    /**
     * Add it to a state at t = 0 that steps of length @p h follow, to the
     * forces of which half a step and one and a half before as well. Units: s.
     */
    void add_to(ReducedState &state, const double h) const;

    /**
     * Disturbance of the friction of the patch, m of LinearContact, at a time;
     * 0 without one. Units: s, 1.
     */
    double friction(const double time) const;

    std::complex<double> eigenvalue() const
    {
      return s;
    }

  private:
    std::complex<double> s;
    ComplexVector        modal;  ///< m kg^(1/2)
    ComplexVector        forces; ///< g of ReducedPair, N
    std::complex<double> friction_share = 0.;
  };

  /**
   * The growing vibration among @p eigenvalues (1/s) whose frequency is nearest
   * to @p frequency (Hz); where none grows, the one nearest to i 2 pi frequency
   * in the complex plane. Throws InputError that names @p entry if there are
   * none.
   */
  std::complex<double> vibration_near(const ComplexValues &eigenvalues,
                                      const double         frequency,
                                      const std::string   &entry);
} // namespace RollingContact

#endif
