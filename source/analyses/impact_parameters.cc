#include <rolling_contact/analyses/impact_parameters.h>
#include <rolling_contact/input/number_list.h>
#include <rolling_contact/scene/entries.h>

namespace RollingContact
{
  void ImpactParameters::declare(Entries &entries)
  {
    entries.section("Impact").read_by_analyses("impact");
    entries.add("Speeds", speeds, "m/s").help =
      "Rolling speeds, each a run of its own of section Time, " +
      std::string(number_list_form) +
      "; they have the direction of Contact/Speed, which alone is taken where "
      "this is empty.";
  }

  void ImpactParameters::check() const
  {
    speeds_or(1.);
  }

  std::vector<double> ImpactParameters::speeds_or(const double given) const
  {
    return speeds.empty() ? std::vector<double>{given}
                          : positive_numbers("Impact/Speeds", speeds, "m/s");
  }
} // namespace RollingContact
