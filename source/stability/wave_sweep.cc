#include <rolling_contact/stability/wave_sweep.h>

namespace RollingContact
{
  namespace
  {
    /**
     * A state that rolls @p ratio times as fast with friction that does not
     * depend on the speed: rows of sticking nodes have N_u and N_r times the
     * ratio, those of slipping ones N_v over it.
     */
    LinearContact times_as_fast(LinearContact contact, const double ratio)
    {
      const std::size_t n = contact.touching.size();
      for (std::size_t c = 0; c < contact.n_tangential; ++c)
        for (std::size_t k = 0; k < n; ++k)
          {
            const std::size_t row = n + c * n + k;
            if (contact.slips[k])
              contact.N_v.row(row) /= ratio;
            else
              {
                contact.N_u.row(row) *= ratio;
                contact.N_r.row(row) *= ratio;
              }
          }
      return contact;
    }
  } // namespace

  WaveSweep::AtSpeed::AtSpeed(const ContactProblem &problem,
                              const ContactState   &state,
                              LinearContact         linear,
                              const double          speed,
                              ReducedPair           bodies,
                              const double          thickness,
                              const AtSpeed        *other)
    : contact(std::move(linear))
    , pair(std::move(bodies))
    , growth(problem, state, contact, pair, speed, thickness)
    , motions(other != nullptr ? other->motions
                               : WaveResponse::motions_of(pair))
    , response(contact, pair, speed, growth.along(), motions)
    , punch_x(growth.punch_forces(0), pair, motions)
    , punch_z(growth.punch_forces(contact.n_tangential), pair, motions)
  {}

  WaveSweep::Punch::Punch(const std::vector<double> &forces,
                          const ReducedPair         &pair,
                          const DenseMatrix         &motions)
    : at_rest(as_vector(forces).dot(pair.W_res * as_vector(forces)))
    , on_motions(motions.transpose() * as_vector(forces))
  {}

  std::complex<double>
  WaveSweep::Punch::receptance(const WaveResponse::AtWave &at) const
  {
    return at_rest / at.retardation() +
           (on_motions.transpose() * at.response_of_motions() * on_motions)
             .value();
  }

  PassedWave WaveSweep::AtSpeed::passed(const double                wave_number,
                                        const WaveResponse::AtWave &at,
                                        const WaveAnswer &answer) const
  {
    PassedWave result;
    result.growth       = growth.growth(answer, wave_number);
    result.load         = growth.load(answer.unknowns);
    const auto whole    = at.unknowns(response.height_wave(0.));
    result.filter       = std::abs(result.load) / std::abs(growth.load(whole));
    result.receptance_x = punch_x.receptance(at);
    result.receptance_z = punch_z.receptance(at);
    return result;
  }

  WaveSweep::WaveSweep(const ContactProblem       &problem,
                       const ContactState         &state,
                       const LinearContactOptions &options,
                       const double                thickness,
                       const std::vector<double>  &speeds,
                       const BodiesAtSpeed        &bodies)
  {
    LinearContactOptions at_first = options;
    at_first.speed                = speeds.at(0);
    for (const double speed : speeds)
      cases.push_back(std::make_unique<const AtSpeed>(
        problem,
        state,
        cases.empty() ? linear_contact(problem, state, at_first)
                      : times_as_fast(contact(), speed / speeds[0]),
        speed,
        bodies(speed),
        thickness,
        cases.empty() ? nullptr : cases.front().get()));
  }

  std::vector<ModalFactors> WaveSweep::modal(const double wave_number) const
  {
    std::vector<ModalFactors> result;
    for (const auto &it : cases)
      result.push_back(it->response.modal(wave_number));
    return result;
  }

  std::vector<PassedWave>
  WaveSweep::at(const double                     wave_number,
                const std::vector<ModalFactors> &modal) const
  {
    const auto factors = cases.front()->response.factors(wave_number);
    std::vector<PassedWave> result;
    for (std::size_t v = 0; v < cases.size(); ++v)
      {
        const WaveResponse        &response = cases[v]->response;
        const WaveResponse::AtWave at(response,
                                      wave_number,
                                      factors,
                                      modal.at(v));
        result.push_back(cases[v]->passed(
          wave_number, at, at.answer(response.height_wave(wave_number))));
      }
    return result;
  }

  WaveAnswer WaveSweep::answer(const double      wave_number,
                               const std::size_t speed) const
  {
    const WaveResponse        &response = cases.at(speed)->response;
    const auto                 factors  = response.factors(wave_number);
    const WaveResponse::AtWave at(response,
                                  wave_number,
                                  factors,
                                  response.modal(wave_number));
    return at.answer(response.height_wave(wave_number));
  }

  std::vector<WaveResponse::Reaction>
  WaveSweep::reactions(const double                    wave_number,
                       const Waves                    &waves,
                       const std::vector<std::size_t> &at_speeds) const
  {
    const auto          factors = cases.front()->response.factors(wave_number);
    const ComplexMatrix b       = waves(cases.front()->growth, wave_number);
    std::vector<WaveResponse::Reaction> result;
    for (const std::size_t v : at_speeds)
      result.push_back(cases.at(v)->response.reaction(wave_number, factors, b));
    return result;
  }

  PassedWave WaveSweep::corrected(const double        wave_number,
                                  const std::size_t   speed,
                                  const BodyResponse &bodies,
                                  const unsigned int  n_steps) const
  {
    const AtSpeed             &it      = *cases.at(speed);
    const auto                 factors = it.response.factors(wave_number);
    const WaveResponse::AtWave at(it.response,
                                  wave_number,
                                  factors,
                                  it.response.modal(wave_number));
    return it.passed(wave_number,
                     at,
                     at.corrected(it.response.height_wave(wave_number),
                                  bodies,
                                  n_steps));
  }
} // namespace RollingContact
