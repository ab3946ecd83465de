#ifndef rolling_contact_parallel_relayed_exception_h
#define rolling_contact_parallel_relayed_exception_h

#include <exception>
#include <functional>
#include <string>

namespace RollingContact
{
  /**
   * What an action threw, in a form that can be sent to another process and
   * thrown there.
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
    /** The exception itself; null in another process. */
    std::exception_ptr exception;
  };

  RelayedException
  caught_from(const std::function<void()> &action);

  /** Throws it as it was where it is known, else with type and message of its
   * kind (std::runtime_error for Kind::other). */
  void
  rethrow(const RelayedException &thrown);
} // namespace RollingContact

#endif
