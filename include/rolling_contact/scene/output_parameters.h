#ifndef rolling_contact_scene_output_parameters_h
#define rolling_contact_scene_output_parameters_h

#include <rolling_contact/run/log.h>

namespace dealii
{
  class ParameterHandler;
}

namespace RollingContact
{
  /**
   * Section `Output`.
   */
  struct OutputParameters
  {
    void
    declare(dealii::ParameterHandler &prm);

    bool      body_fields      = true;
    bool      interface_fields = true;
    bool      plot             = true;
    Verbosity verbosity        = Verbosity::normal;
  };
} // namespace RollingContact

#endif
