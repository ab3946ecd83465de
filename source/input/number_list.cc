#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/input/number_list.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace RollingContact
{
  const char *const number_list_form =
    "numbers separated by commas, or `first : last : number of points`";

  namespace
  {
    constexpr double most_points = 1e6;

    [[noreturn]] void reject(const std::string &entry,
                             const std::string &text,
                             const std::string &reason)
    {
      throw InputError(entry + " = " + text + ": " + reason +
                       " Give numbers separated by commas, or first : last : "
                       "number of points.");
    }

    double number(const std::string &entry,
                  const std::string &text,
                  const std::string &part)
    {
      std::istringstream input(part);
      double             value = 0.;
      std::string        rest;
      if (!(input >> value) || (input >> rest) || !std::isfinite(value))
        reject(entry, text, "'" + part + "' is not a number.");
      return value;
    }

    std::vector<double> split(const std::string &entry,
                              const std::string &text,
                              const char         separator)
    {
      std::vector<double> values;
      std::istringstream  input(text);
      for (std::string part; std::getline(input >> std::ws, part, separator);)
        values.push_back(number(entry, text, part));
      return values;
    }
  } // namespace

  std::vector<double> number_list(const std::string &entry,
                                  const std::string &text)
  {
    if (text.find(':') == std::string::npos)
      {
        const std::vector<double> list = split(entry, text, ',');
        if (list.empty())
          reject(entry, text, "the list is empty.");
        return list;
      }
    const std::vector<double> range = split(entry, text, ':');
    if (range.size() != 3 || range[2] < 2 || range[2] != std::floor(range[2]))
      reject(entry, text, "a range needs at least 2 points.");
    if (range[2] > most_points)
      reject(entry, text, "a range has at most a million points.");
    const unsigned int n = range[2];
    if (!std::isfinite((range[1] - range[0]) * (n - 1)))
      reject(entry, text, "first and last are too far apart.");
    std::vector<double> list(n);
    for (unsigned int i = 0; i < n; ++i)
      list[i] = range[0] + (range[1] - range[0]) * i / (n - 1);
    list.back() = range[1]; // without rounding
    return list;
  }

  std::vector<double> positive_numbers(const std::string &entry,
                                       const std::string &text,
                                       const std::string &unit)
  {
    auto numbers = number_list(entry, text);
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    if (!(numbers.front() > 0.))
      throw InputError(entry + " = " + text + ": " + text_of(numbers.front()) +
                       " is among them; give numbers above 0 " + unit + ".");
    return numbers;
  }

  std::vector<double> speeds_or(const double       given,
                                const std::string &entry,
                                const std::string &text)
  {
    return text.empty() ? std::vector<double>{given}
                        : positive_numbers(entry, text, "m/s");
  }
} // namespace RollingContact
