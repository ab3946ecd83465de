#include <rolling_contact/analyses/vibrations.h>
#include <rolling_contact/base/constants.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    LinearContactOptions
    options_of(const SceneParameters &scene)
    {
      LinearContactOptions options;
      options.speed    = std::abs(scene.contact.rolling_speed());
      options.friction = scene.friction_response();
      options.memory   = scene.contact.friction_delay;
      return options;
    }
  } // namespace



  Vibrations::Vibrations(const SceneParameters &scene,
                         ReducedPair            reduced,
                         const ContactProblem  &problem,
                         const ContactState    &state)
    : lowest(2 * pi * scene.stability.lowest_frequency)
    , highest(2 * pi * scene.modes.maximum_frequency)
    , pair(std::move(reduced))
    , linear(linear_contact(problem, state, options_of(scene)))
    , pencil(pair, linear)
    , all(pencil.eigenvalues())
  {
    options.damping_margin = scene.stability.damping_margin;
  }



  bool
  Vibrations::is_looked_at(const std::complex<double> s) const
  {
    return s.imag() >= lowest && s.imag() <= highest;
  }



  std::size_t
  Vibrations::n_unstable(const double least_growth) const
  {
    return std::count_if(all.begin(), all.end(), [&](const auto &s) {
      return is_looked_at(s) && s.real() > least_growth;
    });
  }



  ComplexVector
  Vibrations::least_damped(const std::size_t n_stable) const
  {
    ComplexVector found;
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



  std::vector<double>
  Vibrations::real_growth() const
  {
    std::vector<double> growth;
    for (const auto &s : all)
      if (s.imag() == 0. && s.real() > 0.)
        growth.push_back(s.real());
    return growth;
  }



  template <int dim>
  Finding
  Vibrations::find(const std::complex<double> s,
                   const WholeBodies<dim>    *bodies) const
  {
    Finding finding{pencil.mode(s), {}};
    if (bodies != nullptr)
      finding.corrected = correct(
        pair,
        linear,
        finding.mode,
        [&](const std::complex<double> at, const ComplexVector &forces) {
          return bodies->response(at, forces);
        },
        options);
    return finding;
  }



  template Finding
  Vibrations::find(const std::complex<double>, const WholeBodies<2> *) const;
  template Finding
  Vibrations::find(const std::complex<double>, const WholeBodies<3> *) const;
} // namespace RollingContact
