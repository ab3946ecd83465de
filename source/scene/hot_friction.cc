#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/input/text_table.h>
#include <rolling_contact/scene/hot_friction.h>
#include <rolling_contact/scene/time_function.h>

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
    if (text.empty())
      return;
    for (const std::string &part : cells_of(text, ','))
      {
        const auto pair        = cells_of(part, ':');
        const auto temperature = number(pair.front());
        const auto share       = number(pair.back());
        if (pair.size() != 2 || !temperature || !share)
          reject_hot_friction(text, "\"" + part + "\" is not a pair.");
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
