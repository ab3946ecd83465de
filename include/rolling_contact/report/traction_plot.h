#ifndef rolling_contact_report_traction_plot_h
#define rolling_contact_report_traction_plot_h

#include <rolling_contact/state/steady_state.h>

namespace RollingContact
{
  /**
   * Write tractions.svg: p/p0 and q/(mu p0) along the patch of a 2D state, with
   * Hertz and, where it applies, Carter.
   */
  void
  plot_line_tractions(const SceneParameters &scene,
                      const SteadyState<2>  &steady,
                      RunFolder             &folder);
} // namespace RollingContact

#endif
