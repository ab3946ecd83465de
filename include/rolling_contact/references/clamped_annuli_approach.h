#ifndef rolling_contact_references_clamped_annuli_approach_h
#define rolling_contact_references_clamped_annuli_approach_h

#include <rolling_contact/references/clamped_annulus.h>
#include <rolling_contact/references/hertz_line.h>

namespace RollingContact::References
{
  /**
   * Contact of two annuli: approach (m) of their clamped hubs.
   */
  struct AnnuliContact
  {
    HertzLine hertz;
    double    approach;
  };

  /**
   * Hertz contact of two annuli clamped at their hubs under a load per length
   * (N/m); the approach is the sum of the two exact compressions between hub
   * and middle of the patch.
   */
  AnnuliContact approach_of_two_clamped_annuli(const Annulus &first,
                                               const Annulus &second,
                                               const double   load_per_length);

  /**
   * Load per length (N/m) of two clamped annuli at an approach (m), zero if
   * that is not positive.
   */
  double load_of_two_clamped_annuli(const Annulus &first,
                                    const Annulus &second,
                                    const double   approach);
} // namespace RollingContact::References

#endif
