#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/vibration/mode_controls.h>

namespace RollingContact
{
  namespace
  {
    void examine_count(const std::size_t  n_modes,
                       const std::size_t  n_unknowns,
                       const double       cut_off,
                       const std::string &section,
                       Log               &log)
    {
      const std::size_t few = 1000, unknowns_of_a_mode = 6;
      const std::string counted = section + ": " + std::to_string(n_modes) +
                                  " modes lie below " +
                                  significant(cut_off, 4) + " Hz";
      if (n_modes > few && unknowns_of_a_mode * n_modes > n_unknowns)
        throw InputError(
          counted + ", by inertia, too many for a mesh of " +
          std::to_string(n_unknowns) +
          " unknowns. Lower the highest frequency (Modes/Maximum frequency or "
          "Receptance/Highest frequency, in Hz, or Modes/Cut-off ratio), or "
          "check what makes the body so large, soft or heavy: " +
          section + "/Radius, Mesh unit, Young modulus, Density.");
      if (n_modes > few)
        log.message(counted +
                    ", by inertia: the time to find them grows with the "
                    "square of their number.");
    }
  } // namespace

  ModeControls mode_controls(const ModesParameters &wanted,
                             const double           cut_off,
                             const std::size_t      n_unknowns,
                             const std::string     &section,
                             Log                   &log)
  {
    ModeControls controls;
    controls.cut_off   = cut_off;
    controls.tolerance = wanted.tolerance;
    controls.count     = wanted.count;
    controls.interrupt = []() { throw_if_interrupted(); };
    controls.counted   = [=, &log](const std::size_t n_modes) {
      examine_count(n_modes, n_unknowns, cut_off, section, log);
    };
    return controls;
  }
} // namespace RollingContact
