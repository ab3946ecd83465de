#ifndef rolling_contact_bodies_extrapolated_guess_h
#define rolling_contact_bodies_extrapolated_guess_h

#include <rolling_contact/bodies/distributed_matrices.h>

namespace RollingContact
{
  /**
   * Initial guess for a solution that changes little from step to step: linear
   * extrapolation of the last two, the last one, or zero. Not collective.
   */
  struct ExtrapolatedGuess
  {
    DistributedVector now, before;
    unsigned int      n_known = 0;

    /**
     * Replace `now`, the last solution, by the guess for the next one.
     */
    void extrapolate()
    {
      if (n_known == 0)
        now = 0.;
      const DistributedVector last = now;
      if (n_known > 1)
        now.sadd(2., -1., before);
      before  = last;
      n_known = n_known == 0 ? 1 : 2;
    }

    /**
     * Take the next guess as zero.
     */
    void forget()
    {
      n_known = 0;
    }
  };
} // namespace RollingContact

#endif
