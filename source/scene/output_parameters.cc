#include <deal.II/base/parameter_handler.h>

#include <rolling_contact/input/prm_declarations.h>
#include <rolling_contact/scene/output_parameters.h>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    const std::vector<NamedValue<Verbosity>> named_verbosities{
      {"quiet", Verbosity::quiet},
      {"normal", Verbosity::normal},
      {"verbose", Verbosity::verbose}};
  } // namespace



  void
  OutputParameters::declare(ParameterHandler &prm)
  {
    prm.enter_subsection("Output");
    prm.add_parameter(
      "Body fields",
      body_fields,
      "Write bodies.pvd: displacement, stress and von Mises stress.");
    prm.add_parameter(
      "Interface fields",
      interface_fields,
      "Write interface.pvd: pressure, traction, slip, gap, state.");
    prm.add_parameter(
      "Plot",
      plot,
      "Write plots as SVG, each with its data and gnuplot script: tractions in 2D, profiles, curves, histories, maps, modes.");
    declare_choice(
      prm,
      "Verbosity",
      verbosity,
      named_verbosities,
      "What is said on the screen: `quiet`, `normal` or `verbose`.");
    prm.leave_subsection();
  }
} // namespace RollingContact
