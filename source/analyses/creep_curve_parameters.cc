#include <rolling_contact/analyses/creep_curve_parameters.h>
#include <rolling_contact/base/exceptions.h>

#include <cmath>
#include <sstream>

namespace RollingContact
{
  using namespace dealii;

  CreepCurveParameters::CreepCurveParameters()
    : ParameterAcceptor("/Creep curve")
  {
    const std::string form =
      " along the curve: numbers separated by commas, or `first : last : number "
      "of points`; a single number holds for all points. ";
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



  namespace
  {
    [[noreturn]] void
    reject(const std::string &entry,
           const std::string &text,
           const std::string &reason)
    {
      throw InputError("Creep curve/" + entry + " = " + text + ": " + reason +
                       " Give numbers separated by commas, or first : last : "
                       "number of points.");
    }



    double
    number(const std::string &entry,
           const std::string &text,
           const std::string &part)
    {
      std::istringstream input(part);
      double             value = 0.;
      std::string        rest;
      if (!(input >> value) || (input >> rest) || !std::isfinite(value))
        reject(entry, text, "'" + part + "' is not a number.");
      return value;
    }



    std::vector<double>
    split(const std::string &entry,
          const std::string &text,
          const char         separator)
    {
      std::vector<double> values;
      std::istringstream  input(text);
      for (std::string part; std::getline(input >> std::ws, part, separator);)
        values.push_back(number(entry, text, part));
      return values;
    }



    std::vector<double>
    parse(const std::string &entry, const std::string &text)
    {
      if (text.find(':') == std::string::npos)
        {
          const std::vector<double> list = split(entry, text, ',');
          if (list.empty())
            reject(entry, text, "the list is empty.");
          return list;
        }
      const std::vector<double> range = split(entry, text, ':');
      if (range.size() != 3 || range[2] < 2 || range[2] > 1e6 ||
          range[2] != std::floor(range[2]))
        reject(entry, text, "a range needs at least 2 points.");
      const unsigned int  n = range[2];
      std::vector<double> list(n);
      for (unsigned int i = 0; i < n; ++i)
        list[i] = range[0] + (range[1] - range[0]) * i / (n - 1);
      return list;
    }
  } // namespace



  std::vector<References::Creepages>
  CreepCurveParameters::points() const
  {
    const std::vector<double> x   = parse("Creepage x", creepage_x),
                              y   = parse("Creepage y", creepage_y),
                              phi = parse("Spin", spin);
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
    std::vector<References::Creepages> points(n);
    for (std::size_t i = 0; i < n; ++i)
      points[i] = {at(x, i), at(y, i), at(phi, i)};
    return points;
  }
} // namespace RollingContact
