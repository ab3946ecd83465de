#ifndef rolling_contact_solvers_anderson_h
#define rolling_contact_solvers_anderson_h

#include <rolling_contact/algebra/nodal_field.h>

#include <cstddef>
#include <deque>

namespace RollingContact
{
  /**
   * Anderson acceleration of a fixed-point iteration x = G(x): the combination
   * of the last @p depth images whose residual G(x) - x is smallest (Walker and
   * Ni 2011). Has no units of its own.
   */
  class Anderson
  {
  public:
    explicit Anderson(const std::size_t depth)
      : depth(depth)
    {}

    /**
     * The next iterate from x and its image G(x).
     */
    NodalField next(const NodalField &x, const NodalField &image);

  private:
    std::size_t            depth;
    std::deque<NodalField> images, residuals;
  };
} // namespace RollingContact

#endif
