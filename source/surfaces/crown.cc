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
    const double last        = 0.999, // of the half-length
      share                  = std::abs(2 * y / roller.length),
                 scale       = load / (pi * roller.modulus * roller.length);
    const bool   is_lundberg = kind == Kind::lundberg;
    const double c           = is_lundberg
                                 ? 1.
                                 : 1 - 0.3033 * 2 * roller.half_width / roller.length,
                 end = is_lundberg ? last : 1., inside = std::min(share, end),
                 slope = 2 * c * inside / (1 - c * inside * inside);
    return scale * (-std::log1p(-c * inside * inside) +
                    (length ? slope * (share - inside) : 0.));
  }

  namespace
  {
    std::optional<double> above_0(const std::string &text)
    {
      const auto value = number_of(boost::trim_copy(text));
      return value && std::isfinite(*value) && *value > 0. ? value
                                                           : std::nullopt;
    }
  } // namespace

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
          const auto none   = std::string::npos;
          const auto second = colon == none ? none : text.find(':', colon + 1);
          const auto load =
            colon == none ? std::nullopt
                          : above_0(text.substr(colon + 1, second - colon - 1));
          if (!load)
            throw InputError(entry + " = " + text +
                             ": give the load in N, above "
                             "0, that the crown is "
                             "for, as in " +
                             its_name + " : 5000.");
          const auto length =
            second == none ? std::nullopt : above_0(text.substr(second + 1));
          if (second != none && !length)
            throw InputError(entry + " = " + text +
                             ": give the crown's own length in m, above 0, as "
                             "in " +
                             its_name +
                             " : 5000 : 0.008, or leave it away for that of "
                             "the contact.");
          return Crown{kind, *load, length};
        }
    return {};
  }
} // namespace RollingContact
