#ifndef rolling_contact_fmu_face_h
#define rolling_contact_fmu_face_h

#include <rolling_contact/fmu/instance.h>

#include <exception>
#include <string>

namespace RollingContact::Fmu
{
  /**
   * What a function of an interface does with its instance: @p what of it, or
   * the error, silently, if there is no such instance. No exception passes.
   */
  template <class What>
  Status with(void *instance, const char *function, const What &what)
  {
    if (!Instance::is_alive(instance))
      return Status::error;
    Instance &own = *static_cast<Instance *>(instance);
    try
      {
        return what(own);
      }
    catch (const std::exception &problem)
      {
        return own.refuse(function, problem.what());
      }
  }

  /** A function that is of no use here. */
  inline Status refused(void *instance, const char *function, const char *why)
  {
    return with(instance, function, [&](Instance &own) {
      return own.refuse(function, why);
    });
  }

  /** The text of the other side; empty if it gives none. */
  inline std::string text_of(const char *text)
  {
    return text ? text : "";
  }

  /**
   * The path of a folder: that of a URI file:///..., or the path that it is.
   */
  std::string folder_of(const std::string &location);
} // namespace RollingContact::Fmu

#endif
