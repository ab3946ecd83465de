#ifndef rolling_contact_tables_transient_session_h
#define rolling_contact_tables_transient_session_h

#include <rolling_contact/contact/resultants.h>
#include <rolling_contact/run/log.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/time/checkpoint.h>

#include <iosfwd>
#include <memory>
#include <optional>

namespace RollingContact
{
  /**
   * The inputs of a time step from outside: values at the end of the step.
   * BetweenValues says what they are on the way there. A value that is left
   * empty stays as it was given last; if it was never given, it follows the
   * history of the scene. A force takes the place of its creepage, and a
   * creepage that of its force. Units: SI.
   */
  struct StepInputs
  {
    std::optional<double> normal_load;            ///< N
    std::optional<double> approach;               ///< m
    std::optional<double> creepage_x, creepage_y; ///< 1
    std::optional<double> spin;                   ///< 1/m
    std::optional<double> speed;                  ///< m/s
    std::optional<double> longitudinal_force;     ///< N, on the wheel
    std::optional<double> lateral_force;          ///< N, on the wheel
    std::optional<double> spin_moment;            ///< N m, on the wheel
  };

  /**
   * How inputs of a step get from their last value to that of its end.
   */
  enum class BetweenValues
  {
    linear, ///< a line over the step
    held    ///< a jump as the step begins; the approach is linear all the same
  };

  /**
   * The end of a time step. Energies, impacts and distance are those since the
   * start. Units: SI, see Resultants, TransientProgress.
   */
  struct TransientState
  {
    double time = 0.;
    double force_time =
      0.; ///< at which the forces act, before the end by theta
    Resultants            forces;
    double                approach = 0.;
    Creepages             creepages; ///< found, where forces are given
    double                speed = 0.;
    TransientProgress     progress;
    double                kinetic_energy = 0., strain_energy = 0.;
    unsigned int          n_sticking = 0;
    unsigned int          n_parts = 0; ///< of the step; 1 unless it was halved
    SolverReport          solver;
    std::optional<double> wheel_velocity; ///< of a free wheel along z
    double                seconds = 0.;   ///< wall time of the step
  };

  /**
   * A scene in time whose steps are taken one by one under control from
   * outside, for programs that call the library, such as a vehicle model:
   * creepages, forces, load or approach and speed of each step come from
   * outside or from the scene's own histories, and a step may be repeated from
   * a state that was saved. It starts from Time/Initial state; End time and
   * Rolled distance do not end it. Writes no files; one may be
   * used by one thread at a time. For one rank.
   */
  class TransientSession
  {
  public:
    /**
     * Makes mesh and matrices. Throws InputError if the scene contradicts
     * itself, has another Analysis than transient or nothing that touches. For
     * the @p log see Session.
     */
    explicit TransientSession(const Situation &scene,
                              std::ostream    *log       = nullptr,
                              const Verbosity  verbosity = Verbosity::quiet);
    ~TransientSession();

    TransientSession(TransientSession &&) noexcept;
    TransientSession &operator=(TransientSession &&) noexcept;

    /**
     * Take a step of this length, by default of the scene's; another length
     * than that of the step before factorises anew. Throws InputError if the
     * inputs do not suit the scene, ConvergenceError if the step fails in
     * however many parts, Interrupted; it has not happened then. Units: s.
     */
    const TransientState &
    step(const StepInputs           &inputs,
         const std::optional<double> length  = {},
         const BetweenValues         between = BetweenValues::linear);

    /** The end of the last step. */
    const TransientState &current() const;

    /** Nodes, operators and loads now. */
    const ContactProblem &problem() const;

    /** Pressure, traction and approach now. */
    const ContactState &state() const;

    /** All that the next steps depend on, of one session. */
    struct Saved;

    /** A copy of the state now, to be kept as long as it is wanted. */
    std::shared_ptr<const Saved> save() const;

    /**
     * Go to a state that this session saved: the steps from there give the same
     * numbers, bit by bit. Throws InputError if another session saved it.
     */
    void restore(const Saved &saved);

    /** What a session does in two and in three dimensions. */
    class Implementation;

  private:
    std::unique_ptr<Implementation> implementation;
  };
} // namespace RollingContact

#endif
