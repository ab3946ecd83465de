#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/stability/contact_response.h>

#include <algorithm>

namespace RollingContact
{
  ResidualContact::ResidualContact(const LinearContact &contact,
                                   const ReducedPair   &pair)
    : statics(contact.N_u * (pair.W_res * contact.forces))
    , viscosity(contact.N_v * (pair.W_res * contact.forces))
  {
    statics += contact.N_r;
    viscosity += contact.N_s;
    const unsigned int n = contact.n_tractions();
    viscosity.leftCols(n) += pair.retardation * contact.N_r.leftCols(n);
  }

  ContactResponse::ContactResponse(const LinearContact &contact,
                                   const ReducedPair   &pair,
                                   const DenseMatrix   &U)
    : residual(contact, pair)
    , motion(contact.N_u * U)
    , velocity(contact.N_v * U)
    , retardation(pair.retardation)
    , reaction((U.transpose() * contact.forces).cast<std::complex<double>>())
  {
    scale_rows();
  }

  void ContactResponse::scale_rows()
  {
    const double rate    = 1e4; // of squeal, 1/s
    DenseMatrix &statics = residual.statics, &viscosity = residual.viscosity;
    for (Eigen::Index i = 0; i < statics.rows(); ++i)
      {
        const double largest = statics.row(i)
                                 .cwiseAbs()
                                 .cwiseMax(rate * viscosity.row(i).cwiseAbs())
                                 .maxCoeff();
        for (DenseMatrix *M : {&statics, &viscosity, &motion, &velocity})
          if (largest > 0.)
            M->row(i) /= largest;
      }
  }

  ComplexMatrix ContactResponse::operator()(const std::complex<double> s) const
  {
    ComplexMatrix driven = motion + s * velocity;
    ComplexLU(residual.statics + s * residual.viscosity).solve(driven);
    return -(1. + s * retardation) * reaction * driven;
  }

  ComplexValues ContactResponse::poles(const double shift) const
  {
    const double at_infinity = 1e-9; // of the nearest pole
    DenseMatrix  shifted     = residual.statics + shift * residual.viscosity,
                inverse      = residual.viscosity;
    solve_general(shifted, inverse);
    const ComplexValues values = eigenvalues(std::move(inverse));
    ComplexValues       finite;
    double              largest = 0.;
    for (const auto &value : values)
      largest = std::max(largest, std::abs(value));
    for (const auto &value : values)
      if (std::abs(value) > at_infinity * largest)
        finite.push_back(shift - 1. / value);
    return finite;
  }
} // namespace RollingContact
