#include <pthread.h>
#include <signal.h>
#include <ucontext.h>
#include <unistd.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/files.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/ranks.h>
#include <rolling_contact/base/stopwatch.h>
#include <rolling_contact/base/text.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <mutex>
#include <system_error>
#include <thread>

namespace RollingContact
{
  namespace
  {
    std::atomic<int>  received_signal{0};
    std::atomic<bool> is_stopping{false}; ///< the run follows the signal

    /** What is left when the process is ended at once. */
    struct LastWords
    {
      std::filesystem::path file, temporary;
      std::string           text;
    };

    std::function<void()> interrupt_source;

    std::timed_mutex last_words_mutex;
    LastWords        last_words;

    std::string name_of_interrupt(const int signal)
    {
      return signal == SIGINT    ? "Interrupted by Ctrl-C (SIGINT)"
             : signal == SIGHUP  ? "Interrupted as its terminal was closed "
                                   "(SIGHUP; nohup lets a run go on)"
             : signal == SIGXCPU ? "Interrupted as its CPU time is used up "
                                   "(SIGXCPU; ulimit -t or a batch system)"
             : signal == SIGUSR1 ? "Interrupted by SIGUSR1"
                                 : "Interrupted by SIGTERM";
    }

    /// batch systems announce the end of a job by the last two
    const std::array<int, 5> followed_signals{
      {SIGINT, SIGTERM, SIGHUP, SIGXCPU, SIGUSR1}};

    /**
     * Signals that end a run in order; SIGHUP is not among them if the caller
     * ignores it, as nohup does.
     */
    sigset_t signals_to_follow()
    {
      static const bool hears_hangups = []() {
        struct sigaction present = {};
        sigaction(SIGHUP, nullptr, &present);
        return present.sa_handler != SIG_IGN;
      }();
      sigset_t signals;
      sigemptyset(&signals);
      for (const int signal : followed_signals)
        if (signal != SIGHUP || hears_hangups)
          sigaddset(&signals, signal);
      return signals;
    }

    void say(const std::string &text)
    {
      const std::string           lines = '\n' + wrapped(text) + '\n';
      [[maybe_unused]] const auto n_written =
        write(STDERR_FILENO, lines.data(), lines.size());
    }

    /**
     * Under a launcher a second signal may be its own, which ends the ranks
     * that are left when one has ended: the run has its message already.
     */
    [[noreturn]] void stop_at_once(const int signal, const bool silent)
    {
      try
        {
          // the thread that writes them may have been held up by the disk
          if (last_words_mutex.try_lock_for(std::chrono::seconds(1)) &&
              !last_words.text.empty())
            write_file(last_words.file, last_words.text, last_words.temporary);
          if (!silent)
            say("rolling-contact: " + name_of_interrupt(signal) +
                " and stopped at once: what was complete is kept.");
        }
      catch (const std::exception &)
        {
          // run.json stays as it was
        }
      std::_Exit(static_cast<int>(ExitCode::not_converged));
    }

    /** Waits for a signal, for at most so many seconds if they are positive; 0
     * if there was none. */
    int next_signal(const sigset_t &signals, const double seconds)
    {
      if (seconds <= 0.)
        return sigwaitinfo(&signals, nullptr);
      timespec time{};
      time.tv_sec      = static_cast<time_t>(seconds);
      time.tv_nsec     = static_cast<long>(1e9 * (seconds - time.tv_sec));
      const int signal = sigtimedwait(&signals, nullptr, &time);
      return signal < 0 && errno == EAGAIN ? 0 : signal;
    }

    /** What the thread does that follows the signals. */
    void follow(const sigset_t signals, const bool on_its_own)
    {
      Stopwatch since_first;
      for (;;)
        {
          const int  first = received_signal;
          const bool timed =
            on_its_own && first != 0 && first != SIGINT && !is_stopping;
          const int signal = next_signal(
            signals,
            timed ? std::max(0.01, seconds_to_stop - since_first.seconds())
                  : 0.);
          if (signal == 0 && !is_stopping && received_signal != 0)
            stop_at_once(first, false);
          if (signal <= 0)
            continue;
          int none = 0;
          if (!received_signal.compare_exchange_strong(none, signal))
            {
              if (signal == SIGXCPU) // the kernel's, every second from now on
                continue;
              stop_at_once(signal, !on_its_own && is_stopping);
            }
          since_first = Stopwatch();
          if (on_its_own)
            say(signal == SIGINT
                  ? "Interrupted: stopping after the current state (again to "
                    "stop at once)."
                  : "Interrupted: stopping after the current state, in " +
                      std::to_string(seconds_to_stop) +
                      " s at the latest (again to stop at once).");
        }
    }

    /**
     * A thread that a library started before the signals were blocked hands
     * them on: it blocks them from now on, and only the thread that follows
     * them is left to take the next one.
     */
    void hand_on(const int signal, siginfo_t *, void *context)
    {
      sigset_t &mask = static_cast<ucontext_t *>(context)->uc_sigmask;
      for (const int followed : followed_signals)
        sigaddset(&mask, followed);
      kill(getpid(), signal);
    }

    void hand_on_from_other_threads()
    {
      struct sigaction action = {};
      action.sa_sigaction     = &hand_on;
      action.sa_flags         = SA_SIGINFO | SA_RESTART;
      sigfillset(&action.sa_mask);
      const sigset_t signals = signals_to_follow();
      for (const int signal : followed_signals)
        if (sigismember(&signals, signal))
          sigaction(signal, &action, nullptr);
    }
  } // namespace

  void install_interrupt_handlers()
  {
    received_signal = 0;
    is_stopping     = false;
    signal(SIGPIPE, SIG_IGN);
    signal(SIGXFSZ, SIG_IGN);
    const sigset_t signals = signals_to_follow();
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    static pid_t followed_by = 0; // a forked process has no threads
    try
      {
        if (followed_by != getpid())
          std::thread(&follow, signals, !Ranks::launched()).detach();
        followed_by = getpid();
        hand_on_from_other_threads();
      }
    catch (const std::system_error &)
      {
        // no memory for a thread: a signal ends the process without a word
        pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
      }
  }

  bool interrupted()
  {
    return received_signal != 0;
  }

  void set_interrupt_source(const std::function<void()> &source)
  {
    interrupt_source = source;
  }

  void throw_if_interrupted()
  {
    if (interrupt_source)
      interrupt_source();
    double signal = received_signal;
    if (!Ranks::others_wait())
      signal = Ranks::maximum(signal);
    if (signal == 0)
      return;
    is_stopping = true;
    throw Interrupted(name_of_interrupt(static_cast<int>(signal)) + '.');
  }

  void throw_if_interrupted_alone()
  {
    if (Ranks::count() == 1)
      throw_if_interrupted();
  }

  void leave_on_stop(const std::filesystem::path &file,
                     const std::filesystem::path &temporary,
                     const std::string           &text)
  {
    const std::lock_guard<std::timed_mutex> lock(last_words_mutex);
    last_words = {file, temporary, text};
  }
} // namespace RollingContact
