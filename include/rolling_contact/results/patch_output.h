#ifndef rolling_contact_results_patch_output_h
#define rolling_contact_results_patch_output_h

#include <rolling_contact/run/run_context.h>
#include <rolling_contact/scene/pair_spec.h>
#include <rolling_contact/state/steady_state.h>

#include <string>

namespace RollingContact
{
  /**
   * Write a table, NAME.csv, with a row for each contact node: its place and
   * all nodal_quantities() that the state has, vectors by components. Units:
   * SI, in the names of the columns.
   */
  template <int dim>
  void write_nodes(const PairSpec         &scene,
                   const SteadyState<dim> &steady,
                   RunContext             &context,
                   const std::string      &name = "nodes");

  /**
   * Write a picture, NAME.svg, of the patch of a converged state: the nodes
   * that touch with the traction on the wheel as arrows, in colours of stick
   * and slip, and below it pressure, traction and its bound along both lines of
   * nodes through the largest pressure. Nothing if nothing touches.
   */
  void plot_patch(const PairSpec       &scene,
                  const SteadyState<3> &steady,
                  RunContext           &context,
                  const std::string    &name = "patch");
} // namespace RollingContact

#endif
