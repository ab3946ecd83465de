#ifndef rolling_contact_modes_mode_character_h
#define rolling_contact_modes_mode_character_h

#include <rolling_contact/mesh/body_shape.h>
#include <rolling_contact/modes/body_places.h>
#include <rolling_contact/modes/measuring_point.h>
#include <rolling_contact/modes/structural_modes.h>

#include <optional>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * What a mode looks like. The shares are those of the kinetic energy, by the
   * direction of the motion: along the axle, away from it and around it; of a
   * body without an axle along y, z and x.
   */
  struct ModeCharacter
  {
    /** The order of the Fourier series round the axle with most of the
     * energy; none for a body without an axle. */
    std::optional<unsigned int> nodal_diameters;
    double                      diameter_share = 0.; ///< energy of that order

    /** How often the axial motion of that order changes its sign from the hub
     * to the tread; none where there are no nodal diameters. */
    std::optional<unsigned int> nodal_circles;

    double axial_share           = 0.;
    double radial_share          = 0.;
    double circumferential_share = 0.;

    /** The other mode of a pair of the same shape, turned by a quarter of a
     * wave. */
    std::optional<std::size_t> partner;
    /** Difference of the frequencies of the pair over their mean. */
    double split = 0.;

    /**
     * The motion with most of the energy: L along the axle, R away from it, C
     * around it.
     */
    char family() const;

    /**
     * The name in the literature of wheels, by family and nodal diameters: 0L3
     * axial with no nodal circle, R2 radial, C1 circumferential; empty for a
     * body without an axle.
     */
    std::string name() const;
  };

  /**
   * The character of all modes of a body. Rings of nodes at the same distance
   * from the axle give the Fourier series.
   */
  std::vector<ModeCharacter> mode_characters(const BodyPlaces          &places,
                                             const std::optional<Axle> &axle,
                                             const StructuralModes     &modes);

  /**
   * Choose among the equivalent shapes of modes: of a pair whose eigenvalues
   * are equal to @p tolerance, the first moves the body at the contact point,
   * the second does not; and the motion there is positive, so that shapes do
   * not depend on the random start.
   */
  void align_pairs(const std::vector<ModeCharacter> &characters,
                   const MeasuringPoint             &contact,
                   const double                      tolerance,
                   StructuralModes                  &modes);
} // namespace RollingContact

#endif
