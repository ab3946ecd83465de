#ifndef rolling_contact_base_relayed_exception_h
#define rolling_contact_base_relayed_exception_h

#include <exception>
#include <functional>
#include <string>

namespace RollingContact
{
  /**
   * An exception in a form that can be sent to another process and thrown
   * there.
   */
  struct RelayedException
  {
    enum class Kind : int
    {
      nothing,
      input_error,
      not_converged,
      interrupted,
      no_memory,
      logic_error,
      other
    };

    Kind        kind = Kind::nothing;
    std::string message;
    /** The exception itself in the process that caught it, else null. */
    std::exception_ptr exception;
  };

  /** Run the action and return what it throws; Kind::nothing if it returns. */
  RelayedException caught_from(const std::function<void()> &action);

  /** Throw the exception itself where it was caught, in other processes one of
   * the same kind with its message (std::runtime_error for Kind::other). Does
   * nothing for Kind::nothing. */
  void rethrow(const RelayedException &relayed);
} // namespace RollingContact

#endif
