#ifndef rolling_contact_distributed_extrapolated_guess_h
#define rolling_contact_distributed_extrapolated_guess_h

#include <rolling_contact/distributed/distributed_matrices.h>

namespace RollingContact
{
  /**
   * A solution that changes little from step to step: the next one is guessed
   * on the line through the last two.
   */
  struct ExtrapolatedGuess
  {
    DistributedVector now, before;
    unsigned int      n_known = 0;

    /**
     * The guess becomes `now`.
     */
    void
    extrapolate()
    {
      if (n_known == 0)
        now = 0.;
      const DistributedVector last = now;
      if (n_known > 1)
        now.sadd(2., -1., before);
      before  = last;
      n_known = n_known == 0 ? 1 : 2;
    }

    void
    forget()
    {
      n_known = 0;
    }
  };
} // namespace RollingContact

#endif
