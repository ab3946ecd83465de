#include <rolling_contact/analyses/disturbed_state.h>
#include <rolling_contact/analyses/solve_to_target.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/results/bodies_report.h>
#include <rolling_contact/results/result_row.h>
#include <rolling_contact/results/state_report.h>

namespace RollingContact
{
  namespace
  {
    StateDemands
    demands_of_disturbed_state(const std::shared_ptr<SplitBodies> &split_bodies)
    {
      StateDemands demands;
      demands.pair.modes        = true;
      demands.pair.bulk_errors  = true;
      demands.pair.split_bodies = split_bodies;
      return demands;
    }
  } // namespace

  template <int dim>
  SteadyState<dim> disturbed_state(const Situation &scene, RunContext &context)
  {
    return DisturbedPlaces<dim>().state_at(scene, context);
  }

  template <int dim>
  DisturbedPlaces<dim>::DisturbedPlaces()
    : split_bodies(std::make_shared<SplitBodies>())
  {}

  template <int dim>
  const ModalBodies<dim> &
  DisturbedPlaces<dim>::modes_of(const SteadyState<dim> &steady,
                                 const Situation        &place,
                                 RunContext             &context)
  {
    const ModesParameters &wanted = place.inputs->modes;
    modes                         = std::make_unique<ModalBodies<dim>>(place,
                                               wanted,
                                               steady.pair->bodies(),
                                               wanted.cut_off(),
                                               context,
                                               modes.get());
    return *modes;
  }

  template <int dim>
  SteadyState<dim> DisturbedPlaces<dim>::state_at(const Situation &scene,
                                                  RunContext      &context)
  {
    if (!bodies_touch(scene))
      throw InputError("Analysis = " + scene.inputs->analysis.name +
                       " needs contact: check Contact/Approach and "
                       "Contact/Normal load.");
    Situation        used = scene;
    SteadyState<dim> steady =
      solve_to_target<dim>(used,
                           demands_of_disturbed_state(split_bodies),
                           TargetDemands(),
                           context,
                           [&](const SteadyState<dim> &level) {
                             add_result_row(scene, level, context);
                           });
    require_solved(scene, steady, "The steady rolling state");
    describe_bodies(steady, context);
    StateReview<dim> review(scene, context);
    review.add(steady);
    review.warn(steady);
    note_state(steady, context.report);
    return steady;
  }

  void warn_of_fixed_edges(const LinearContact   &contact,
                           const SlipOperatorKind kind,
                           Log                   &log)
  {
    const std::size_t n       = contact.touching.size(),
                      n_stick = n - contact.n_slip();
    if (contact.n_tangential > 0 && n_stick > 0 &&
        kind != SlipOperatorKind::calibrated)
      log.warning("Part of the patch sticks, " + std::to_string(n_stick) +
                  " of " + std::to_string(n) +
                  " nodes. Its leading edge moves with the load, and "
                  "Contact/Slip operator = " +
                  name_of(kind) + " leaves that out; take calibrated.");
  }

  template SteadyState<2> disturbed_state(const Situation &, RunContext &);
  template SteadyState<3> disturbed_state(const Situation &, RunContext &);
  template class DisturbedPlaces<2>;
  template class DisturbedPlaces<3>;
} // namespace RollingContact
