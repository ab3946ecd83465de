#ifndef rolling_contact_bodies_theta_scheme_h
#define rolling_contact_bodies_theta_scheme_h

namespace RollingContact
{
  /**
   * The theta-scheme of Moreau and Jean with Rayleigh damping,
   * C = mass_damping M + stiffness_damping K: from v0, u0 a step h leads to
   * u1 = u0 + h v_th, v_th = theta v1 + (1 - theta) v0. Units: 1, 1/s, s.
   */
  struct ThetaScheme
  {
    double theta             = 0.5;
    double mass_damping      = 0.;
    double stiffness_damping = 0.;

    /**
     * Throws InputError unless theta is in [0.5, 1] and damping not negative.
     */
    void check() const;
  };

  /**
   * Energies after a step, and what the step did. With dv, du the changes of
   * velocity and displacement,
   *   change of (kinetic + strain) = contact_work + load_work - damping
   *                                  - numerical_dissipation + balance_error,
   * balance_error being rounding. Units: J.
   */
  struct StepEnergy
  {
    double kinetic               = 0.; ///< v^T M v / 2
    double strain                = 0.; ///< u^T K u / 2
    double contact_work          = 0.; ///< h r . v_th
    double load_work             = 0.; ///< h f . v_th
    double damping               = 0.; ///< h v_th^T C v_th
    double numerical_dissipation = 0.; ///< (theta - 1/2)(|dv|_M^2 + |du|_K^2)
    double balance_error         = 0.;

    /** For Boost.Serialization. A member not listed here does not compile. */
    template <typename Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      auto &[kinetic,
             strain,
             contact_work,
             load_work,
             damping,
             numerical_dissipation,
             balance_error] = *this;
      archive &kinetic &strain &contact_work &load_work &damping
        &numerical_dissipation &balance_error;
    }

    /**
     * Find balance_error from the kinetic and strain energy before.
     */
    void balance(const double energy_before);

    /**
     * Add what another step, or another body in the same step, did.
     */
    void add_changes(const StepEnergy &other);
  };
} // namespace RollingContact

#endif
