#ifndef rolling_contact_scene_output_parameters_h
#define rolling_contact_scene_output_parameters_h

#include <deal.II/base/parameter_acceptor.h>

#include <rolling_contact/run/log.h>

#include <string>

namespace RollingContact
{
  /**
   * Section `Output`.
   */
  struct OutputParameters : public dealii::ParameterAcceptor
  {
    OutputParameters();

    Verbosity
    verbosity() const;

    bool        body_fields      = true;
    bool        interface_fields = true;
    bool        plot             = true;
    std::string level            = "normal";
  };
} // namespace RollingContact

#endif
