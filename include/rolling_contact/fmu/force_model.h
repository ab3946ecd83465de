#ifndef rolling_contact_fmu_force_model_h
#define rolling_contact_fmu_force_model_h

#include <rolling_contact/fmu/wheelset_model.h>

#include <memory>
#include <stdexcept>
#include <string>

namespace RollingContact::Fmu
{
  /** What an FMU has its forces from. */
  enum class ForceKind
  {
    table,
    program ///< that solves states
  };

  /** There are no forces for inputs: a step with others may be possible. */
  class NoForces : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /**
   * Where the forces of an FMU come from.
   */
  class ForceModel
  {
  public:
    /** Outputs, and what to begin the next ones with. */
    struct Forces
    {
      Outputs     outputs;
      std::string memory;
    };

    /**
     * The model of a folder of resources. Throws std::invalid_argument, naming
     * the file, if there is none.
     */
    static std::unique_ptr<ForceModel> of_folder(const std::string &resources);

    virtual ~ForceModel() = default;

    virtual ForceKind kind() const = 0;

    /** Make ready what forces need, with the @p program that is asked for, if
     * one is. Throws std::runtime_error if that is not possible. */
    virtual void begin(const std::string &)
    {}

    /**
     * Forces under these inputs, at @p least_speed (m/s) where it is slower, to
     * the last bit the same for the same @p memory. Throws NoForces if there
     * are none, std::runtime_error if that was not found out.
     */
    virtual Forces forces(const Inputs      &inputs,
                          const double       least_speed,
                          const std::string &memory,
                          const std::string &program) = 0;

    /** The start values; of radius and tape circle. Units: m. */
    Wheelset wheelset;

    /** The program that is looked for if none is asked for. */
    std::string known_program;
  };
} // namespace RollingContact::Fmu

#endif
