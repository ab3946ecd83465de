#ifndef rolling_contact_scene_creep_curve_parameters_h
#define rolling_contact_scene_creep_curve_parameters_h

#include <rolling_contact/base/creepages.h>

#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace RollingContact
{
  /**
   * Section `Creep curve`: a path of creepages.
   */
  struct CreepCurveParameters
  {
    void
    declare(dealii::ParameterHandler &prm);

    /**
     * The points of the path. Throws InputError if the lengths of the lists
     * differ.
     */
    std::vector<Creepages>
    points() const;

    void
    check() const
    {
      points();
    }

    /**
     * Throws InputError if a point has what exists in 3D only.
     */
    void
    check_in_2d() const;

    /**
     * Creepages of the points; a single number holds for all of them. Units: 1,
     * 1, 1/m.
     */
    std::vector<double> creepage_x{0.}, creepage_y{0.}, spin{0.};
  };
} // namespace RollingContact

#endif
