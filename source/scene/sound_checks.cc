#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/scene/scene_parameters.h>

namespace RollingContact
{
  void
  SceneParameters::check_sound() const
  {
    if (analysis != "transient" || !sound.estimate)
      return;
    const std::string why = "Sound/Estimate = true: ";
    if (!has_reduced_bodies())
      throw InputError(why + "sound is estimated from the modes of the bodies; "
                             "set Time/Bodies = reduced.");
    if (dimension == 2)
      throw InputError(why + "in plane strain (Dimension = 2) a wheel has no "
                             "axial motion, which radiates most; set Dimension "
                             "= 3.");
    sound.check(time.steps(time.histories(contact, prm_folder).speed),
                modes.maximum_frequency);
  }
} // namespace RollingContact
