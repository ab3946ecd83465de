#ifndef rolling_contact_base_captured_stderr_h
#define rolling_contact_base_captured_stderr_h

#include <iostream>
#include <sstream>
#include <string>

namespace RollingContact
{
  /**
   * While an object lives, what is written to std::cerr is kept instead of
   * printed: deal.II 9.4.1 prints muParser's errors there and throws them too,
   * and prints the cause of some that it throws.
   */
  class CapturedStderr
  {
  public:
    CapturedStderr() = default;

    CapturedStderr(const CapturedStderr &) = delete;

    ~CapturedStderr()
    {
      std::cerr.rdbuf(buffer);
    }

    /**
     * What deal.II's last exception that was printed says, in one line and
     * without its frame; empty if there was none.
     */
    std::string
    cause() const;

  private:
    std::ostringstream    printed;
    std::streambuf *const buffer = std::cerr.rdbuf(printed.rdbuf());
  };
} // namespace RollingContact

#endif
