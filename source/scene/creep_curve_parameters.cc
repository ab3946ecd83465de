#include <deal.II/base/parameter_handler.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/input/number_list.h>
#include <rolling_contact/input/prm_declarations.h>
#include <rolling_contact/scene/creep_curve_parameters.h>

#include <algorithm>

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
    prm.leave_subsection();
  }



  void
  CreepCurveParameters::check_in_2d() const
  {
    for (const Creepages &point : points())
      if (point.y != 0. || point.spin != 0.)
        throw InputError(
          "Creep curve/" + std::string(point.y != 0. ? "Creepage y" : "Spin") +
          " contains " + text_of(point.y != 0. ? point.y : point.spin) +
          ": lateral creepage and spin exist in 3D only; leave it out or take "
          "Dimension = 3.");
  }



  std::vector<Creepages>
  CreepCurveParameters::points() const
  {
    const std::size_t n =
      std::max({creepage_x.size(), creepage_y.size(), spin.size()});
    const auto length = [&](const std::size_t size) {
      return size == 1 || size == n;
    };
    if (!length(creepage_x.size()) || !length(creepage_y.size()) ||
        !length(spin.size()))
      throw InputError(
        "Creep curve: Creepage x has " + std::to_string(creepage_x.size()) +
        " points, Creepage y " + std::to_string(creepage_y.size()) +
        " and Spin " + std::to_string(spin.size()) +
        ": give lists of the same length, or single numbers.");
    const auto at = [](const std::vector<double> &list, const std::size_t i) {
      return list[list.size() == 1 ? 0 : i];
    };
    std::vector<Creepages> points(n);
    for (std::size_t i = 0; i < n; ++i)
      points[i] = {at(creepage_x, i), at(creepage_y, i), at(spin, i)};
    return points;
  }
} // namespace RollingContact
