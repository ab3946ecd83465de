#include <rolling_contact/stability/wave_sweep.h>

namespace RollingContact
{
  WaveSweep::AtSpeed::AtSpeed(const ContactProblem       &problem,
                              const ContactState         &state,
                              const LinearContactOptions &options,
                              ReducedPair                 bodies,
                              const double                thickness)
    : contact(linear_contact(problem, state, options))
    , pair(std::move(bodies))
    , growth(problem, state, contact, pair, options.speed, thickness)
    , response(contact, pair, options.speed, growth.along())
  {}

  PassedWave WaveSweep::AtSpeed::passed(const double                wave_number,
                                        const WaveResponse::AtWave &at,
                                        const WaveAnswer &answer) const
  {
    PassedWave result;
    result.growth    = growth.growth(answer, wave_number, 1.);
    result.load      = growth.load(answer);
    const auto whole = at.answer(response.height_wave(0.));
    result.filter    = std::abs(result.load) / std::abs(growth.load(whole));
    const auto receptance = [&](const unsigned int component) {
      const std::vector<double> forces = growth.punch_forces(component);
      const auto                punch  = as_vector(forces);
      return (punch.transpose() *
              at.motion_under(punch.cast<std::complex<double>>()))
        .value();
    };
    result.receptance_x = receptance(0);
    result.receptance_z = receptance(contact.n_tangential);
    return result;
  }

  WaveSweep::WaveSweep(const ContactProblem       &problem,
                       const ContactState         &state,
                       const LinearContactOptions &options,
                       const double                thickness,
                       const std::vector<double>  &speeds,
                       const BodiesAtSpeed        &bodies)
  {
    for (const double speed : speeds)
      {
        LinearContactOptions at_speed = options;
        at_speed.speed                = speed;
        cases.push_back(std::make_unique<const AtSpeed>(
          problem, state, at_speed, bodies(speed), thickness));
      }
  }

  std::vector<PassedWave> WaveSweep::at(const double wave_number) const
  {
    const auto factors = cases.front()->response.factors(wave_number);
    std::vector<PassedWave> result;
    for (const auto &it : cases)
      {
        const WaveResponse::AtWave at(it->response, wave_number, factors);
        result.push_back(it->passed(
          wave_number, at, at.answer(it->response.height_wave(wave_number))));
      }
    return result;
  }

  PassedWave WaveSweep::corrected(const double        wave_number,
                                  const std::size_t   speed,
                                  const BodyResponse &bodies,
                                  const unsigned int  n_steps) const
  {
    const AtSpeed             &it      = *cases.at(speed);
    const auto                 factors = it.response.factors(wave_number);
    const WaveResponse::AtWave at(it.response, wave_number, factors);
    return it.passed(wave_number,
                     at,
                     at.corrected(it.response.height_wave(wave_number),
                                  bodies,
                                  n_steps));
  }
} // namespace RollingContact
