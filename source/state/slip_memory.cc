#include <rolling_contact/contact/resultants.h>
#include <rolling_contact/state/slip_memory.h>

namespace RollingContact
{
  namespace
  {
    NodalField
    scaled(NodalField field, const double factor)
    {
      field *= factor;
      return field;
    }
  } // namespace



  SlipMemory
  slip_memory(const ContactProblem &problem,
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
    , theta(theta)
    , speed(speed)
  {
    loads.slip_share.clear();
    loads.slip_before = NodalField();
    if (theta == 1. || before.sliding.empty())
      return;
    const std::size_t n_nodes = before.sliding.n_nodes();
    n_changes.assign(n_nodes, 0);
    loads.slip_share.assign(n_nodes, 1.);
    loads.slip_before = NodalField(n_nodes, before.sliding.n_components());
    for (unsigned int i = 0; i < n_nodes; ++i)
      if (before.sliding.norm_at(i) > 0.)
        answer_theta(i, loads);
  }



  void
  SlipWithinStep::answer_theta(const unsigned int node,
                               ContactLoads      &loads) const
  {
    loads.slip_share[node] = theta;
    for (unsigned int c = 0; c < before.sliding.n_components(); ++c)
      loads.slip_before(c, node) =
        (1 - theta) / speed * before.sliding(c, node);
  }



  void
  SlipWithinStep::answer_end(const unsigned int node, ContactLoads &loads) const
  {
    loads.slip_share[node] = 1.;
    for (unsigned int c = 0; c < before.sliding.n_components(); ++c)
      loads.slip_before(c, node) = 0.;
  }



  bool
  SlipWithinStep::change(const ContactProblem &problem,
                         const ContactState   &state,
                         ContactLoads         &loads)
  {
    if (n_changes.empty())
      return false;
    const auto states = node_states(tangential_problem(problem, state), state);
    bool       any    = false;
    for (unsigned int i = 0; i < problem.n_nodes(); ++i)
      {
        double power = 0.; // of what it slid with
        for (unsigned int c = 0; c < problem.n_tangential(); ++c)
          power += state.traction(c, i) * before.sliding(c, i);
        const bool rests = n_changes[i] == 0 && states[i] == NodeState::stick &&
                           loads.slip_share[i] < 1.,
                   is_pushed = n_changes[i] == 1 && power > 0.;
        if (rests)
          answer_end(i, loads);
        if (is_pushed)
          answer_theta(i, loads);
        n_changes[i] += rests || is_pushed;
        any = any || rests || is_pushed;
      }
    return any;
  }



  double
  power_within_step(const SlipMemory     &before,
                    const SlipMemory     &after,
                    const double          theta,
                    const ContactProblem &problem,
                    const ContactState   &state)
  {
    return theta * after.power + (1 - theta) * dissipation(problem.operators,
                                                           state.traction,
                                                           before.mean);
  }
} // namespace RollingContact
