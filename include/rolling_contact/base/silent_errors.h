#ifndef rolling_contact_base_silent_errors_h
#define rolling_contact_base_silent_errors_h

#include <iostream>

namespace RollingContact
{
  /**
   * Nothing reaches std::cerr while it lives: deal.II prints muParser's errors
   * there and throws them too.
   */
  class SilentErrors
  {
  public:
    SilentErrors() = default;

    SilentErrors(const SilentErrors &) = delete;

    ~SilentErrors()
    {
      std::cerr.rdbuf(buffer);
    }

  private:
    std::streambuf *const buffer = std::cerr.rdbuf(nullptr);
  };
} // namespace RollingContact

#endif
