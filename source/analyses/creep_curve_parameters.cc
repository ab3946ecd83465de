#include <rolling_contact/analyses/creep_curve_parameters.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/input/number_list.h>
#include <rolling_contact/scene/entries.h>

#include <algorithm>
#include <optional>
#include <tuple>

namespace RollingContact
{
  void CreepCurveParameters::declare(Entries &entries)
  {
    const std::string form =
      " along the curve: " + std::string(number_list_form) +
      "; a single number holds for all points.";
    entries.section("Creep curve").read_by_analyses("creep curve");
    entries.list("Creepage x", creepage_x, "0", "1").help =
      "Longitudinal creepages" + form;
    entries.list("Creepage y", creepage_y, "0", "1").help =
      "Lateral creepages" + form;
    entries.list("Spin", spin, "0", "1/m").help = "Spin creepages" + form;
    const std::string instead =
      " on the wheel along the curve, in place of creepages, which are found "
      "for them; empty for none.";
    entries.list("Longitudinal force", longitudinal_force, "", "N").help =
      "Forces of friction along x" + instead;
    entries.list("Lateral force", lateral_force, "", "N").help =
      "Forces of friction along y" + instead;
    entries.list("Spin moment", spin_moment, "", "N m").help =
      "Moments of friction about the normal" + instead;
  }

  void CreepCurveParameters::check_in_2d() const
  {
    const auto refuse = [](const std::string &entry, const double value) {
      throw InputError(
        "Creep curve/" + entry + " contains " + text_of(value) +
        ": lateral creepage and spin, their force and moment, exist in 3D "
        "only; leave it out or take Dimension = 3.");
    };
    for (const CreepCurvePoint &point : points())
      {
        if (point.creepages.y != 0.)
          refuse("Creepage y", point.creepages.y);
        if (point.creepages.spin != 0.)
          refuse("Spin", point.creepages.spin);
        if (point.forces.y)
          refuse("Lateral force", *point.forces.y);
        if (point.forces.moment)
          refuse("Spin moment", *point.forces.moment);
      }
  }

  void CreepCurveParameters::check_pairs() const
  {
    for (const auto &[entry, creepages, force_entry, forces] :
         {std::tuple("Creepage x",
                     &creepage_x,
                     "Longitudinal force",
                     &longitudinal_force),
          std::tuple(
            "Creepage y", &creepage_y, "Lateral force", &lateral_force),
          std::tuple("Spin", &spin, "Spin moment", &spin_moment)})
      if (!forces->empty() && *creepages != std::vector<double>{0.})
        throw InputError("Creep curve/" + std::string(entry) + " and " +
                         force_entry +
                         ": the creepage is found for the force; leave one of "
                         "them out.");
  }

  std::vector<CreepCurvePoint> CreepCurveParameters::points() const
  {
    check_pairs();
    const std::vector<std::pair<std::string, const std::vector<double> *>>
                lists{{"Creepage x", &creepage_x},
            {"Creepage y", &creepage_y},
            {"Spin", &spin},
            {"Longitudinal force", &longitudinal_force},
            {"Lateral force", &lateral_force},
            {"Spin moment", &spin_moment}};
    std::size_t n = 1;
    for (const auto &list : lists)
      n = std::max(n, list.second->size());
    std::string lengths;
    bool        differ = false;
    for (const auto &[entry, list] : lists)
      if (list->size() > 1)
        {
          lengths += (lengths.empty() ? "" : ", ") + entry + " has " +
                     std::to_string(list->size()) + " points";
          differ = differ || list->size() != n;
        }
    if (differ)
      throw InputError("Creep curve: " + lengths +
                       ": give lists of the same length, or single numbers.");
    const auto at = [](const std::vector<double> &list, const std::size_t i) {
      return list[list.size() == 1 ? 0 : i];
    };
    const auto asked = [&](const std::vector<double> &list,
                           const std::size_t          i) {
      return list.empty() ? std::optional<double>() : at(list, i);
    };
    std::vector<CreepCurvePoint> points(n);
    for (std::size_t i = 0; i < n; ++i)
      points[i] = {{at(creepage_x, i), at(creepage_y, i), at(spin, i)},
                   {asked(longitudinal_force, i),
                    asked(lateral_force, i),
                    asked(spin_moment, i)}};
    return points;
  }
} // namespace RollingContact
