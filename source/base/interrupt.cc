#include <signal.h>
#include <unistd.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/interrupt.h>

#include <atomic>
#include <cerrno>

namespace RollingContact
{
  namespace
  {
    std::atomic<int> received_signal{0};
    static_assert(std::atomic<int>::is_always_lock_free,
                  "A signal handler may only use lock-free atomics.");

    extern "C" void
    handle_interrupt(const int signal)
    {
      static constexpr char message[] =
        "\nInterrupted: stopping after the current state "
        "(again to stop at once).\n";
      const int saved_errno = errno;
      received_signal       = signal;
      [[maybe_unused]] const auto n_written =
        write(STDERR_FILENO, message, sizeof(message) - 1);
      errno = saved_errno;
    }
  } // namespace



  void
  install_interrupt_handlers()
  {
    received_signal = 0;

    struct sigaction action = {};
    action.sa_handler       = &handle_interrupt;
    action.sa_flags         = SA_RESTART | SA_RESETHAND;
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
  }



  bool
  interrupted()
  {
    return received_signal != 0;
  }



  void
  throw_if_interrupted()
  {
    if (interrupted())
      throw Interrupted(received_signal == SIGINT
                          ? "Interrupted by Ctrl-C (SIGINT)."
                          : "Interrupted by SIGTERM.");
  }
} // namespace RollingContact
