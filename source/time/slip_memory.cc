#include <rolling_contact/contact/resultants.h>
#include <rolling_contact/time/slip_memory.h>

#include <algorithm>

namespace RollingContact
{
  namespace
  {
    NodalField scaled(NodalField field, const double factor)
    {
      field *= factor;
      return field;
    }
  } // namespace

  SlipMemory slip_memory(const ContactProblem &problem,
                         const ContactState   &state,
                         const double          speed)
  {
    SlipMemory memory;
    if (problem.n_tangential() == 0)
      return memory;
    const TangentialProblem friction = tangential_problem(problem, state);
    memory.mean                      = scaled(friction.mean_slip(state), speed);
    memory.sliding = scaled(friction.slip(state.traction), speed);
    memory.power = dissipation(problem.operators, state.traction, memory.mean);

    const ContactLoads &loads  = problem.loads;
    const auto          states = node_states(friction, state);
    for (unsigned int c = 0; c < problem.n_tangential(); ++c)
      for (unsigned int i = 0; i < problem.n_nodes(); ++i)
        {
          double      &velocity = memory.sliding(c, i);
          const double share =
            loads.slip_share.empty() ? 1. : loads.slip_share[i];
          if (share < 1.)
            velocity = (velocity - speed * loads.slip_before(c, i)) / share;
          else if (states[i] == NodeState::stick)
            velocity = 0.;
        }
    return memory;
  }

  SlipWithinStep::SlipWithinStep(const SlipMemory &before,
                                 const double      theta,
                                 const double      speed,
                                 ContactLoads     &loads)
    : before(before)
  {
    loads.slip_share.clear();
    loads.slip_before = NodalField();
    if (theta == 1. || before.sliding.empty())
      return;
    loads.slip_before = scaled(before.sliding, (1 - theta) / speed);
    for (std::size_t i = 0; i < before.sliding.n_nodes(); ++i)
      loads.slip_share.push_back(before.sliding.norm_at(i) > 0. ? theta : 1.);
  }

  bool SlipWithinStep::bring_to_rest(const ContactProblem &problem,
                                     const ContactState   &state,
                                     ContactLoads         &loads) const
  {
    if (loads.slip_share.empty())
      return false;
    const auto states = node_states(tangential_problem(problem, state), state);
    bool       any    = false;
    for (unsigned int i = 0; i < problem.n_nodes(); ++i)
      if (states[i] == NodeState::stick && loads.slip_share[i] < 1.)
        {
          any                 = true;
          loads.slip_share[i] = 1.;
          for (unsigned int c = 0; c < problem.n_tangential(); ++c)
            loads.slip_before(c, i) = 0.;
        }
    return any;
  }

  double heat_within_step(const SlipMemory     &before,
                          const double          theta,
                          const double          h,
                          const ContactProblem &problem,
                          const ContactState   &state,
                          SlipMemory           &after)
  {
    const double heat =
      before.debt +
      h * (theta * after.power + (1 - theta) * dissipation(problem.operators,
                                                           state.traction,
                                                           before.mean));
    after.debt = std::min(heat, 0.);
    return std::max(heat, 0.);
  }
} // namespace RollingContact
