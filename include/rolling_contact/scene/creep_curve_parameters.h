#ifndef rolling_contact_scene_creep_curve_parameters_h
#define rolling_contact_scene_creep_curve_parameters_h

#include <deal.II/base/parameter_acceptor.h>

#include <rolling_contact/base/creepages.h>

#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * Section `Creep curve`: a path of creepages.
   */
  struct CreepCurveParameters : public dealii::ParameterAcceptor
  {
    CreepCurveParameters();

    /**
     * The points of the path. Throws InputError if a list is malformed or the
     * lengths differ.
     */
    std::vector<Creepages>
    points() const;

    void
    check() const
    {
      points();
    }

    std::string creepage_x = "0";
    std::string creepage_y = "0";
    std::string spin       = "0";
  };
} // namespace RollingContact

#endif
