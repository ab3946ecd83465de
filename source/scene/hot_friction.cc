#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/scene/hot_friction.h>
#include <rolling_contact/scene/time_function.h>

#include <sstream>

namespace RollingContact
{
  namespace
  {
    /** Below it a temperature is likely one in degrees Celsius. */
    const double coldest = 150.;

    [[noreturn]] void reject_hot_friction(const std::string &text,
                                          const std::string &reason)
    {
      throw InputError("Contact/Friction over temperature = " + text + ": " +
                       reason +
                       " Give temperatures in K, rising, each with the share "
                       "of mu there, as 293: 1, 573: 1, 1073: 0.5.");
    }
  } // namespace

  HotFriction::HotFriction(const std::string &text)
  {
    std::istringstream list(text);
    for (std::string part; std::getline(list, part, ',');)
      {
        const std::size_t colon       = part.find(':');
        const auto        temperature = colon == std::string::npos
                                          ? std::nullopt
                                          : number_of(trimmed(part.substr(0, colon)));
        const auto        share       = colon == std::string::npos
                                          ? std::nullopt
                                          : number_of(trimmed(part.substr(colon + 1)));
        if (!temperature || !share)
          reject_hot_friction(text, "\"" + trimmed(part) + "\" is no pair.");
        if (!(*temperature >= coldest))
          reject_hot_friction(text,
                              text_of(*temperature) +
                                " K is colder than rails are; 0 degrees "
                                "Celsius are 273.15 K.");
        if (!points.empty() && *temperature <= points.back().first)
          reject_hot_friction(text,
                              text_of(*temperature) +
                                " K does not rise above the one before.");
        if (!(*share > 0.))
          reject_hot_friction(text,
                              "the share " + text_of(*share) +
                                " is not above 0.");
        points.emplace_back(*temperature, *share);
      }
  }

  double HotFriction::share(const double temperature) const
  {
    return points.empty() ? 1. : value_between(points, temperature);
  }
} // namespace RollingContact
