#ifndef tests_unit_reference_checks_h
#define tests_unit_reference_checks_h

#include <boost/test/unit_test.hpp>

#include <rolling_contact/base/exceptions.h>

#include <cctype>
#include <cmath>
#include <string>

/**
 * Midpoint rule in the angle of a half circle over the interval: converges
 * fast with square roots at the ends.
 */
template <typename Function>
double integrate(const Function &function,
                 const double    from,
                 const double    to,
                 const int       n_points = 2000)
{
  const double pi  = std::acos(-1.);
  double       sum = 0;
  for (int i = 0; i < n_points; ++i)
    {
      const double angle = pi * (i + 0.5) / n_points;
      sum += std::sin(angle) *
             function((from + to) / 2 - (to - from) / 2 * std::cos(angle));
    }
  return sum * pi / n_points * (to - from) / 2;
}

struct InputErrorNaming
{
  /** The text is there, and no letter after it: "0 m" is not "0 mm". */
  bool operator()(const RollingContact::InputError &error) const
  {
    const std::string what = error.what();
    const std::size_t at = what.find(text), end = at + text.size();
    return at != std::string::npos &&
           !(end < what.size() && std::isalpha(what[end]) &&
             std::isalpha(what[end - 1]));
  }

  std::string text;
};

#define CHECK_INPUT_ERROR(expression, text)         \
  BOOST_CHECK_EXCEPTION(expression,                 \
                        RollingContact::InputError, \
                        InputErrorNaming{text})

#endif
