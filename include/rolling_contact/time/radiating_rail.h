#ifndef rolling_contact_time_radiating_rail_h
#define rolling_contact_time_radiating_rail_h

#include <rolling_contact/time/modal_sound.h>
#include <rolling_contact/vibration/vibrating_body.h>

#include <map>
#include <vector>

namespace RollingContact::Sound
{
  /**
   * A rail without ends by the sound of all its length, under the four forces F
   * of RailWaves at the contact: it radiates
   *
   *   P = F^H Q F,   Q = rho c w^2 sum over y and z of
   *                  sigma int (n . e)^2 (u . e)^H (u . e) dS,
   *
   * u the displacements by unit forces, as a long beam along y and z, see
   * efficiency_of_cylinder(). The integral is exact by waves. Q is found at
   * equal ratios of the frequency and linear in between.
   */
  class RadiatingRail
  {
  public:
    /** Keeps references to the rail. @p added_damping: a ratio as modes have
     * it. */
    RadiatingRail(const VibratingBody<3> &rail,
                  const Air              &air,
                  const double            added_damping);

    /** Q, 4 x 4, Hermitian. Units: Hz; W/N^2. */
    ComplexMatrix power_form(const double frequency);

  private:
    const ComplexMatrix &at_sample(const int sample);

    const RailWaves                           &waves;
    Air                                        air;
    double                                     added_damping;
    std::vector<ComplexMatrix>                 forms; ///< of y and z, m
    std::vector<std::function<double(double)>> efficiencies;
    std::map<int, ComplexMatrix>               known;
  };
} // namespace RollingContact::Sound

#endif
