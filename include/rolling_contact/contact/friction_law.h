#ifndef rolling_contact_contact_friction_law_h
#define rolling_contact_contact_friction_law_h

#include <memory>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * How friction follows the sliding speed when a steady state is disturbed.
   */
  enum class FrictionResponse
  {
    constant,  ///< each node keeps the mu it has
    node,      ///< mu of each node follows its own speed at once
    patch_mean ///< mu of all follows their mean speed with a delay
  };

  /**
   * Velocity-dependent (falling) friction: how the friction coefficient falls
   * with the sliding speed v = |s| V (m/s) from its static value mu_s, mu(v) =
   * mu_s (1 - drop(v)). The drop is 0 at rest, grows and is concave: mu falls
   * most steeply at rest.
   */
  class FrictionLaw
  {
  public:
    virtual ~FrictionLaw() = default;

    /**
     * Drop of the friction coefficient at a sliding speed v, 1 - mu(v) / mu_s.
     * Units: m/s to 1.
     */
    virtual double drop(const double speed) const = 0;

    /**
     * Derivative of the drop by the speed. Units: m/s to s/m.
     */
    virtual double slope(const double speed) const = 0;

    /**
     * The speed over which mu falls. Units: m/s.
     */
    virtual double decay_speed() const = 0;

    /**
     * How steeply mu / mu_s can fall from a node that slides with speed v and
     * carries the traction @p carried mu_s p to any other state of that node:
     * the largest (carried - mu(w) / mu_s) / (w - v) over all speeds w. A
     * slipping node can stick; a sticking one can slip if it carries more than
     * the least mu. Not positive where nothing can fall. Units: s/m.
     */
    double steepest_fall(const double carried, const double speed) const;
  };

  /**
   * A law as Contact/Friction law and --print-parameters know it.
   */
  struct FrictionLawKind
  {
    using Maker =
      std::unique_ptr<const FrictionLaw> (*)(const double kinetic_over_static,
                                             const double decay_speed);

    std::string name;
    std::string help;
    Maker       make; ///< nullptr for friction that does not fall
  };

  /**
   * All friction laws, constant friction first.
   */
  const std::vector<FrictionLawKind> &friction_law_kinds();

  /**
   * The law of a name in friction_law_kinds() with the ratio mu_k / mu_s of
   * kinetic to static friction and the speed v_c (m/s); nullptr for `constant`:
   *
   *   exponential  mu = mu_k + (mu_s - mu_k) exp(-v / v_c), the decay of
   *                CONTACT with its s_h = v_c ln 2, and Polach's (2005) mu_s
   *                ((1 - A) exp(-B v) + A) with A = mu_k / mu_s, B = 1 / v_c:
   *                dry A = 0.4, B = 0.6 s/m;
   *   rational     mu = mu_k + (mu_s - mu_k) / (1 + v / v_c), as in CONTACT
   *                with s_h = v_c (Vollebregt and Schuttelaars 2012).
   */
  std::unique_ptr<const FrictionLaw>
  make_friction_law(const std::string &name,
                    const double       kinetic_over_static,
                    const double       decay_speed);
} // namespace RollingContact

#endif
