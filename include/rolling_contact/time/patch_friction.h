#ifndef rolling_contact_time_patch_friction_h
#define rolling_contact_time_patch_friction_h

#include <rolling_contact/contact/contact_problem.h>

#include <memory>
#include <vector>

namespace RollingContact
{
  /**
   * One number m for the friction of the whole patch, and the value that the
   * mean sliding speed asked for, where the laws of the last step held.
   */
  struct PatchMemory
  {
    double share  = 1.; ///< m
    double target = 1.; ///< 1 - drop

    /** For Boost.Serialization. A member not listed here does not compile. */
    template <typename Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      auto &[share, target] = *this;
      archive &share &target;
    }
  };

  /**
   * Friction that falls with the mean sliding speed of the patch and with a
   * delay, in time steps:
   *
   *   tau m' = 1 - drop(sum w_i |v_i|) - m,      w = H^T p / sum,
   *   mu_i = mu_i0 + mu_s (m - m_0),
   *
   * mu_i0 and m_0 those of the state that a run begins with: each node keeps
   * the difference to the others that its own speed made there. Between the
   * places d apart where the laws of two steps hold, the trapezoidal rule; m
   * and the sliding speed of the step are found together, by the caller's
   * solutions with one constant mu for each node after another.
   */
  class PatchFriction
  {
  public:
    /**
     * Begin with the friction of a state that is solved, or of one that does
     * not touch. The problem has a law that falls. Units: s.
     */
    PatchFriction(const ContactProblem &problem,
                  const ContactState   &state,
                  const double          delay);

    /**
     * Begin a step, the laws of which hold @p distance after those of the last
     * one: a first guess of m. Units: s.
     */
    void begin_step(const double distance);

    /**
     * mu of the nodes for the m that is tried.
     */
    std::vector<double> coefficients() const;

    /**
     * mu of the nodes in the last step.
     */
    std::vector<double> coefficients_now() const;

    /**
     * True if the solution with these coefficients has the sliding speed that
     * they belong to; else another m is tried next, at most 30 times. Throws
     * nothing if these do not suffice, see failed().
     */
    bool agrees(const ContactProblem &problem, const ContactState &state);

    bool failed() const
    {
      return tries > 30;
    }

    /**
     * Keep m of the step.
     */
    void end_step();

    const PatchMemory &memory() const
    {
      return last;
    }

    void set_memory(const PatchMemory &memory)
    {
      last = memory;
    }

    /**
     * Disturb m by a vibration: its value at the last laws, and the derivative
     * there. Units: 1, 1/s.
     */
    void disturb(const double change, const double rate);

  private:
    std::vector<double> coefficients_for(const double share) const;

    /** 1 - drop of the mean speed. */
    double target(const ContactProblem &problem,
                  const ContactState   &state) const;

    std::shared_ptr<const FrictionLaw> law;
    double                             delay;
    std::vector<double>                of_start, of_rest; ///< mu_i0 and mu_s
    double                             share_of_start = 1.;
    PatchMemory                        last, tried;
    double                             step = 0.; ///< d / tau
    double       implied = 0., tried_before = 0., implied_before = 0.;
    unsigned int tries = 0;
  };

  /**
   * Mean sliding speed of a state, weighted with the nodes' parts of the load;
   * 0 without load. Units: m/s.
   */
  double mean_sliding_speed(const ContactProblem &problem,
                            const ContactState   &state);
} // namespace RollingContact

#endif
