#ifndef rolling_contact_analyses_creep_curve_parameters_h
#define rolling_contact_analyses_creep_curve_parameters_h

#include <rolling_contact/base/asked_forces.h>
#include <rolling_contact/base/creepages.h>

#include <vector>

namespace RollingContact
{
  class Entries;

  /**
   * A point of a creep curve: creepages, or forces in place of some of them,
   * which are 0 then.
   */
  struct CreepCurvePoint
  {
    Creepages   creepages;
    AskedForces forces;
  };

  /**
   * Section `Creep curve`: a path of creepages, or of forces in place of some.
   */
  struct CreepCurveParameters
  {
    void declare(Entries &entries);

    /**
     * The points of the path. Throws InputError if the lengths of the lists
     * differ, or a creepage and its force are given.
     */
    std::vector<CreepCurvePoint> points() const;

    void check() const
    {
      points();
    }

    /**
     * Throws InputError if a point has what exists in 3D only.
     */
    void check_in_2d() const;

    /**
     * Creepages of the points; a single number holds for all of them. Units: 1,
     * 1, 1/m.
     */
    std::vector<double> creepage_x{0.}, creepage_y{0.}, spin{0.};
    /** In place of creepages; empty for none. Units: N, N, N m. */
    std::vector<double> longitudinal_force, lateral_force, spin_moment;

  private:
    /**
     * Throws InputError if a creepage and its force are given.
     */
    void check_pairs() const;
  };
} // namespace RollingContact

#endif
