#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/input/number_list.h>
#include <rolling_contact/scene/load_curve_parameters.h>

namespace RollingContact
{
  using namespace dealii;

  LoadCurveParameters::LoadCurveParameters()
    : ParameterAcceptor("/Load curve")
  {
    add_parameter(
      "Shares of load",
      shares,
      "Loads over the one of section Contact, for which the mesh is "
      "made: " +
        std::string(number_list_form) + ". Units: 1.",
      prm,
      Patterns::Anything());
  }



  std::vector<double>
  LoadCurveParameters::load_fractions() const
  {
    const std::vector<double> list =
      number_list("Load curve/Shares of load", shares);
    for (const double share : list)
      if (!(share > 0. && share <= 1.))
        throw InputError("Load curve/Shares of load = " + shares + ": " +
                         Patterns::Tools::to_string(share) +
                         " is not above 0 and at most 1.");
    return list;
  }
} // namespace RollingContact
