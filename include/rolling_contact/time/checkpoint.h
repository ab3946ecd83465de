#ifndef rolling_contact_time_checkpoint_h
#define rolling_contact_time_checkpoint_h

#include <rolling_contact/contact/contact_problem.h>
#include <rolling_contact/input/prm_entries.h>
#include <rolling_contact/pair/pair_motion.h>
#include <rolling_contact/run/history_table.h>
#include <rolling_contact/run/pvd.h>
#include <rolling_contact/run/run_folder.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/solvers/contact_solver.h>
#include <rolling_contact/time/patch_friction.h>
#include <rolling_contact/time/slip_memory.h>

#include <cstdint>
#include <string>
#include <vector>

namespace RollingContact
{
  inline const std::string checkpoint_name       = "checkpoint.bin";
  inline const std::string history_name          = "history.csv";
  inline const std::string modal_velocities_name = "modal_velocities.csv";

  /**
   * How far a transient run has come, and what it has summed up since the
   * start. Units: s, m, J.
   */
  struct TransientProgress
  {
    std::uint64_t step             = 0; ///< steps done
    double        time             = 0.;
    double        rolled_distance  = 0.;
    double        time_step        = 0.; ///< of the steps; 0 before the first
    double        supplied_energy  = 0.;
    double        friction_energy  = 0.; ///< dissipated
    double        damping_energy   = 0.; ///< dissipated
    double        numerical_energy = 0.; ///< dissipated by theta
    double        energy_error     = 0.; ///< of the balance
    double        surface_energy   = 0.; ///< supplied by surfaces that move
    std::uint64_t n_impacts        = 0;
  };

  /**
   * Under what the last step was solved, its last part if it was halved.
   * Units: s.
   */
  struct LastStep
  {
    bool         is_known = false; ///< not after a failed one
    double       length   = 0.;
    double       rate     = 0.; ///< see TimeScaling
    StepLoads    loads;
    SolverReport solver;

    /** For Boost.Serialization. A member not listed here does not compile. */
    template <typename Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      auto &[is_known, length, rate, loads, solver] = *this;
      archive &is_known &length &rate &loads &solver;
    }
  };

  /**
   * All that a transient run needs to continue with the same numbers, bit by
   * bit, after the step it was taken. Meshes and factors are made again.
   */
  struct Checkpoint
  {
    /** Fingerprints of the files the scene names, to be compared with
     * refuse_changed_entries(); RunFolder compares the scene itself. */
    PrmEntries tables;

    TransientProgress progress;

    PairMotion   motion;
    SlipMemory   slip;
    ContactState state;
    PatchMemory  patch_friction;
    LastStep     last_step;

    HistoryTable::Position history;
    HistoryTable::Position modal_velocities; ///< 0 without a sound
    std::vector<PvdBlock>  body_fields;      ///< of bodies.pvd so far
    std::vector<PvdBlock>  interface_fields; ///< of interface.pvd so far
  };

  /**
   * Replaces checkpoint.bin in one step that survives a loss of power. Flush
   * the history before. Throws InputError if the disk is full. Collective: the
   * root writes.
   */
  void write_checkpoint(const Checkpoint &checkpoint, RunFolder &folder);

  /**
   * Throws InputError naming the file if it is missing, truncated, damaged or
   * of another version. Collective: the root reads, all get it.
   */
  Checkpoint read_checkpoint(const RunFolder &folder);

  /**
   * Throws InputError, as read_checkpoint() does, for what it can know before
   * a mesh is made and a file of the folder is touched: other tables or mesh
   * files than the run in this folder began with, and an end before the step
   * it has reached. Only for the root.
   */
  void check_resumable(const Situation             &scene,
                       const std::filesystem::path &folder);

  /**
   * Fingerprints of the tables, records and mesh files that a transient run
   * reads.
   */
  PrmEntries files_of(const Situation &scene);
} // namespace RollingContact

#endif
