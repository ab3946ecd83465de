#ifndef rolling_contact_scene_load_curve_parameters_h
#define rolling_contact_scene_load_curve_parameters_h

#include <deal.II/base/parameter_acceptor.h>

#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * Section `Load curve`.
   */
  struct LoadCurveParameters : public dealii::ParameterAcceptor
  {
    LoadCurveParameters();

    /**
     * Loads over that of section Contact. Throws InputError if the list is
     * malformed or a share is not in (0, 1].
     */
    std::vector<double>
    load_fractions() const;

    std::string shares = "0.1 : 1 : 10";
  };
} // namespace RollingContact

#endif
