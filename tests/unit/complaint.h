#ifndef rolling_contact_tests_complaint_h
#define rolling_contact_tests_complaint_h

#include <rolling_contact/base/exceptions.h>

#include <functional>
#include <string>

namespace RollingContact
{
  /** What an InputError says; empty if there was none. */
  inline std::string complaint(const std::function<void()> &action)
  {
    try
      {
        action();
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return {};
  }

  inline bool contains(const std::string &text, const std::string &part)
  {
    return text.find(part) != std::string::npos;
  }
} // namespace RollingContact

#endif
