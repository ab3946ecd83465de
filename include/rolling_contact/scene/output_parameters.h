#ifndef rolling_contact_scene_output_parameters_h
#define rolling_contact_scene_output_parameters_h

#include <rolling_contact/base/verbosity.h>

namespace RollingContact
{
  class Entries;

  /**
   * Section `Output`.
   */
  struct OutputParameters
  {
    void declare(Entries &entries);

    bool      body_fields      = true;
    bool      contact_problem  = false;
    bool      interface_fields = true;
    bool      plot             = true;
    Verbosity verbosity        = Verbosity::normal;
  };
} // namespace RollingContact

#endif
