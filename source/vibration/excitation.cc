#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/vibration/excitation.h>

#include <cmath>

namespace RollingContact
{
  namespace
  {
    using Complex = std::complex<double>;
  } // namespace

  Excitation::Excitation(const ReducedPair   &pair,
                         const LinearContact &contact,
                         const StabilityMode &mode,
                         const double         velocity)
    : s(mode.s)
    , modal(mode.modal)
    , forces(contact.forces * mode.unknowns / (1. + s * pair.retardation))
  {
    const ComplexVector u       = pair.Phi * modal + pair.W_res * forces;
    Complex             largest = 0.;
    for (const unsigned int node : contact.touching)
      for (unsigned int c = 0; c <= contact.n_tangential; ++c)
        {
          const Complex at = s * u[c * contact.n_nodes + node];
          if (std::abs(at) > std::abs(largest))
            largest = at;
        }
    if (!(std::abs(largest) > 0.))
      throw InputError("The vibration at " + significant(mode.frequency(), 5) +
                       " Hz does not move the contact; excite another one.");
    const Complex factor = velocity / largest;
    modal *= factor;
    forces *= factor;
    const Eigen::Index n_nodal =
      (contact.n_tangential + 1) * contact.touching.size();
    if (mode.unknowns.size() > n_nodal) // friction with a memory
      friction_share = factor * mode.unknowns[n_nodal];
  }

  void Excitation::add_to(ReducedState &state, const double h) const
  {
    as_vector(state.eta) += modal.real();
    as_vector(state.rate) += (s * modal).real();
    const Complex before  = std::exp(-s * h / 2.),
                  earlier = before * std::exp(-s * h);
    as_vector(state.forces) += (before * forces).real();
    as_vector(state.forces_before) += (earlier * forces).real();
  }

  double Excitation::friction(const double time) const
  {
    return (friction_share * std::exp(s * time)).real();
  }

  std::complex<double> vibration_near(const ComplexValues &eigenvalues,
                                      const double         frequency,
                                      const std::string   &entry)
  {
    const Complex wanted(0., 2 * pi * frequency);
    Complex       growing = 0., any = 0.;
    for (const Complex &s : eigenvalues)
      {
        if (s.imag() <= 0.)
          continue;
        if (any == 0. || std::abs(s - wanted) < std::abs(any - wanted))
          any = s;
        if (s.real() > 0. &&
            (growing == 0. || std::abs(s.imag() - wanted.imag()) <
                                std::abs(growing.imag() - wanted.imag())))
          growing = s;
      }
    if (any == 0.)
      throw InputError(entry + " = " + significant(frequency, 6) +
                       " Hz: the bodies have no vibrations; raise "
                       "Modes/Maximum frequency, or leave it at 0.");
    return growing != 0. ? growing : any;
  }
} // namespace RollingContact
