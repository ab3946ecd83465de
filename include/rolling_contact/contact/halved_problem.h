#ifndef rolling_contact_contact_halved_problem_h
#define rolling_contact_contact_halved_problem_h

#include <rolling_contact/contact/contact_problem.h>
#include <rolling_contact/contact/operators.h>
#include <rolling_contact/contact/surface_coupling.h>

#include <array>
#include <optional>
#include <vector>

namespace RollingContact
{
  /**
   * The contact problem of the same bodies and loads on elements of twice the
   * length.
   */
  struct HalvedProblem
  {
    ContactProblem            problem;
    Trace                     trace;
    std::vector<unsigned int> nodes;    ///< their numbers in the whole problem
    SurfaceCoupling           coupling; ///< R, of the whole problem's nodes

    /**
     * Take the loads and the frames of the whole problem, but for loads that
     * are found anew with each state: its creepages and its normal load stay.
     */
    void take(const ContactProblem &whole);
  };

  /**
   * The problem without loads and frames on every second node, in both
   * directions, of the grid that the largest elements of a @p trace make: those
   * with even or odd numbers in the lines along x and y as @p odd says. A nodal
   * force is spread over the nodes around as the shape function of the larger
   * elements spreads it, over equal elements with the weights 1/4, 1/2, 1/4 in
   * each direction, and a displacement is taken with the same weights: W = R W
   * R^T. The matrix H is that of the kind @p matrices, with the @p thickness of
   * plane bodies in m. None if the elements make no grid.
   */
  std::optional<HalvedProblem>
  halved_problem(const ContactProblem              &whole,
                 const Trace                       &trace,
                 const ContactMatrices              matrices,
                 const double                       thickness,
                 const std::array<unsigned int, 2> &odd);

  /**
   * A state of the whole problem at the nodes of the half, to start from.
   */
  ContactState halved_state(const HalvedProblem &half,
                            const ContactState  &whole);
} // namespace RollingContact

#endif
