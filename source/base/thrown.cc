#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/thrown.h>

#include <new>
#include <stdexcept>

namespace RollingContact
{
  namespace
  {
    Thrown
    caught(const Thrown::Kind kind, const std::string &message)
    {
      return {kind, message, std::current_exception()};
    }
  } // namespace



  Thrown
  thrown_by(const std::function<void()> &action)
  {
    try
      {
        action();
        return {};
      }
    catch (const InputError &error)
      {
        return caught(Thrown::Kind::input_error, error.what());
      }
    catch (const ConvergenceError &error)
      {
        return caught(Thrown::Kind::not_converged, error.what());
      }
    catch (const Interrupted &error)
      {
        return caught(Thrown::Kind::interrupted, error.what());
      }
    catch (const std::bad_alloc &error)
      {
        return caught(Thrown::Kind::no_memory, error.what());
      }
    catch (const std::logic_error &error)
      {
        return caught(Thrown::Kind::logic_error, error.what());
      }
    catch (const std::exception &error)
      {
        return caught(Thrown::Kind::other, error.what());
      }
    catch (...)
      {
        return caught(Thrown::Kind::other, "unknown exception");
      }
  }



  void
  throw_again(const Thrown &thrown)
  {
    if (thrown.exception)
      std::rethrow_exception(thrown.exception);
    switch (thrown.kind)
      {
        case Thrown::Kind::nothing:
          return;
        case Thrown::Kind::input_error:
          throw InputError(thrown.message);
        case Thrown::Kind::not_converged:
          throw ConvergenceError(thrown.message);
        case Thrown::Kind::interrupted:
          throw Interrupted(thrown.message);
        case Thrown::Kind::no_memory:
          throw std::bad_alloc();
        case Thrown::Kind::logic_error:
          throw std::logic_error(thrown.message);
        case Thrown::Kind::other:
          throw std::runtime_error(thrown.message);
      }
  }
} // namespace RollingContact
