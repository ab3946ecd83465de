#include <rolling_contact/linear_algebra/dense_eigenvalues.h>
#include <rolling_contact/stability/contact_response.h>

#include <algorithm>

namespace RollingContact
{
  ContactResponse::ContactResponse(const LinearContact &contact,
                                   const DenseMatrix   &W_res,
                                   const DenseMatrix   &U)
    : statics(contact.N_u * (W_res * contact.forces))
    , viscosity(contact.N_v * (W_res * contact.forces))
    , motion(contact.N_u * U)
    , velocity(contact.N_v * U)
    , reaction(transposed(U) * contact.forces)
  {
    const std::size_t n = contact.n_unknowns();
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i)
        {
          statics(i, j) += contact.N_r(i, j);
          viscosity(i, j) += contact.N_s(i, j);
        }
    scale_rows();
  }



  void
  ContactResponse::scale_rows()
  {
    const double rate = 1e4; // of squeal, 1/s
    for (std::size_t i = 0; i < statics.n_rows(); ++i)
      {
        double largest = 0.;
        for (std::size_t j = 0; j < statics.n_columns(); ++j)
          largest = std::max({largest,
                              std::abs(statics(i, j)),
                              rate * std::abs(viscosity(i, j))});
        for (DenseMatrix *M : {&statics, &viscosity, &motion, &velocity})
          for (std::size_t j = 0; j < M->n_columns() && largest > 0.; ++j)
            (*M)(i, j) /= largest;
      }
  }



  ComplexMatrix
  ContactResponse::operator()(const std::complex<double> s) const
  {
    const ComplexLU factors(ComplexMatrix(statics, s, viscosity));
    ComplexMatrix   driven(motion, s, velocity);
    factors.solve(driven);
    ComplexMatrix G = reaction * driven;
    for (std::size_t k = 0; k < G.n_rows() * G.n_columns(); ++k)
      G.data()[k] *= -1.;
    return G;
  }



  ComplexVector
  ContactResponse::poles(const double shift) const
  {
    const double at_infinity = 1e-9; // of the nearest pole
    DenseMatrix  shifted = statics, inverse = viscosity;
    for (std::size_t k = 0; k < shifted.n_rows() * shifted.n_rows(); ++k)
      shifted.data()[k] += shift * viscosity.data()[k];
    solve_general(shifted, inverse);
    const ComplexVector values = eigenvalues(std::move(inverse));
    ComplexVector       finite;
    double              largest = 0.;
    for (const auto &value : values)
      largest = std::max(largest, std::abs(value));
    for (const auto &value : values)
      if (std::abs(value) > at_infinity * largest)
        finite.push_back(shift - 1. / value);
    return finite;
  }
} // namespace RollingContact
