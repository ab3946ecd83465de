#ifndef rolling_contact_contact_uniqueness_h
#define rolling_contact_contact_uniqueness_h

#include <rolling_contact/contact/contact_problem.h>

namespace RollingContact
{
  /**
   * Whether a state with velocity-dependent (falling) friction may be one of
   * several. Let another
   * state differ by ds in slip and dq in traction. Node by node the friction
   * law allows dq . ds <= L |ds|^2, with L = mu_s p V times
   * FrictionLaw::steepest_fall() from this state; the surfaces ask for ds = A
   * dq. For a symmetric A (in H), as that of W / (h V) in a time step, both
   * hold only if
   *
   *   ratio = largest eigenvalue of L^1/2 R L^1/2
   *
   * is at least 1, R the response of the nodes that can fall, see
   * sliding_response(); and for one node then they do: the ratio reaches 1
   * where a second solution appears. B1 makes A partly skew. Its
   * symmetric part is taken then, once with all nodes that can fall and once
   * with those that slip, and the ratio is an estimate: several steady states
   * of half-planes were found from 0.99 on, single ones up to 1.7.
   */
  struct Uniqueness
  {
    double       ratio = 0.;
    unsigned int node  = 0; ///< that has most part in it

    /**
     * Ratio from which other solutions must be expected.
     */
    static constexpr double limit = 0.8;

    bool possible() const
    {
      return ratio >= limit;
    }
  };

  /**
   * The ratio of @p state, which solves @p problem; zero without a friction law
   * or tangential components.
   */
  Uniqueness uniqueness(const ContactProblem &problem,
                        const ContactState   &state);
} // namespace RollingContact

#endif
