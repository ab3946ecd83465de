#ifndef rolling_contact_base_exceptions_h
#define rolling_contact_base_exceptions_h

#include <stdexcept>
#include <string>

namespace RollingContact
{
  /**
   * Exit codes of the program.
   */
  enum class ExitCode : int
  {
    converged      = 0,
    input_error    = 1,
    not_converged  = 2,
    internal_error = 3
  };

  /**
   * Something the user can mend: a parameter, a file, a command line. The
   * message names the entry or file, its value, what is allowed and what to do.
   */
  class InputError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /**
   * A scene that does not fit into the memory that is free.
   */
  class MemoryError : public InputError
  {
  public:
    using InputError::InputError;
  };

  /**
   * A solve that did not reach its tolerance, or an invariant that broke. What
   * was computed so far is kept and marked.
   */
  class ConvergenceError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /**
   * Ctrl-C or SIGTERM between two states: the rows done so far are kept.
   */
  class Interrupted : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };
} // namespace RollingContact

#endif
