#include <rolling_contact/contact/tangential_problem.h>
#include <rolling_contact/time/patch_friction.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /// m is found to this
    const double tolerance = 1e-11;
  } // namespace

  double mean_sliding_speed(const ContactProblem &problem,
                            const ContactState   &state)
  {
    const TangentialProblem   friction = tangential_problem(problem, state);
    const std::vector<double> speeds =
      friction.sliding_speeds(friction.slip(state.traction));
    double load = 0., sum = 0.;
    for (unsigned int i = 0; i < problem.n_nodes(); ++i)
      {
        const double part = problem.operators.areas()[i] * state.pressure[i];
        load += part;
        sum += part * speeds[i];
      }
    return load > 0. ? sum / load : 0.;
  }

  PatchFriction::PatchFriction(const ContactProblem &problem,
                               const ContactState   &state,
                               const double          delay)
    : law(problem.loads.friction_law)
    , delay(delay)
    , of_start(tangential_problem(problem, state).friction)
    , of_rest(problem.loads.friction)
  {
    last.share = last.target = share_of_start = target(problem, state);
    for (unsigned int i = 0; i < problem.n_nodes(); ++i)
      if (!(state.pressure[i] > 0.)) // takes the mean when it touches
        of_start[i] = of_rest[i] * share_of_start;
  }

  double PatchFriction::target(const ContactProblem &problem,
                               const ContactState   &state) const
  {
    return 1 - law->drop(mean_sliding_speed(problem, state));
  }

  void PatchFriction::begin_step(const double distance)
  {
    step  = distance / delay;
    tries = 0;
    tried = {(last.share * (1 - step / 2) + step * last.target) /
               (1 + step / 2),
             last.target};
  }

  std::vector<double> PatchFriction::coefficients() const
  {
    return coefficients_for(tried.share);
  }

  std::vector<double> PatchFriction::coefficients_now() const
  {
    return coefficients_for(last.share);
  }

  std::vector<double> PatchFriction::coefficients_for(const double share) const
  {
    std::vector<double> mu = of_start;
    for (std::size_t i = 0; i < mu.size(); ++i)
      mu[i] = std::max(0., mu[i] + of_rest[i] * (share - share_of_start));
    return mu;
  }

  bool PatchFriction::agrees(const ContactProblem &problem,
                             const ContactState   &state)
  {
    tried.target = target(problem, state);
    implied =
      (last.share * (1 - step / 2) + step / 2 * (last.target + tried.target)) /
      (1 + step / 2);
    const double missing = implied - tried.share;
    if (std::abs(missing) <= tolerance || failed())
      return true;
    // the secant, once there are two points
    double next = implied;
    if (tries > 0)
      {
        const double missing_before = implied_before - tried_before,
                     change         = missing - missing_before;
        if (change != 0.)
          next = tried.share - missing * (tried.share - tried_before) / change;
      }
    tried_before   = tried.share;
    implied_before = implied;
    tried.share    = next;
    ++tries;
    return false;
  }

  void PatchFriction::end_step()
  {
    last = tried;
  }

  void PatchFriction::disturb(const double change, const double rate)
  {
    last.share += change;
    last.target += change + delay * rate;
  }
} // namespace RollingContact
