#ifndef rolling_contact_run_log_h
#define rolling_contact_run_log_h

#include <rolling_contact/base/verbosity.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * What the program says while it runs, wrapped at screen_width() columns.
   * Warnings and errors are said at every verbosity; warnings are also kept,
   * for run.json. Does not own its streams.
   */
  class Log
  {
  public:
    /** Keeps messages and details back while it lives; warnings are said. */
    class Silence
    {
    public:
      explicit Silence(Log &log)
        : log(log)
      {
        ++log.silences;
      }

      ~Silence()
      {
        --log.silences;
      }

      Silence(const Silence &)            = delete;
      Silence &operator=(const Silence &) = delete;

    private:
      Log &log;
    };

    /** While it lives, nothing is said but warnings that were not said before:
     * for work that is done a second time. */
    class Again
    {
    public:
      explicit Again(Log &log)
        : silence(log)
        , log(log)
      {
        ++log.repetitions;
      }

      ~Again()
      {
        --log.repetitions;
      }

      Again(const Again &)            = delete;
      Again &operator=(const Again &) = delete;

    private:
      const Silence silence;
      Log          &log;
    };

    /** Writes to std::cout, warnings and errors to std::cerr; on other ranks
     * than the root nowhere. */
    explicit Log(Verbosity verbosity);

    Log(Verbosity verbosity, std::ostream &out, std::ostream &errors);

    /** Said unless quiet or within a Silence. */
    void message(const std::string &text);

    /** Said only when verbose. */
    void detail(const std::string &text);

    void warning(const std::string &text);

    void error(const std::string &text);

    const std::vector<std::string> &warnings() const;

  private:
    const Verbosity          verbosity;
    std::ostream            &out;
    std::ostream            &errors;
    std::vector<std::string> kept_warnings;
    unsigned int             silences = 0, repetitions = 0; ///< that live
  };
} // namespace RollingContact

#endif
