#include <rolling_contact/base/platform.h>
#include <rolling_contact/base/ranks.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/run/log.h>

#include <algorithm>
#include <iostream>

namespace RollingContact
{
  namespace
  {
    /** The stream, or one that drops everything: only the root talks. */
    std::ostream &of_the_root(std::ostream &stream)
    {
      static std::ostream silent(nullptr);
      return Ranks::is_root() ? stream : silent;
    }
  } // namespace

  Log::Log(const Verbosity verbosity)
    : Log(verbosity, of_the_root(std::cout), of_the_root(std::cerr))
  {}

  Log::Log(const Verbosity verbosity, std::ostream &out, std::ostream &errors)
    : verbosity(verbosity)
    , out(out)
    , errors(errors)
  {}

  void Log::message(const std::string &text)
  {
    if (verbosity != Verbosity::quiet && silences == 0)
      out << wrapped(text, screen_width()) << std::endl;
  }

  void Log::detail(const std::string &text)
  {
    if (verbosity == Verbosity::verbose && silences == 0)
      out << wrapped(text, screen_width()) << std::endl;
  }

  void Log::warning(const std::string &text)
  {
    if (repetitions > 0 &&
        std::find(kept_warnings.begin(), kept_warnings.end(), text) !=
          kept_warnings.end())
      return;
    kept_warnings.push_back(text);
    errors << wrapped("Warning: " + text, screen_width()) << std::endl;
  }

  void Log::error(const std::string &text)
  {
    errors << wrapped("Error: " + text, screen_width()) << std::endl;
  }

  const std::vector<std::string> &Log::warnings() const
  {
    return kept_warnings;
  }
} // namespace RollingContact
