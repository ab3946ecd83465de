#ifndef rolling_contact_tables_kept_bodies_h
#define rolling_contact_tables_kept_bodies_h

#include <rolling_contact/scene/pair_spec.h>
#include <rolling_contact/state/steady_state.h>

namespace RollingContact
{
  /**
   * What a state demands whose bodies are kept for others: an exact compliance,
   * so that nothing of the bodies is asked for when they are solved.
   */
  StateDemands demands_of_kept_bodies();

  /**
   * Solve a scene by Contact/Solver = economical where it leaves the choice.
   */
  void take_economical_solver(PairSpec &scene);

  /**
   * Solve the state of a @p scene on the bodies of another one, from where that
   * is. The scenes may differ by load or approach, creepages, friction and
   * speed, see RollingPair::set_loads(). The time is that of this solve.
   */
  template <int dim>
  void solve_on_kept_bodies(const PairSpec &scene, SteadyState<dim> &steady);

  /**
   * Smallest patch over the one that a mesh was made for that may be solved on
   * it; the error goes with the elements across the patch.
   */
  inline constexpr double smallest_patch = 0.9;

  /**
   * The half-width of the estimated patch of a scene, by which meshes are made;
   * 0 without contact. Units: m.
   */
  double patch_size(const PairSpec &scene);
} // namespace RollingContact

#endif
