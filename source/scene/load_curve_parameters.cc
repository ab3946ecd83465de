#include <deal.II/base/parameter_handler.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/input/number_list.h>
#include <rolling_contact/input/prm_declarations.h>
#include <rolling_contact/scene/load_curve_parameters.h>

namespace RollingContact
{
  using namespace dealii;

  void
  LoadCurveParameters::declare(ParameterHandler &prm)
  {
    prm.enter_subsection("Load curve");
    declare_number_list(
      prm,
      "Load curve/Shares of load",
      load_fractions,
      "0.1 : 1 : 10",
      "Loads over the one of section Contact, for which the mesh is "
      "made: " +
        std::string(number_list_form) + ". Units: 1.");
    prm.leave_subsection();
  }



  void
  LoadCurveParameters::check() const
  {
    for (const double fraction : load_fractions)
      if (!(fraction > 0. && fraction <= 1.))
        throw InputError("Load curve/Shares of load contains " +
                         significant(fraction, 15) +
                         ", which is not above 0 and at most 1.");
  }
} // namespace RollingContact
