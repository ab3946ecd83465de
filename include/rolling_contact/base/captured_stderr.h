#ifndef rolling_contact_base_captured_stderr_h
#define rolling_contact_base_captured_stderr_h

#include <string>

namespace RollingContact
{
  /**
   * While an object lives, what its thread writes to std::cerr is kept instead
   * of printed: deal.II 9.4.1 prints muParser's errors there and throws them
   * too, and prints the cause of some that it throws. There is one object at a
   * time in the process, for which other threads wait that want theirs; what
   * they write meanwhile is printed.
   */
  class CapturedStderr
  {
  public:
    CapturedStderr();
    ~CapturedStderr();

    CapturedStderr(const CapturedStderr &) = delete;

    /**
     * What deal.II's last exception that was printed says, in one line and
     * without its frame; empty if there was none.
     */
    std::string cause() const;
  };
} // namespace RollingContact

#endif
