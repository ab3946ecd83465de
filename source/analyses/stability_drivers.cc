#include <rolling_contact/analyses/stability_drivers.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /// friction beyond which waves of the patch itself grow
    const double most_friction = 0.9;

    /// change of friction that leaves next to nothing of it
    const double least_friction = 0.95;

    void set_friction(ContactParameters &contact, const double mu)
    {
      contact.kinetic_friction *= mu / contact.friction_coefficient;
      contact.friction_coefficient = mu;
    }

    void set_longitudinal(ContactParameters &contact, const double creepage)
    {
      contact.creepages.x = creepage;
    }

    void set_lateral(ContactParameters &contact, const double creepage)
    {
      contact.creepages.y = creepage;
    }

    const char along_name[] = "longitudinal creepage";

    /** What drives a state, each to be changed by itself times a number. */
    std::vector<StateDriver> drivers_of(const ContactParameters &contact,
                                        const double             times)
    {
      const double mu = contact.friction_coefficient, x = contact.creepages.x,
                   y = contact.creepages.y;
      std::vector<StateDriver> drivers{
        {"friction", mu, times * mu, mu, &set_friction}};
      // where forces are asked for creepages follow
      if (y != 0. && !contact.forces.any())
        drivers.push_back(
          {"lateral creepage", y, times * y, std::abs(y), &set_lateral});
      if (x != 0. && !contact.forces.any())
        drivers.push_back(
          {along_name, x, times * x, std::abs(x), &set_longitudinal});
      return drivers;
    }
  } // namespace

  std::vector<StateDriver> possible_cures(const ContactParameters &contact)
  {
    std::vector<StateDriver> drivers = drivers_of(contact, -1.);
    drivers[0].search.most           = least_friction;
    const Creepages &slip            = contact.creepages;
    const double     all             = std::hypot(slip.x, slip.y);
    if (slip.y != 0. && !contact.forces.any())
      for (const double sign : {1., -1.})
        if (slip.x * sign >= 0.)
          drivers.push_back(
            {along_name, slip.x, sign * all, all, &set_longitudinal});
    return drivers;
  }

  std::vector<StateDriver> possible_onsets(const ContactParameters &contact)
  {
    std::vector<StateDriver> drivers = drivers_of(contact, 1.);
    drivers[0].search.most =
      std::min(1., most_friction / contact.friction_coefficient - 1);
    if (!(drivers[0].search.most > 0.))
      drivers.erase(drivers.begin());
    return drivers;
  }

  StateDriver more_damping(const double now, const double lacking)
  {
    StateDriver driver;
    driver.quantity = "added damping";
    driver.now      = now;
    driver.unit     = lacking;
    driver.search   = {1., 16., 0.02};
    return driver;
  }
} // namespace RollingContact
