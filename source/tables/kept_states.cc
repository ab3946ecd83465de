#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/state/state_finder.h>
#include <rolling_contact/tables/kept_states.h>

namespace RollingContact
{
  template <int dim>
  typename std::list<typename KeptStates<dim>::Kept>::iterator
  KeptStates<dim>::last_of(const unsigned int kind, const std::string &bodies)
  {
    auto last = kept.end();
    for (auto it = kept.begin(); it != kept.end(); ++it)
      if ((bodies.empty() || it->bodies == bodies) &&
          it->used.count(kind) > 0 &&
          (last == kept.end() || it->used.at(kind) > last->used.at(kind)))
        last = it;
    return last;
  }

  template <int dim>
  bool KeptStates<dim>::reaches_all(const PairSpec    &scene,
                                    const unsigned int kind)
  {
    const auto last = last_of(kind);
    if (last == kept.end() || last->reaches(wanted_mesh(scene)))
      return true;
    kept.erase(last);
    return false;
  }

  template <int dim>
  bool KeptStates<dim>::Kept::take(const unsigned int next)
  {
    if (next == kind)
      return true;
    SteadyState<dim> &steady = this->steady;
    if (steady.solver.converged)
      others[kind] = steady.state;
    kind             = next;
    const auto found = others.find(next);
    if (found == others.end())
      return false;
    steady.state            = found->second;
    steady.solver.converged = true; // as a start
    return true;
  }

  template <int dim>
  WantedMesh KeptStates<dim>::fitted(PairSpec &scene) const
  {
    WantedMesh wanted = wanted_mesh(scene);
    for (const double share : {0.4, 0.6, 0.8, 1.})
      if (wanted.n_nodes > enough_nodes)
        {
          scene.mesh.finest_share = share;
          wanted                  = wanted_mesh(scene, wanted.patch);
        }
    return wanted;
  }

  template <int dim>
  bool KeptStates<dim>::find(const std::string &bodies,
                             const WantedMesh  &wanted)
  {
    auto nearest = kept.end();
    for (auto it = kept.begin(); it != kept.end(); ++it)
      if (it->bodies == bodies && it->suits(wanted, smallest) &&
          (nearest == kept.end() ||
           it->misfit(wanted) < nearest->misfit(wanted)))
        nearest = it;
    if (nearest == kept.end())
      return false;
    kept.splice(kept.begin(), kept, nearest);
    return true;
  }

  template <int dim>
  void KeptStates<dim>::make(const PairSpec             &scene,
                             const std::string          &bodies,
                             const WantedMesh           &wanted,
                             const std::vector<ZoneBox> &other_patches,
                             const std::string          &why)
  {
    if (wanted.n_nodes > most_nodes)
      throw ConvergenceError(
        "The profiles touch at places so different that elements small enough "
        "for the smallest patch would give " +
        significant(wanted.n_nodes, 3) + " contact nodes.");
    if (kept.size() >= most_kept)
      kept.pop_back();
    ++n_made;
    why_new = why;
    kept.push_front({KeptBodies<dim>::made_for(
                       scene, wanted, other_patches, split_bodies, context.run),
                     bodies,
                     0});
  }

  template <int dim>
  void KeptStates<dim>::solve_kept(const PairSpec    &scene,
                                   const WantedMesh  &wanted,
                                   const unsigned int kind)
  {
    const bool        is_new = !kept.front().take(kind);
    SteadyState<dim> &steady = kept.front().steady;
    const auto        start  = [&]() {
      steady.state = initial_state(steady.problem, wanted.patch);
    };
    if (is_new || !steady.solver.converged)
      start();
    solve_from_here(scene, kept.front());
    if (!steady.solver.converged)
      {
        start();
        solve_on_kept_bodies(scene, steady);
      }
  }

  template <int dim>
  void KeptStates<dim>::solve_from_here(const PairSpec &scene,
                                        Kept           &bodies) const
  {
    const ContactState before = bodies.steady.state;
    if (bodies.solve_from_here(scene, holds_edges) || !tries_last ||
        holds_edges)
      return;
    // edges that jump with the load, as where friction carries a part
    bodies.steady.state = before;
    bodies.solve_from_here(scene, true);
  }

  template <int dim>
  bool KeptStates<dim>::solve_on_last(const PairSpec    &scene,
                                      const std::string &bodies,
                                      const unsigned int kind)
  {
    const auto last = last_of(kind, bodies);
    if (last == kept.end() || !last->take(kind))
      return false;
    kept.splice(kept.begin(), kept, last);
    solve_from_here(scene, *last);
    return last->serves(scene, smallest);
  }

  template <int dim>
  SteadyState<dim> &KeptStates<dim>::solve(const PairSpec    &scene,
                                           const std::string &bodies,
                                           const unsigned int kind)
  {
    why_new.clear();
    ++n_solved;
    if (tries_last && solve_on_last(scene, bodies, kind))
      {
        kept.front().used[kind] = n_solved;
        return kept.front().steady;
      }
    PairSpec         fitting = scene;
    const WantedMesh wanted  = fitted(fitting);
    if (!find(bodies, wanted))
      make(fitting,
           bodies,
           wanted,
           {},
           kept.empty()
             ? "the first state"
             : "no bodies were kept for " + bodies + " and a patch of " +
                 significant(wanted.patch.half_width_x, 3) + " m half-width, " +
                 significant(wanted.patch.half_width_y, 3) + " m across");
    else
      {
        std::string why = "the patch lies outside the zone of contact nodes";
        if (kept.front().reaches(wanted))
          {
            solve_kept(scene, wanted, kind);
            const SteadyState<dim> &steady = kept.front().steady;
            why = steady.solver.converged && zone_too_small(steady)
                    ? "the patch reaches the border of the candidate zone"
                    : "";
          }
        if (!why.empty())
          {
            // half-spaces cost less than nodes where others touched
            const std::vector<ZoneBox> patches =
              scene.mesh.compliance == Compliance::half_spaces
                ? std::vector<ZoneBox>()
                : kept.front().patches;
            kept.pop_front();
            make(fitting, bodies, wanted, patches, why);
          }
      }
    kept.front().kind       = kind;
    kept.front().used[kind] = n_solved;
    return kept.front().steady;
  }

  template class KeptStates<2>;
  template class KeptStates<3>;
} // namespace RollingContact
