#ifndef rolling_contact_analyses_convergence_h
#define rolling_contact_analyses_convergence_h

namespace RollingContact
{
  /**
   * Order p of h^p from the changes between three meshes of which each has half
   * the element size of the one before: log2(|before| / |now|), kept between 1
   * and 3. Errors that scatter more than they fall would give less, and a
   * change that vanishes by chance any number.
   */
  double observed_order(const double change_before, const double change_now);

  /**
   * Richardson's limit of two values whose step or element size differs by @p
   * ratio > 1: fine + (fine - coarse) / (ratio^order - 1).
   */
  double extrapolated(const double coarse,
                      const double fine,
                      const double ratio,
                      const double order);
} // namespace RollingContact

#endif
