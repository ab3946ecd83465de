#ifndef rolling_contact_fmu_variables_h
#define rolling_contact_fmu_variables_h

#include <rolling_contact/fmu/force_model.h>

#include <optional>
#include <string>
#include <vector>

namespace RollingContact::Fmu
{
  /** The file name of the binary and the model in FMUs. */
  constexpr char model_name[] = "rolling_contact_wheelset";

  enum class VariableType
  {
    real,
    boolean,
    text
  };

  enum class Causality
  {
    independent,
    input,
    output,
    parameter, ///< fixed
    constant   ///< local
  };

  /** What a variable is to the model: one of a kind by its number. */
  enum class Source
  {
    time,
    input,       ///< Input
    least_speed, ///< parameter
    program,     ///< parameter, a path
    radius,
    tape_circle,
    scene,
    roll,
    quantity, ///< Quantity of a wheel
    force_ratio,
    inside
  };

  /** A variable of the interface. Its reference is unique among all types. */
  struct Variable
  {
    unsigned int reference;
    std::string  name;
    VariableType type;
    Causality    causality;
    std::string  unit; ///< empty: 1, or no number
    std::string  description;
    Source       source;
    std::size_t  number = 0; ///< of the input or the quantity
    unsigned int wheel  = 0; ///< 0 the right-hand one

    bool is_set_by_importer() const
    {
      return causality == Causality::input || causality == Causality::parameter;
    }
  };

  /** All variables of FMUs of a kind, by reference. */
  const std::vector<Variable> &variables(const ForceKind kind);

  /** The one of a reference; null if there is none. */
  const Variable *find_variable(const unsigned int reference,
                                const ForceKind    kind);

  /** A unit by the exponents of its base units kg, m, s, rad. */
  struct Unit
  {
    const char *name;
    int         kg, m, s, rad;
  };

  const std::vector<Unit> &units();
} // namespace RollingContact::Fmu

#endif
