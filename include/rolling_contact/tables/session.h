#ifndef rolling_contact_tables_session_h
#define rolling_contact_tables_session_h

#include <rolling_contact/contact/patch_area.h>
#include <rolling_contact/pair/track_forces.h>
#include <rolling_contact/results/error_bounds.h>
#include <rolling_contact/run/log.h>
#include <rolling_contact/scene/situation.h>

#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace RollingContact
{
  /**
   * A state that a session solved. Units: SI; see Resultants and ErrorBounds.
   */
  struct SessionState
  {
    bool        touches   = false; ///< else all is zero
    bool        converged = false;
    std::string reason; ///< why it did not converge
    Resultants  forces;
    PatchAreas  areas;
    double      approach = 0.; ///< m
    Creepages   creepages;
    /** Forces in the axes of the track, of bodies with profiles. */
    std::optional<TrackForces> track_forces;
    ErrorBounds                bounds;
    SolverReport               solver;
    double      elements_across = 0.; ///< the patch that was found, along x
    std::string new_bodies;   ///< why bodies were made; empty if they were kept
    double      seconds = 0.; ///< wall time, with bodies
  };

  template <int dim>
  struct SteadyState;

  /** What a session says of a state whose errors were estimated. */
  template <int dim>
  SessionState session_state(const PairSpec         &scene,
                             const SteadyState<dim> &steady);

  /**
   * A scene whose steady states are solved one after the other, for programs
   * that call the library. Entries are changed by name. Bodies, condensed to
   * the contact nodes, are kept between calls, so that another load, creepage
   * or friction takes milliseconds. Each state starts from the last one on its
   * bodies.
   *
   * New bodies are made, and up to four sets of them are kept, if an entry
   * outside of section Contact changes, if the flow turns round, if friction
   * replaces none, if the estimated patch would have less than 0.9 or more than
   * 1/0.9 times the elements that the mesh was made with, or if a patch lies
   * outside of its zone. The place where profiles touch needs new bodies only
   * if the bodies have the sections of the profiles.
   *
   * A session writes no files. Several sessions of a process are independent;
   * only one thread at a time may use each. BLAS should have one thread, see
   * use_one_solver_thread(). For one rank.
   */
  class Session
  {
  public:
    /**
     * Reads the mesh files and profiles of the scene anew. Throws InputError if
     * it contradicts itself or has Mesh/Target error or Adaptive levels, which
     * are for single states. What the program would say while it makes bodies
     * goes to @p log, which must outlive the session; nowhere without.
     */
    explicit Session(const Situation &scene,
                     std::ostream    *log       = nullptr,
                     const Verbosity  verbosity = Verbosity::quiet);
    ~Session();

    Session(Session &&) noexcept;
    Session &operator=(Session &&) noexcept;

    /**
     * Give an entry, Section/Entry, another value for the states from now on.
     * Throws InputError, the entry unchanged, if there is none or it does not
     * take the value.
     */
    void set(const std::string &entry, const std::string &value);

    void set(const std::string &entry, const double value);

    /**
     * Solve the state of the entries as they are. A state that does not
     * converge says so, the next one starts anew. Throws InputError if the
     * entries contradict each other or the bodies do not suit, ConvergenceError
     * if no mesh encloses the patch; the session may be used further.
     */
    const SessionState &solve();

    /**
     * Nodes, operators and loads of the state that was solved last. Throws
     * std::logic_error if none that touches was.
     */
    const ContactProblem &problem() const;

    /**
     * Pressure, traction and approach of that state.
     */
    const ContactState &state() const;

    /** A column of results.csv with its value: none, a number, a text. */
    using NamedValue =
      std::pair<std::string, std::variant<std::monostate, double, std::string>>;

    /**
     * The row that results.csv would have of that state; what is true or false
     * is 1 or 0. Throws std::logic_error if there is none, or an entry was set
     * since.
     */
    std::vector<NamedValue> row() const;

    /**
     * How many sets of bodies were made so far.
     */
    unsigned int n_bodies_made() const;

    /** What a session does in two and in three dimensions. */
    class Implementation;

  private:
    std::unique_ptr<Implementation> implementation;
  };
} // namespace RollingContact

#endif
