#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/linear_algebra/dense_eigenvalues.h>
#include <rolling_contact/stability/pencil.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  double
  StabilityMode::frequency() const
  {
    return std::abs(s.imag()) / (2 * pi);
  }



  double
  StabilityMode::damping_ratio() const
  {
    return s == 0. ? 0. : -s.real() / std::abs(s);
  }



  std::vector<double>
  StabilityMode::participation() const
  {
    std::vector<double> shares;
    for (const auto &value : modal)
      shares.push_back(std::norm(value));
    return shares;
  }



  StabilityPencil::StabilityPencil(const ReducedPair   &pair,
                                   const LinearContact &contact)
    : n_modes(pair.n_modes())
  {
    const std::size_t n_x = contact.n_unknowns(), n = 2 * n_modes + n_x;
    if (pair.W_res.n_rows() != contact.forces.n_rows())
      throw InputError("The bodies have " +
                       std::to_string(pair.W_res.n_rows()) +
                       " displacements of the contact and the contact itself " +
                       std::to_string(contact.forces.n_rows()) +
                       ": both must have the same nodes.");
    A               = DenseMatrix(n, n);
    E               = DenseMatrix(n, n);
    double stiffest = 0.;
    for (std::size_t k = 0; k < n_modes; ++k)
      stiffest = std::max(stiffest, std::abs(pair.K_m(k, k)));
    if (stiffest > 0.)
      rate = 0.2 * std::sqrt(stiffest);
    add_bodies(pair, contact);
    add_contact(pair, contact);
  }



  void
  StabilityPencil::add_bodies(const ReducedPair   &pair,
                              const LinearContact &contact)
  {
    const std::size_t m       = n_modes;
    const DenseMatrix drive   = transposed(pair.Phi) * contact.forces;
    double            largest = 0.;
    for (std::size_t k = 0; k < drive.n_rows() * drive.n_columns(); ++k)
      largest = std::max(largest, std::abs(drive.data()[k]));
    scale = largest > 0. ? rate * rate / largest : 1.;
    for (std::size_t j = 0; j < m; ++j)
      {
        A(j, m + j) = E(j, j) = E(m + j, m + j) = 1.;
        for (std::size_t i = 0; i < m; ++i)
          {
            A(m + i, j)     = -pair.K_m(i, j) / (rate * rate);
            A(m + i, m + j) = -pair.C_m(i, j) / rate;
          }
      }
    for (std::size_t j = 0; j < contact.n_unknowns(); ++j)
      for (std::size_t i = 0; i < m; ++i)
        A(m + i, 2 * m + j) = drive(i, j) * scale / (rate * rate);
  }



  void
  StabilityPencil::add_contact(const ReducedPair   &pair,
                               const LinearContact &contact)
  {
    const std::size_t m = n_modes, n_x = contact.n_unknowns();
    const DenseMatrix motion    = contact.N_u * pair.Phi,
                      velocity  = contact.N_v * pair.Phi,
                      residual  = pair.W_res * contact.forces,
                      statics   = contact.N_u * residual,
                      viscosity = contact.N_v * residual;
    for (std::size_t i = 0; i < n_x; ++i)
      {
        const std::size_t row = 2 * m + i;
        for (std::size_t j = 0; j < m; ++j)
          {
            A(row, j)     = motion(i, j);
            A(row, m + j) = velocity(i, j) * rate;
          }
        for (std::size_t j = 0; j < n_x; ++j)
          {
            A(row, 2 * m + j) = (statics(i, j) + contact.N_r(i, j)) * scale;
            E(row, 2 * m + j) =
              -(viscosity(i, j) + contact.N_s(i, j)) * scale * rate;
          }
        double largest = 0.;
        for (std::size_t j = 0; j < size(); ++j)
          largest =
            std::max({largest, std::abs(A(row, j)), std::abs(E(row, j))});
        if (!(largest > 0.) || !std::isfinite(largest))
          throw InputError("Row " + std::to_string(i + 1) + " of " +
                           std::to_string(n_x) +
                           " of the linearised contact holds nothing, or an "
                           "entry that is no number.");
        for (std::size_t j = 0; j < size(); ++j)
          {
            A(row, j) /= largest;
            E(row, j) /= largest;
          }
      }
  }



  ComplexVector
  StabilityPencil::eigenvalues() const
  {
    const double at_infinity = 1e-9;
    double       shift       = 1.5;
    // E = P E_1 with its rows that are not zero: (A - shift E)^-1 P E_1 has the
    // eigenvalues of E_1 (A - shift E)^-1 P, which is smaller, and zeros
    std::vector<std::size_t> moving;
    for (std::size_t i = 0; i < size(); ++i)
      for (std::size_t j = 0; j < size(); ++j)
        if (E(i, j) != 0.)
          {
            moving.push_back(i);
            break;
          }
    DenseMatrix E_1(moving.size(), size()), P(size(), moving.size()), inverse;
    for (std::size_t k = 0; k < moving.size(); ++k)
      {
        P(moving[k], k) = 1.;
        for (std::size_t j = 0; j < size(); ++j)
          E_1(k, j) = E(moving[k], j);
      }
    for (bool solved = false; !solved; shift *= 1.37)
      {
        if (shift > 10.)
          throw InputError("The equations of bodies and contact are singular: "
                           "the contact does not determine its forces, as "
                           "where nodes have no compliance.");
        DenseMatrix shifted = A;
        for (std::size_t k = 0; k < size() * size(); ++k)
          shifted.data()[k] -= shift * E.data()[k];
        inverse = P;
        solved  = solve_general(shifted, inverse);
        if (solved)
          break;
      }
    const ComplexVector found   = RollingContact::eigenvalues(E_1 * inverse);
    double              largest = 0.;
    for (const auto &value : found)
      largest = std::max(largest, std::abs(value));
    ComplexVector values;
    for (const auto &value : found)
      if (std::abs(value) > at_infinity * largest && value.imag() <= 0.)
        {
          // of the inverse of a conjugate pair the lower one
          const std::complex<double> s = shift + 1. / value;
          values.push_back(
            rate * (value.imag() == 0. ? std::complex<double>(s.real()) : s));
        }
    std::sort(values.begin(), values.end(), [](const auto &a, const auto &b) {
      return a.real() != b.real() ? a.real() > b.real() : a.imag() < b.imag();
    });
    return values;
  }



  StabilityMode
  StabilityPencil::mode(const std::complex<double> s) const
  {
    StabilityMode mode;
    // a hair beside the eigenvalue, where the matrix is not singular
    const std::complex<double> shift = s / rate * (1. + 1e-10) + 1e-14;
    const ComplexLU            factors(ComplexMatrix(A, -shift, E));
    ComplexVector              x(size());
    for (std::size_t i = 0; i < size(); ++i)
      x[i] = std::polar(1., 2.4 * i); // of no symmetry
    std::complex<double> change = 0.;
    for (unsigned int step = 0; step < 3; ++step)
      {
        ComplexVector y = E * x;
        if (step == 0)
          y = x;
        const ComplexVector before = y;
        factors.solve(y);
        const double size = norm(y);
        // (A - shift E) y = E x, and y is about E's x over (s - shift)
        if (step > 0)
          {
            const ComplexVector image = E * y;
            change                    = dot(image, before) / dot(image, image);
          }
        for (auto &value : y)
          value /= size;
        x = y;
      }
    mode.s = rate * (shift + change);
    if (s.imag() == 0.)
      mode.s = mode.s.real();
    const ComplexVector left = A * x, right = E * x;
    ComplexVector       rest(size());
    double              largest = 0.;
    for (std::size_t i = 0; i < size(); ++i)
      {
        rest[i] = left[i] - mode.s / rate * right[i];
        largest = std::max(largest, std::abs(left[i]));
      }
    mode.residual = norm(rest) / largest;

    double modal = 0.;
    for (std::size_t k = 0; k < n_modes; ++k)
      modal += std::norm(x[k]);
    const double factor = modal > 0. ? 1 / std::sqrt(modal) : 1.;
    for (std::size_t k = 0; k < n_modes; ++k)
      mode.modal.push_back(x[k] * factor);
    for (std::size_t k = 2 * n_modes; k < size(); ++k)
      mode.unknowns.push_back(x[k] * factor * scale);
    return mode;
  }



  UnstableModes
  unstable_modes(const StabilityPencil &pencil,
                 const double           greatest_frequency,
                 const double           least_growth)
  {
    UnstableModes modes;
    for (const auto &s : pencil.eigenvalues())
      if (s.real() > least_growth && s.imag() < 2 * pi * greatest_frequency)
        (s.imag() == 0. ? modes.real : modes.vibrations)
          .push_back(pencil.mode(s));
    std::sort(modes.vibrations.begin(),
              modes.vibrations.end(),
              [](const StabilityMode &a, const StabilityMode &b) {
                return a.s.imag() < b.s.imag();
              });
    return modes;
  }
} // namespace RollingContact
