#include <deal.II/base/parameter_handler.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/input/prm_declarations.h>
#include <rolling_contact/scene/stability_parameters.h>

namespace RollingContact
{
  using namespace dealii;

  void
  StabilityParameters::declare(ParameterHandler &prm)
  {
    const Patterns::Double not_negative(0.);
    prm.enter_subsection("Stability");
    prm.add_parameter("Lowest frequency",
                      lowest_frequency,
                      "Vibrations from this frequency up to Modes/Maximum "
                      "frequency are looked at. Units: Hz.",
                      not_negative);
    prm.add_parameter(
      "Rotation",
      rotation,
      "Whether the wheel turns under the contact as it vibrates, which splits "
      "its pairs of modes; Contact/Speed over its radius.");
    prm.add_parameter("Added damping",
                      added_damping,
                      "Damping ratio that all modes of both bodies have in "
                      "addition, as by a damper. Units: 1.",
                      not_negative);
    prm.add_parameter("Count check",
                      count,
                      "Count the unstable vibrations by the argument principle "
                      "as well, independent of the eigenvalues.");
    prm.add_parameter(
      "Full model",
      correct,
      "Correct each unstable vibration by the equations of the whole bodies, "
      "and tell how far it is from them.");
    prm.add_parameter("Damping margin",
                      damping_margin,
                      "Damping ratio that a cured mode shall have beyond being "
                      "stable, for the damping that is needed. Units: 1.",
                      not_negative);
    prm.leave_subsection();
  }



  void
  StabilityParameters::check() const
  {
    if (!(lowest_frequency > 0.))
      throw InputError(
        "Stability/Lowest frequency = " + text_of(lowest_frequency) +
        ": it must be above 0 Hz; 60 is below every squeal.");
  }
} // namespace RollingContact
