#ifndef rolling_contact_mesh_absorber_ring_h
#define rolling_contact_mesh_absorber_ring_h

namespace RollingContact
{
  /**
   * The direction of the body's surface motion that an absorber follows: along
   * the axle, away from it or around it.
   */
  enum class AbsorberDirection
  {
    axial,
    radial,
    circumferential
  };

  /**
   * Equal dynamic absorbers at equal angles on a circle round the axle of a
   * body: point masses m, each on a spring k = m (2 pi f)^2 and a dashpot
   * c = 2 zeta m (2 pi f), all of which act in one direction alone.
   */
  struct AbsorberRing
  {
    unsigned int      number        = 0;
    double            mass          = 0.; ///< m, of each. Units: kg
    double            frequency     = 0.; ///< f, of a mass on its spring, Hz
    double            damping_ratio = 0.; ///< zeta
    double            radius        = 0.; ///< of the circle, m
    double            position      = 0.; ///< of the circle along the axle, m
    AbsorberDirection direction     = AbsorberDirection::axial;

    /** Highest number of nodal diameters d at which they act as a continuous
     * ring does, n >= 2 d + 1. */
    unsigned int most_diameters() const
    {
      return number > 0 ? (number - 1) / 2 : 0;
    }
  };
} // namespace RollingContact

#endif
