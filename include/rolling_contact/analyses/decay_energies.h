#ifndef rolling_contact_analyses_decay_energies_h
#define rolling_contact_analyses_decay_energies_h

#include <rolling_contact/analyses/receptance_parameters.h>
#include <rolling_contact/modes/track_decay.h>
#include <rolling_contact/vibration/vibrating_body.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace RollingContact
{
  /** A direction that a rail is struck and moves in. */
  struct DecayDirection
  {
    unsigned int axis;
    std::string  name;
  };

  extern const std::array<DecayDirection, 2> decay_directions;

  /**
   * How a rail that is struck at its contact point moves there and along its
   * running surface.
   */
  class DecayEnergies
  {
  public:
    virtual ~DecayEnergies() = default;

    /**
     * |s A|^2 at all places of a grid, one of decay_directions after the other,
     * A the receptance. Units: Hz, m^2/(N s)^2.
     */
    virtual std::vector<double> at(const double frequency) = 0;

    /** Say what was continued, and warn where that is doubtful. */
    virtual void tell(Log &) const
    {}
  };

  /**
   * Energies of a rail without ends by its waves, to any distance, or of one
   * that ends by its modes, which waves fitted to them continue beyond its
   * absorbing ends. Keeps references. Throws InputError for a mesh that is no
   * straight rail of one section or too short.
   */
  std::unique_ptr<DecayEnergies>
  decay_energies(const VibratingBody<3>     &rail,
                 const DecayGrid            &grid,
                 const ReceptanceParameters &section);

  /** The middle of forces along an axis, at the nodes of a body. Units: m. */
  std::array<double, 3> middle_of(const BodyPlaces      &places,
                                  const unsigned int     axis,
                                  const Eigen::VectorXd &forces);
} // namespace RollingContact

#endif
