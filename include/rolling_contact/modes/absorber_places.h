#ifndef rolling_contact_modes_absorber_places_h
#define rolling_contact_modes_absorber_places_h

#include <rolling_contact/algebra/factorisation.h>
#include <rolling_contact/modes/absorbers.h>
#include <rolling_contact/modes/mode_character.h>

#include <string>

namespace RollingContact
{
  /**
   * Where rings of absorbers hang on a body of revolution: on the circles of
   * its nodes that are nearest to them, by weighted means over those. Fourier
   * series end at the most nodal diameters that the modes have, that n
   * absorbers tell apart, and that the nodes do. @p factor: of K + shift M,
   * with which compliances are taken. Throws InputError, naming @p section, if
   * there is no circle within a tenth of the body's radius. The @p notes say
   * which circles were taken.
   */
  AbsorberPlaces absorber_places(const std::vector<AbsorberRing>  &rings,
                                 const std::string                &section,
                                 const BodyPlaces                 &places,
                                 const Axle                       &axle,
                                 const StructuralModes            &modes,
                                 const std::vector<ModeCharacter> &characters,
                                 const Factorisation              &factor,
                                 const double                      shift,
                                 std::vector<std::string>         &notes);
} // namespace RollingContact

#endif
