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

  /**
   * Bodies that are kept with the state solved on them last, and what they are
   * good for.
   */
  template <int dim>
  struct KeptBodies
  {
    std::array<double, 2> element_size; ///< wanted, m
    std::vector<ZoneBox>  patches;      ///< where profiles touch
    SteadyState<dim>      steady;
    double                made = 0.; ///< elements across the patch at first

    /** Bodies made for a state, which is solved and may not have converged,
     * with nodes where @p other_patches were, too. */
    static KeptBodies made_for(const PairSpec             &scene,
                               const WantedMesh           &wanted,
                               const std::vector<ZoneBox> &other_patches,
                               const std::shared_ptr<SplitBodies> &split_bodies,
                               RunContext                         &context);

    /** By how much wanted elements are larger or smaller, in logarithms. */
    double misfit(const WantedMesh &wanted) const;

    /** Whether elements are from @p smallest to 1 / @p smallest times as large
     * as wanted. */
    bool suits(const WantedMesh &wanted, const double smallest) const;

    /** Whether there are contact nodes wherever the profiles touch. */
    bool reaches(const WantedMesh &wanted) const;

    /** Elements across the patch of the state as it is. */
    double elements_across() const;

    /** Whether the state is found, enclosed, and with about as many elements
     * across as are asked for: from @p smallest to 1 / @p smallest times. */
    bool serves(const PairSpec &scene, const double smallest) const;

    /** Solve from the state as it is, with its edges as they are if @p holds;
     * returns whether that converged. */
    bool solve_from_here(const PairSpec &scene, const bool holds);
  };
} // namespace RollingContact

#endif
