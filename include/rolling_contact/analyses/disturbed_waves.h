#ifndef rolling_contact_analyses_disturbed_waves_h
#define rolling_contact_analyses_disturbed_waves_h

#include <rolling_contact/run/log.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/stability/wave_sweep.h>
#include <rolling_contact/state/steady_state.h>
#include <rolling_contact/vibration/rolling_modes.h>

#include <optional>
#include <vector>

namespace RollingContact
{
  /** Elements that a wave must have at least. */
  inline constexpr double least_elements_of_wave = 4.;

  /** The bodies that waves find at a speed: losses as they are at the
   * frequency of the wave. Units: m/s. */
  RollingConditions conditions_of_waves(const Situation &scene,
                                        const double     speed);

  /** Waves over a steady state at some speeds. Units: m/s. */
  WaveSweep waves_over(const Situation                &scene,
                       const ContactProblem           &problem,
                       const ContactState             &state,
                       const std::vector<double>      &speeds,
                       const WaveSweep::BodiesAtSpeed &bodies);

  /** Waves over the states on every second node that are found. */
  template <int dim>
  std::vector<WaveSweep>
  waves_over_halves(const Situation                &scene,
                    SteadyState<dim>               &steady,
                    const std::vector<double>      &speeds,
                    const WaveSweep::BodiesAtSpeed &bodies);

  /**
   * How far what waves do may be off by the elements of the patch, from its
   * values with elements of twice the length at several places of the mesh: by
   * how much their mean differs, as they are of first order, and half of the
   * largest scatter about it, as the place of a mesh counts half as much with
   * elements half as long. None without values.
   */
  std::optional<double>
  uncertainty_by_halves(const double value, const std::vector<double> &halves);

  /** Warns that no state with elements of twice the length was found. */
  void warn_of_unknown_halves(const std::string &quantity, Log &log);
} // namespace RollingContact

#endif
