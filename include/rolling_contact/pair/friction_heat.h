#ifndef rolling_contact_pair_friction_heat_h
#define rolling_contact_pair_friction_heat_h

#include <rolling_contact/contact/contact_state.h>
#include <rolling_contact/scene/hot_friction.h>
#include <rolling_contact/scene/pair_spec.h>

#include <optional>
#include <vector>

namespace RollingContact
{
  struct ContactProblem;

  /**
   * Rise of the temperature of the surfaces at the nodes that the friction of a
   * steady state makes, above contact_temperature(), after
   * References::moving_heat_source(): the heat -q . s V of the slip in the mean
   * around each node flows along the lines of flow into both half-spaces, which
   * pass at the rolling speed V and share it as their effusivities sqrt(k rho
   * c), so that both are as hot where conduction along the surface does not
   * count; none flows from line to line. Empty without friction, without
   * Contact/Speed, and for a time step. Units: K.
   */
  std::vector<double> flash_temperature(const PairSpec       &scene,
                                        const ContactProblem &problem,
                                        const ContactState   &state);

  /**
   * The largest of nodal temperatures and their mean over the patch. Units: K.
   */
  struct PatchTemperature
  {
    double largest = 0., mean = 0.;
  };

  /**
   * The flash_temperature() of a state; none where that is empty.
   */
  std::optional<PatchTemperature>
  patch_temperature(const PairSpec       &scene,
                    const ContactProblem &problem,
                    const ContactState   &state);

  /**
   * The temperature that the surfaces have where they touch without friction:
   * that of both bodies in the mean, weighted by their effusivities, at once,
   * as for two half-spaces that are brought together. Units: K.
   */
  double contact_temperature(const PairSpec &scene);

  /**
   * Heat that flows into the bodies. Units: W.
   */
  struct HeatFlows
  {
    double wheel = 0., rail = 0.;
  };

  /**
   * The shares of a friction power (W) that flow into both bodies, by their
   * effusivities e, and the heat that flows from the hotter body into the
   * colder one while they touch,
   *
   *     2 e_w e_r/(e_w + e_r) (T_w - T_r) sqrt(V/pi) sum of width sqrt(length).
   *
   * The sum is over the lines of flow that touch, from end to end; the areas of
   * the nodes give their widths.
   */
  HeatFlows heat_flows(const PairSpec       &scene,
                       const ContactProblem &problem,
                       const ContactState   &state,
                       const double          power);

  /**
   * mu of each node where it follows the temperature of the surfaces: that of
   * the scene at each node, @p cold, times the share of the @p law. @p rise is
   * the flash temperature, K.
   */
  std::vector<double> hot_friction(const PairSpec            &scene,
                                   const HotFriction         &law,
                                   const std::vector<double> &cold,
                                   const std::vector<double> &rise);
} // namespace RollingContact

#endif
