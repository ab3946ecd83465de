#include <rolling_contact/scene/output_parameters.h>

namespace RollingContact
{
  using namespace dealii;

  OutputParameters::OutputParameters()
    : ParameterAcceptor("/Output")
  {
    add_parameter(
      "Body fields",
      body_fields,
      "Write bodies.pvd: displacement, stress and von Mises stress.");
    add_parameter("Interface fields",
                  interface_fields,
                  "Write interface.pvd: pressure, traction, slip, gap, state.");
    add_parameter("Plot", plot, "Write a plot of the tractions (2D) as SVG.");
    add_parameter("Verbosity",
                  level,
                  "What is said on the screen: `quiet`, `normal` or `verbose`.",
                  prm,
                  Patterns::Selection("quiet|normal|verbose"));
  }



  Verbosity
  OutputParameters::verbosity() const
  {
    return level == "quiet"     ? Verbosity::quiet
           : level == "verbose" ? Verbosity::verbose
                                : Verbosity::normal;
  }
} // namespace RollingContact
