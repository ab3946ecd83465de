#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/vibration/vibrations.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /// vibrations that the whole bodies answer side by side: more gain little,
    /// and each keeps matrices of its own
    const std::size_t at_once = 8;
  } // namespace

  LinearContactOptions linear_contact_options(const Situation &scene)
  {
    LinearContactOptions options;
    options.speed    = std::abs(scene.contact.rolling_speed());
    options.friction = scene.inputs->friction_response();
    options.memory   = scene.contact.friction_memory;
    return options;
  }

  Vibrations::Vibrations(const Situation      &scene,
                         ReducedPair           reduced,
                         const ContactProblem &problem,
                         const ContactState   &state)
    : lowest(2 * pi * scene.inputs->stability.lowest_frequency)
    , highest(2 * pi * scene.inputs->modes.maximum_frequency)
    , pair(std::move(reduced))
    , linear(linear_contact(problem, state, linear_contact_options(scene)))
    , pencil(pair, linear)
    , all(pencil.eigenvalues())
  {
    options.damping_margin = scene.inputs->stability.damping_margin;
  }

  bool Vibrations::is_looked_at(const std::complex<double> s) const
  {
    return s.imag() >= lowest && s.imag() <= highest;
  }

  std::size_t Vibrations::n_unstable(const double least_growth) const
  {
    return std::count_if(all.begin(), all.end(), [&](const auto &s) {
      return is_looked_at(s) && s.real() > least_growth;
    });
  }

  ComplexValues Vibrations::least_damped(const std::size_t n_stable) const
  {
    ComplexValues found;
    std::copy_if(all.begin(),
                 all.end(),
                 std::back_inserter(found),
                 [&](const auto &s) { return is_looked_at(s); });
    std::sort(found.begin(), found.end(), [](const auto &a, const auto &b) {
      return a.real() / std::abs(a) > b.real() / std::abs(b);
    });
    found.resize(std::min(found.size(), n_unstable() + n_stable));
    return found;
  }

  std::vector<double> Vibrations::real_growth() const
  {
    std::vector<double> growth;
    for (const auto &s : all)
      if (s.imag() == 0. && s.real() > 0.)
        growth.push_back(s.real());
    return growth;
  }

  template <int dim>
  std::vector<Finding> Vibrations::find(const ComplexValues    &eigenvalues,
                                        const WholeBodies<dim> *bodies) const
  {
    std::vector<Finding> findings;
    for (std::size_t first = 0; first < eigenvalues.size(); first += at_once)
      {
        throw_if_interrupted();
        std::vector<StabilityMode> modes;
        for (std::size_t k = first;
             k < std::min(first + at_once, eigenvalues.size());
             ++k)
          modes.push_back(pencil.mode(eigenvalues[k]));
        std::vector<CorrectedMode> corrected;
        if (bodies != nullptr)
          corrected = correct(
            pair,
            linear,
            modes,
            [&](const auto &s, const auto &forces) {
              return bodies->response(s, forces);
            },
            options);
        for (std::size_t k = 0; k < modes.size(); ++k)
          {
            findings.push_back({modes[k], {}});
            if (bodies != nullptr)
              findings.back().corrected = corrected[k];
          }
      }
    return findings;
  }

  template std::vector<Finding> Vibrations::find(const ComplexValues &,
                                                 const WholeBodies<2> *) const;
  template std::vector<Finding> Vibrations::find(const ComplexValues &,
                                                 const WholeBodies<3> *) const;
} // namespace RollingContact
