#include <deal.II/base/parameter_handler.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/input/number_list.h>
#include <rolling_contact/input/prm_declarations.h>
#include <rolling_contact/scene/creep_curve_parameters.h>

#include <algorithm>
#include <optional>
#include <tuple>

namespace RollingContact
{
  using namespace dealii;

  void
  CreepCurveParameters::declare(ParameterHandler &prm)
  {
    const std::string form =
      " along the curve: " + std::string(number_list_form) +
      "; a single number holds for all points. ";
    prm.enter_subsection("Creep curve");
    declare_number_list(prm,
                        "Creep curve/Creepage x",
                        creepage_x,
                        "0",
                        "Longitudinal creepages" + form + "Units: 1.");
    declare_number_list(prm,
                        "Creep curve/Creepage y",
                        creepage_y,
                        "0",
                        "Lateral creepages" + form + "Units: 1.");
    declare_number_list(prm,
                        "Creep curve/Spin",
                        spin,
                        "0",
                        "Spin creepages" + form + "Units: 1/m.");
    const std::string instead =
      " on the wheel along the curve, in place of creepages, which are found "
      "for them; empty for none. ";
    declare_number_list(prm,
                        "Creep curve/Longitudinal force",
                        longitudinal_force,
                        "",
                        "Forces of friction along x" + instead + "Units: N.");
    declare_number_list(prm,
                        "Creep curve/Lateral force",
                        lateral_force,
                        "",
                        "Forces of friction along y" + instead + "Units: N.");
    declare_number_list(prm,
                        "Creep curve/Spin moment",
                        spin_moment,
                        "",
                        "Moments of friction about the normal" + instead +
                          "Units: N m.");
    prm.leave_subsection();
  }



  void
  CreepCurveParameters::check_in_2d() const
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



  void
  CreepCurveParameters::check_pairs() const
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



  std::vector<CreepCurvePoint>
  CreepCurveParameters::points() const
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
