#include <rolling_contact/bodies/split_vibration.h>

namespace RollingContact
{
  namespace
  {
    using Complex = std::complex<double>;
  }

  SplitVibration::SplitVibration(SplitCompliance    parts,
                                 const BodyDamping &damping)
    : parts(std::move(parts))
    , alpha(damping.mass_damping)
    , tau(damping.retardation())
  {}

  DenseMatrix
  SplitVibration::of_modes(const DenseMatrix         &motions,
                           const std::vector<double> &eigenvalues) const
  {
    DenseMatrix moments = parts.fields.F.transpose() * motions;
    moments += parts.inertia.loads.transpose() * motions *
               as_vector(eigenvalues).asDiagonal();
    return parts.Phi * moments;
  }

  ComplexVector SplitVibration::load(const Complex        s,
                                     const ComplexVector &forces) const
  {
    const ComplexVector m = parts.Phi.transpose() * forces;
    return parts.fields.F * m - rate_of_inertia(s) * (parts.inertia.loads * m);
  }

  ComplexVector SplitVibration::of_nodes(const Complex        s,
                                         const ComplexVector &forces,
                                         const ComplexVector &x) const
  {
    const Complex       r = rate_of_inertia(s), stiffer = stiffening(s);
    const ComplexVector m      = parts.Phi.transpose() * forces;
    ComplexVector       within = parts.fields.Q * m - parts.S * m;
    within -= r * (parts.inertia.mutual * m);
    ComplexVector t = within / stiffer + parts.fields.F.transpose() * x;
    t -= r * (parts.inertia.loads.transpose() * x);
    return parts.W * forces / stiffer + parts.Phi * t;
  }

  ComplexVector SplitVibration::of_body(const Complex        s,
                                        const ComplexVector &forces,
                                        const ComplexVector &x) const
  {
    const ComplexVector m = parts.Phi.transpose() * forces;
    return x + parts.inertia.at_nodes * m / stiffening(s);
  }
} // namespace RollingContact
