#ifndef rolling_contact_contact_edge_examination_h
#define rolling_contact_contact_edge_examination_h

#include <rolling_contact/contact/touching_run.h>

namespace RollingContact
{
  /**
   * What the edge law must know of a run before it is applied.
   */
  struct EdgeExamination
  {
    /// The gap and the equivalent pressure are smooth at the scale of an
    /// element: the law is more exact than upwind 2.
    bool resolved = true;

    /// The tangentially equivalent pressure pulls at the first node, in some
    /// direction.
    bool barely_touches = false;
  };

  /**
   * Examine the leading edge of a @p run of touching nodes under the nodal @p
   * pressure (Pa); @p surplus is that of EdgePressure::equivalent() in each
   * tangential component (m).
   */
  EdgeExamination examine_edge(const ContactProblem                   &contact,
                               const TouchingRun                      &run,
                               const std::vector<double>              &pressure,
                               const std::vector<std::vector<double>> &surplus);
} // namespace RollingContact

#endif
