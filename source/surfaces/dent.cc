#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/surfaces/dent.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace RollingContact
{
  double Dent::height(const double X, const double radius) const
  {
    if (std::abs(X) >= length / 2)
      return 0.;
    if (kind == Kind::dip)
      return -depth * std::pow(std::cos(pi * X / length), 2);
    const double half = length / (2 * radius), // cos(phi_0) = sqrt(1 - half^2)
      lift            = std::sqrt(1 - half * half) / std::cos(X / radius);
    return std::min(0., radius * (lift - 1));
  }

  std::optional<Dent> dent_named(const std::string &entry,
                                 const std::string &text)
  {
    const auto colon = text.find(':');
    const auto name  = boost::trim_copy(text.substr(0, colon));
    if (name != "flat" && name != "dip")
      return {};
    const Dent::Kind kind = name == "flat" ? Dent::Kind::flat : Dent::Kind::dip;
    std::vector<std::string> words;
    if (colon != std::string::npos)
      boost::split(words, text.substr(colon + 1), boost::is_any_of(","));
    std::vector<double> numbers;
    for (const std::string &word : words)
      if (const auto number = number_of(boost::trim_copy(word));
          number && std::isfinite(*number) && *number > 0.)
        numbers.push_back(*number);
    const std::size_t wanted = kind == Dent::Kind::flat ? 1 : 2;
    if (numbers.size() != wanted || words.size() != wanted)
      throw InputError(entry + " = " + text + ": give " +
                       (kind == Dent::Kind::flat
                          ? "the length of the flat in m, above 0, as in flat "
                            ": 0.05."
                          : "length and depth of the dip in m, above 0, as in "
                            "dip : 0.05, 0.5e-3."));
    return Dent{kind,
                numbers.front(),
                kind == Dent::Kind::dip ? numbers.back() : 0.};
  }
} // namespace RollingContact
