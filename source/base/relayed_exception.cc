#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/relayed_exception.h>

#include <new>
#include <stdexcept>

namespace RollingContact
{
  namespace
  {
    RelayedException caught(const RelayedException::Kind kind,
                            const std::string           &message)
    {
      return {kind, message, std::current_exception()};
    }
  } // namespace

  RelayedException caught_from(const std::function<void()> &action)
  {
    try
      {
        action();
        return {};
      }
    catch (const InputError &error)
      {
        return caught(RelayedException::Kind::input_error, error.what());
      }
    catch (const ConvergenceError &error)
      {
        return caught(RelayedException::Kind::not_converged, error.what());
      }
    catch (const Interrupted &error)
      {
        return caught(RelayedException::Kind::interrupted, error.what());
      }
    catch (const std::bad_alloc &error)
      {
        return caught(RelayedException::Kind::no_memory, error.what());
      }
    catch (const std::logic_error &error)
      {
        return caught(RelayedException::Kind::logic_error, error.what());
      }
    catch (const std::exception &error)
      {
        return caught(RelayedException::Kind::other, error.what());
      }
    catch (...)
      {
        return caught(RelayedException::Kind::other, "unknown exception");
      }
  }

  void rethrow(const RelayedException &relayed)
  {
    if (relayed.exception)
      std::rethrow_exception(relayed.exception);
    switch (relayed.kind)
      {
        case RelayedException::Kind::nothing:
          return;
        case RelayedException::Kind::input_error:
          throw InputError(relayed.message);
        case RelayedException::Kind::not_converged:
          throw ConvergenceError(relayed.message);
        case RelayedException::Kind::interrupted:
          throw Interrupted(relayed.message);
        case RelayedException::Kind::no_memory:
          throw std::bad_alloc();
        case RelayedException::Kind::logic_error:
          throw std::logic_error(relayed.message);
        case RelayedException::Kind::other:
          throw std::runtime_error(relayed.message);
      }
  }
} // namespace RollingContact
