#include <signal.h>
#include <unistd.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/parallel/interrupt.h>
#include <rolling_contact/parallel/ranks.h>

#include <atomic>
#include <cerrno>

namespace RollingContact
{
  namespace
  {
    std::atomic<int>  received_signal{0};
    std::atomic<bool> answers{true};
    static_assert(std::atomic<int>::is_always_lock_free &&
                    std::atomic<bool>::is_always_lock_free,
                  "A signal handler may only use lock-free atomics.");

    extern "C" void
    handle_interrupt(const int signal)
    {
      static constexpr char message[] =
        "\nInterrupted: stopping after the current state "
        "(again to stop at once).\n";
      const int saved_errno = errno;
      received_signal       = signal;
      if (answers)
        {
          [[maybe_unused]] const auto n_written =
            write(STDERR_FILENO, message, sizeof(message) - 1);
        }
      errno = saved_errno;
    }
  } // namespace



  void
  install_interrupt_handlers()
  {
    received_signal = 0;
    answers         = Ranks::count() == 1;

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
    double signal = received_signal;
    if (!Ranks::others_wait())
      signal = Ranks::maximum(signal);
    if (signal != 0)
      throw Interrupted(signal == SIGINT ? "Interrupted by Ctrl-C (SIGINT)."
                                         : "Interrupted by SIGTERM.");
  }
} // namespace RollingContact
