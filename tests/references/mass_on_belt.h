#ifndef rolling_contact_tests_references_mass_on_belt_h
#define rolling_contact_tests_references_mass_on_belt_h

namespace RollingContact::References
{
  /**
   * A mass on a spring that lies on a moving belt, the classical stick-slip
   * oscillator: m x'' + c x' + k x = N mu(v_b - x').
   */
  struct MassOnBelt
  {
    double mass, stiffness, damping; ///< kg, N/m, N s/m
    double load;                     ///< N
    double belt_speed;               ///< m/s
    double static_friction, kinetic_friction;

    /**
     * Growth of the oscillation about steady sliding with mu = mu_k + (mu_s -
     * mu_k) exp(-v / v_c): (N (mu_s - mu_k) exp(-v_b / v_c) / v_c - c) / (2 m).
     * Units: m/s, 1/s.
     */
    double growth(const double decay_speed) const;

    /**
     * The speed of the belt below which steady sliding with that law is
     * unstable, v_c ln(N (mu_s - mu_k) / (c v_c)); 0 where it is stable at any.
     * Units: m/s.
     */
    double critical_speed(const double decay_speed) const;

    /**
     * The cycle of sticking and sliding with two values of friction, mu_s at
     * rest and mu_k sliding, and no damping.
     */
    struct Cycle
    {
      double amplitude;  ///< m
      double stick_time; ///< s
      double slip_time;  ///< s
    };

    Cycle stick_slip_cycle() const;
  };
} // namespace RollingContact::References

#endif
