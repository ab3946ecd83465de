#ifndef rolling_contact_results_profile_plot_h
#define rolling_contact_results_profile_plot_h

#include <rolling_contact/run/run_context.h>
#include <rolling_contact/scene/pair_spec.h>
#include <rolling_contact/state/steady_state.h>

namespace RollingContact
{
  /**
   * Write a picture, NAME.svg, of a state on profiles: both sections in the
   * track with the first contact, the plane of contact, its normal and the
   * patches, and below them the largest pressure and the heat of friction of
   * each line of nodes along x. Nothing if the bodies have other surfaces.
   */
  void plot_profiles(const PairSpec       &scene,
                     const SteadyState<3> &steady,
                     RunContext           &context,
                     const std::string    &name = "profiles");
} // namespace RollingContact

#endif
