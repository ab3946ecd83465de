#ifndef rolling_contact_contact_refinement_marks_h
#define rolling_contact_contact_refinement_marks_h

#include <rolling_contact/contact/resultants.h>
#include <rolling_contact/contact/trace.h>

#include <vector>

namespace RollingContact
{
  /**
   * Why a cell of the trace is to be refined, the more urgent first: it is at
   * the leading edge, where traction begins; between stick and slip; at the
   * rest of the rim.
   */
  enum class RefinementMark
  {
    leading_rim,
    stick_border,
    trailing_rim,
    none
  };

  /**
   * Marks for the cells of the trace in a state. A rim cell has corners in and
   * out of contact; the mark covers the next two cells along x inside the
   * contact too, for the edge law wants equal elements there. A border cell has
   * corners that stick and corners that slip; its neighbours go with it. In 3D
   * the stick zone goes with the leading edge. Cells
   * that would stay coarse between finer ones on opposite sides are marked as
   * well: changes of size disturb the pressure.
   */
  std::vector<RefinementMark> refinement_marks(const Trace          &trace,
                                               const ContactProblem &problem,
                                               const ContactState   &state);
} // namespace RollingContact

#endif
