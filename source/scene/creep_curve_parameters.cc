#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/input/number_list.h>
#include <rolling_contact/scene/creep_curve_parameters.h>

#include <algorithm>

namespace RollingContact
{
  using namespace dealii;

  CreepCurveParameters::CreepCurveParameters()
    : ParameterAcceptor("/Creep curve")
  {
    const std::string form =
      " along the curve: " + std::string(number_list_form) +
      "; a single number holds for all points. ";
    add_parameter("Creepage x",
                  creepage_x,
                  "Longitudinal creepages" + form + "Units: 1.",
                  prm,
                  Patterns::Anything());
    add_parameter("Creepage y",
                  creepage_y,
                  "Lateral creepages" + form + "Units: 1.",
                  prm,
                  Patterns::Anything());
    add_parameter("Spin",
                  spin,
                  "Spin creepages" + form + "Units: 1/m.",
                  prm,
                  Patterns::Anything());
  }



  std::vector<Creepages>
  CreepCurveParameters::points() const
  {
    const std::vector<double> x   = number_list("Creep curve/Creepage x",
                                              creepage_x),
                              y   = number_list("Creep curve/Creepage y",
                                              creepage_y),
                              phi = number_list("Creep curve/Spin", spin);
    const std::size_t n           = std::max({x.size(), y.size(), phi.size()});
    const auto        length      = [&](const std::size_t size) {
      return size == 1 || size == n;
    };
    if (!length(x.size()) || !length(y.size()) || !length(phi.size()))
      throw InputError("Creep curve: Creepage x has " +
                       std::to_string(x.size()) + " points, Creepage y " +
                       std::to_string(y.size()) + " and Spin " +
                       std::to_string(phi.size()) +
                       ": give lists of the same length, or single numbers.");
    const auto at = [](const std::vector<double> &list, const std::size_t i) {
      return list[list.size() == 1 ? 0 : i];
    };
    std::vector<Creepages> points(n);
    for (std::size_t i = 0; i < n; ++i)
      points[i] = {at(x, i), at(y, i), at(phi, i)};
    return points;
  }
} // namespace RollingContact
