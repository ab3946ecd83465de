#ifndef rolling_contact_tables_kept_bodies_h
#define rolling_contact_tables_kept_bodies_h

#include <rolling_contact/scene/pair_spec.h>
#include <rolling_contact/state/steady_state.h>

namespace RollingContact
{
  /**
   * The demands of a state whose bodies are kept for other states: an exact
   * compliance. Contact solves then ask nothing more of the bodies.
   */
  StateDemands demands_of_kept_bodies();

  /**
   * Solve a scene by Contact/Solver = economical where it leaves the choice.
   */
  void take_economical_solver(PairSpec &scene);

  /**
   * Solve the state of a @p scene on the bodies of another one, from where that
   * is. The scenes may differ by load or approach, creepages, friction and
   * speed, see RollingPair::set_loads(), and by where profiles touch unless
   * bodies follow them. The time is that of this solve.
   */
  template <int dim>
  void solve_on_kept_bodies(const PairSpec &scene, SteadyState<dim> &steady);

  /**
   * Smallest element that a state may have over that of a mesh of its own, and
   * the other way round; the error goes with the elements across the patch.
   */
  inline constexpr double smallest_patch = 0.9;

  /**
   * What a state would have of its own: its patch as estimated, none without
   * contact, the sizes of its elements (m), and the nodes of its contact.
   */
  struct WantedMesh
  {
    PatchEstimate         patch;
    std::array<double, 2> element_size{};
    double                n_nodes = 0.;
  };

  WantedMesh wanted_mesh(const PairSpec &scene);

  /** With its patch as estimated. */
  WantedMesh wanted_mesh(const PairSpec &scene, const PatchEstimate &patch);
} // namespace RollingContact

#endif
