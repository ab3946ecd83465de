#include <boost/algorithm/string/trim.hpp>

#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/surfaces/crown.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace RollingContact
{
  double Crown::drop(const double y, const Roller &roller) const
  {
    const double last = 0.999, // of the half-length
      share           = std::min(std::abs(2 * y / roller.length), 1.),
                 q    = load / roller.length;
    const double inside =
      kind == Kind::lundberg
        ? std::pow(std::min(share, last), 2)
        : (1 - 0.3033 * 2 * roller.half_width / roller.length) * share * share;
    return -q / (pi * roller.modulus) * std::log1p(-inside);
  }

  std::optional<Crown> crown_named(const std::string &entry,
                                   const std::string &text)
  {
    const auto colon = text.find(':');
    const auto name  = boost::trim_copy(text.substr(0, colon));
    for (const auto &[kind, its_name] :
         {std::pair(Crown::Kind::lundberg, "lundberg"),
          std::pair(Crown::Kind::johns_gohar, "johns-gohar")})
      if (name == its_name)
        {
          const auto load =
            colon == std::string::npos
              ? std::nullopt
              : number_of(boost::trim_copy(text.substr(colon + 1)));
          if (!load || !std::isfinite(*load) || !(*load > 0.))
            throw InputError(entry + " = " + text +
                             ": give the load in N, above "
                             "0, that the crown is "
                             "for, as in " +
                             its_name + " : 5000.");
          return Crown{kind, *load};
        }
    return {};
  }
} // namespace RollingContact
