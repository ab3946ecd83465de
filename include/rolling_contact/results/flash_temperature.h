#ifndef rolling_contact_results_flash_temperature_h
#define rolling_contact_results_flash_temperature_h

#include <rolling_contact/scene/pair_spec.h>

#include <vector>

namespace RollingContact
{
  /**
   * Rise of the temperature of the surfaces at the nodes that the friction of a
   * steady state makes, above that of the bodies, after
   * References::moving_heat_source(): the heat -q . s V of the slip in the mean
   * around each node flows along the lines of flow into both half-spaces, which
   * pass at the rolling speed V and share it as sqrt(k rho c), so that both are
   * as hot where conduction along the surface does not count; none flows from
   * line to line. No coupling back. Empty without friction, without
   * Contact/Speed, and for a time step. Units: K.
   */
  std::vector<double> flash_temperature(const PairSpec       &scene,
                                        const ContactProblem &problem,
                                        const ContactState   &state);
} // namespace RollingContact

#endif
