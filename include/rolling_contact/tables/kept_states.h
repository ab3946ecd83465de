#ifndef rolling_contact_tables_kept_states_h
#define rolling_contact_tables_kept_states_h

#include <rolling_contact/tables/kept_bodies.h>
#include <rolling_contact/tables/quiet_context.h>

#include <limits>
#include <list>
#include <map>
#include <string>

namespace RollingContact
{
  /**
   * Steady states of scenes that are solved one after the other, on bodies that
   * are kept as long as they serve: made for the same bodies, with elements
   * that are not much smaller or larger than those that the patch as estimated
   * asks for, in a zone that holds the patch. Each state starts from the last
   * one of its kind on its bodies, so that those of two wheels may share them.
   */
  template <int dim>
  class KeptStates
  {
  public:
    /**
     * Messages from the making of bodies go to @p log, which must outlive this;
     * without a log there are none. A kept mesh serves if its elements are from
     * @p smallest to 1 / @p smallest times as large as those of a mesh made for
     * the state.
     */
    explicit KeptStates(std::ostream   *log       = nullptr,
                        const Verbosity verbosity = Verbosity::quiet,
                        const double    smallest  = smallest_patch)
      : context(log, verbosity)
      , smallest(smallest)
    {}

    /**
     * Solve a scene whose bodies touch. @p bodies tells those apart that differ
     * by more than where profiles touch and what presses and drags them; @p
     * kind tells apart what states start from. The state is there until the
     * next one is asked for; it may not have converged. Throws InputError if
     * the bodies do not suit, ConvergenceError if no mesh encloses the patch.
     */
    SteadyState<dim> &solve(const PairSpec    &scene,
                            const std::string &bodies,
                            const unsigned int kind = 0);

    /** States are tried on the bodies of the last one of their kind first,
     * which they are judged by in place of the patch as estimated, and with the
     * edges of that where they have none of their own. */
    bool tries_last = false;

    /** Most contact nodes of bodies that are made: one of the places where
     * profiles touch may ask for elements that are far too small for the
     * others. solve() throws ConvergenceError beyond. */
    double most_nodes = std::numeric_limits<double>::infinity();

    /** Whether the bodies of the last state of a kind have nodes wherever the
     * profiles of a scene touch as estimated; they are forgotten if not. */
    bool reaches_all(const PairSpec &scene, const unsigned int kind);

    /** Where elements for the smallest of several patches would give more
     * contact nodes, it gets fewer of them, as far as those of the whole. */
    double enough_nodes = std::numeric_limits<double>::infinity();

    /** Edges of stick zones stay those of the state that is begun with. */
    bool holds_edges = false;

    /** How many sets of bodies are kept: the ones that were used last. */
    std::size_t most_kept = 4;

    /** Why the last state made bodies; empty if it did not. */
    std::string why_new;

    /** How many sets of bodies were made. */
    unsigned int n_made = 0;

    QuietContext context;

  private:
    /** A state, and what its bodies are good for. */
    struct Kept : KeptBodies<dim>
    {
      std::string  bodies;
      unsigned int kind; ///< of the state

      /** When a kind had its last state here. */
      std::map<unsigned int, unsigned int> used = {};

      /** The last states of other kinds that converged. */
      std::map<unsigned int, ContactState> others = {};

      /** Go on with states of this kind, which there are. */
      bool take(const unsigned int kind);
    };

    /** Solve from the state as it is, with its edges held where that helps. */
    void solve_from_here(const PairSpec &scene, Kept &bodies) const;

    /** The bodies of the last state of a kind; the end if there are none. */
    typename std::list<Kept>::iterator last_of(const unsigned int kind,
                                               const std::string &bodies = "");

    /** Whether the state is there, on the bodies of the last of its kind. */
    bool solve_on_last(const PairSpec    &scene,
                       const std::string &bodies,
                       const unsigned int kind);

    /** The mesh of a state, and the scene with what it takes to have no more
     * than enough_nodes. */
    WantedMesh fitted(PairSpec &scene) const;

    /** Whether one serves; it is the first then. */
    bool find(const std::string &bodies, const WantedMesh &wanted);

    /** Solve on the first of those that are kept. */
    void solve_kept(const PairSpec    &scene,
                    const WantedMesh  &wanted,
                    const unsigned int kind);

    void make(const PairSpec             &scene,
              const std::string          &bodies,
              const WantedMesh           &wanted,
              const std::vector<ZoneBox> &other_patches,
              const std::string          &why);

    const double                       smallest;
    const std::shared_ptr<SplitBodies> split_bodies =
      std::make_shared<SplitBodies>();
    std::list<Kept> kept; ///< the one that was used last first
    unsigned int    n_solved = 0;
  };
} // namespace RollingContact

#endif
