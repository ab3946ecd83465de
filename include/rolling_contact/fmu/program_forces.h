#ifndef rolling_contact_fmu_program_forces_h
#define rolling_contact_fmu_program_forces_h

#include <rolling_contact/fmu/force_model.h>
#include <rolling_contact/fmu/program_process.h>

namespace RollingContact::Fmu
{
  /**
   * Forces of states that the program solves when it is asked, in a process of
   * its own that is begun when forces are first needed, and anew after it has
   * ended. It must be on the machine.
   */
  class ProgramForces : public ForceModel
  {
  public:
    /** @p values: of program_values(). @p scene: the path of its file. Throws
     * std::invalid_argument if the values are none. */
    ProgramForces(const std::string &values, const std::string &scene);

    ForceKind kind() const override
    {
      return ForceKind::program;
    }

    void begin(const std::string &program) override;

    Forces forces(const Inputs      &inputs,
                  const double       least_speed,
                  const std::string &memory,
                  const std::string &program) override;

  private:
    const std::string               scene;
    std::unique_ptr<ProgramProcess> process;
    std::string                     asked; ///< program of the process
  };

  /** What resources have of a wheelset whose states are solved: dimensions,
   * inputs at first, and the program that made them. */
  std::string program_values(const Wheelset    &wheelset,
                             const std::string &program);
} // namespace RollingContact::Fmu

#endif
