#ifndef rolling_contact_evolution_evolution_state_h
#define rolling_contact_evolution_evolution_state_h

#include <rolling_contact/evolution/running_surfaces.h>

#include <filesystem>
#include <string>
#include <vector>

namespace RollingContact
{
  inline const std::string evolution_state_file = "evolution_state.bin";

  /**
   * How far an evolution has come, and by which step. Units: 1, m.
   */
  struct EvolutionPoint
  {
    unsigned int step  = 0;
    double       share = 0.; ///< of the way
    double       error = 0.; ///< of the step, see WearStep::Found
    double       depth = 0.; ///< of the step
  };

  /**
   * What an evolution that was ended goes on from: written after each step.
   */
  struct EvolutionState
  {
    std::string    duty; ///< its file as it was
    EvolutionPoint now;
    double         next_share = 0.; ///< of the step to come

    std::string results, rows; ///< results.csv and duty.csv

    /** Where the surfaces were shown, and their curves there. */
    std::vector<double>                             shares;
    std::vector<std::vector<RunningSurfaces::Side>> curves;
  };

  std::string text_of(const EvolutionState &state);

  /** Throws InputError, naming the file, if it is none. */
  EvolutionState read_evolution_state(const std::filesystem::path &file);
} // namespace RollingContact

#endif
