#include <deal.II/base/parameter_handler.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/input/prm_declarations.h>
#include <rolling_contact/scene/stability_parameters.h>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    const std::vector<NamedValue<FrictionResponse>> named_responses{
      {"constant", FrictionResponse::constant},
      {"node", FrictionResponse::node},
      {"patch mean", FrictionResponse::patch_mean}};
  } // namespace



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
    declare_choice(
      prm,
      "Friction response",
      friction,
      named_responses,
      "How a friction coefficient that falls with the sliding speed follows a "
      "disturbance: `patch mean`, the mean speed of the patch with a delay; "
      "`node`, the speed of each node at once, which is ill-posed where "
      "friction falls; `constant`, not at all.");
    prm.add_parameter("Friction memory",
                      memory,
                      "Delay of `patch mean`. Units: s.",
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
    if (friction == FrictionResponse::patch_mean && !(memory > 0.))
      throw InputError("Stability/Friction memory = " + text_of(memory) +
                       ": patch mean needs a delay above 0 s; 60e-6 is usual.");
  }
} // namespace RollingContact
