#include <rolling_contact/analyses/disturbed_waves.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/contact/resultants.h>
#include <rolling_contact/state/estimate_errors.h>
#include <rolling_contact/vibration/vibrations.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace RollingContact
{
  RollingConditions conditions_of_waves(const Situation &scene,
                                        const double     speed)
  {
    RollingConditions conditions(scene, scene.inputs->stability);
    if (scene.inputs->stability.rotation)
      conditions.speed = scene.contact.flow() * speed;
    conditions.hysteretic = true;
    return conditions;
  }

  WaveSweep waves_over(const Situation                &scene,
                       const ContactProblem           &problem,
                       const ContactState             &state,
                       const std::vector<double>      &speeds,
                       const WaveSweep::BodiesAtSpeed &bodies)
  {
    return WaveSweep(problem,
                     state,
                     linear_contact_options(scene),
                     scene.inputs->dimension == 2 ? scene.thickness() : 1.,
                     speeds,
                     bodies);
  }

  template <int dim>
  std::vector<WaveSweep>
  waves_over_halves(const Situation                &scene,
                    SteadyState<dim>               &steady,
                    const std::vector<double>      &speeds,
                    const WaveSweep::BodiesAtSpeed &bodies)
  {
    std::vector<WaveSweep> result;
    make_halves(scene, steady);
    for (HalvedProblem &half : steady.halves)
      try
        {
          const auto state =
            state_of_half(scene, steady.problem, steady.state, half);
          if (state && resultants(half.problem, *state).n_touching > 0)
            result.push_back(waves_over(
              scene, half.problem, *state, speeds, [&](const double speed) {
                return at_nodes(bodies(speed), half.coupling);
              }));
        }
      catch (const ConvergenceError &)
        {} // it tells nothing of errors
    return result;
  }

  std::optional<double> uncertainty_by_halves(const double               value,
                                              const std::vector<double> &halves)
  {
    if (halves.empty())
      return {};
    const double n    = halves.size(),
                 mean = std::accumulate(halves.begin(), halves.end(), 0.) / n;
    double scatter    = 0.;
    for (const double it : halves)
      scatter = std::max(scatter, std::abs(it - mean));
    return std::abs(value - mean) + scatter / 2;
  }

  void warn_of_unknown_halves(const std::string &quantity, Log &log)
  {
    log.warning("How far " + quantity +
                " is off by the elements across the patch is not known: no "
                "state with elements of twice the length was found. Take more "
                "Mesh/Elements across patch.");
  }

  template std::vector<WaveSweep>
  waves_over_halves(const Situation &,
                    SteadyState<2> &,
                    const std::vector<double> &,
                    const WaveSweep::BodiesAtSpeed &);
  template std::vector<WaveSweep>
  waves_over_halves(const Situation &,
                    SteadyState<3> &,
                    const std::vector<double> &,
                    const WaveSweep::BodiesAtSpeed &);
} // namespace RollingContact
