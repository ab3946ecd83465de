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

    /** M x of a real matrix. */
    ComplexVector
    product(const DenseMatrix &M, const ComplexVector &x)
    {
      ComplexVector y(M.n_rows(), 0.);
      for (std::size_t j = 0; j < x.size(); ++j)
        for (std::size_t i = 0; i < y.size(); ++i)
          y[i] += M(i, j) * x[j];
      return y;
    }
  } // namespace



  Excitation::Excitation(const ReducedPair   &pair,
                         const LinearContact &contact,
                         const StabilityMode &mode,
                         const double         velocity)
    : s(mode.s)
    , modal(mode.modal)
    , forces(product(contact.forces, mode.unknowns))
  {
    const ComplexVector by_modes = product(pair.Phi, modal),
                        residual = product(pair.W_res, forces);
    Complex largest              = 0.;
    for (const unsigned int node : contact.touching)
      for (unsigned int c = 0; c <= contact.n_tangential; ++c)
        {
          const std::size_t i  = c * contact.n_nodes + node;
          const Complex     at = s * (by_modes[i] + residual[i]);
          if (std::abs(at) > std::abs(largest))
            largest = at;
        }
    if (!(std::abs(largest) > 0.))
      throw InputError("The vibration at " + significant(mode.frequency(), 5) +
                       " Hz does not move the contact; excite another one.");
    const Complex factor = velocity / largest;
    for (Complex &value : modal)
      value *= factor;
    for (Complex &value : forces)
      value *= factor;
    const std::size_t n_nodal =
      (contact.n_tangential + 1) * contact.touching.size();
    if (mode.unknowns.size() > n_nodal) // friction with a memory
      friction_share = factor * mode.unknowns[n_nodal];
  }



  void
  Excitation::add_to(ReducedState &state, const double h) const
  {
    for (std::size_t k = 0; k < modal.size(); ++k)
      {
        state.eta[k] += modal[k].real();
        state.rate[k] += (s * modal[k]).real();
      }
    const Complex before  = std::exp(-s * h / 2.),
                  earlier = before * std::exp(-s * h);
    for (std::size_t i = 0; i < forces.size(); ++i)
      {
        state.forces[i] += (before * forces[i]).real();
        state.forces_before[i] += (earlier * forces[i]).real();
      }
  }



  double
  Excitation::friction(const double time) const
  {
    return (friction_share * std::exp(s * time)).real();
  }



  std::complex<double>
  vibration_near(const ComplexVector &eigenvalues,
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
