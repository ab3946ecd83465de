#ifndef rolling_contact_scene_load_curve_parameters_h
#define rolling_contact_scene_load_curve_parameters_h

#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace RollingContact
{
  /**
   * Section `Load curve`.
   */
  struct LoadCurveParameters
  {
    void
    declare(dealii::ParameterHandler &prm);

    /**
     * Throws InputError if a fraction is not in (0, 1].
     */
    void
    check() const;

    /** Loads over that of section Contact. Units: 1. */
    std::vector<double> load_fractions{1.};
  };
} // namespace RollingContact

#endif
