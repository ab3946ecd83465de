#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/stability/pencil.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  double StabilityMode::frequency() const
  {
    return std::abs(s.imag()) / (2 * pi);
  }

  double StabilityMode::damping_ratio() const
  {
    return s == 0. ? 0. : -s.real() / std::abs(s);
  }

  std::vector<double> StabilityMode::participation() const
  {
    std::vector<double> shares(modal.size());
    as_vector(shares) = modal.cwiseAbs2();
    return shares;
  }

  StabilityPencil::StabilityPencil(const ReducedPair   &pair,
                                   const LinearContact &contact)
    : n_modes(pair.n_modes())
    , n_tractions(contact.n_tractions())
    , retardation(pair.retardation)
  {
    const std::size_t n_x = contact.n_unknowns(), n = 2 * n_modes + n_x;
    if (pair.W_res.rows() != contact.forces.rows())
      throw InputError("The bodies have " + std::to_string(pair.W_res.rows()) +
                       " displacements of the contact and the contact itself " +
                       std::to_string(contact.forces.rows()) +
                       ": both must have the same nodes.");
    A                     = DenseMatrix::Zero(n, n);
    E                     = DenseMatrix::Zero(n, n);
    const double stiffest = pair.K_m.diagonal().lpNorm<Eigen::Infinity>();
    if (stiffest > 0.)
      rate = 0.2 * std::sqrt(stiffest);
    add_bodies(pair, contact);
    add_contact(pair, contact);
  }

  void StabilityPencil::add_bodies(const ReducedPair   &pair,
                                   const LinearContact &contact)
  {
    const std::size_t m       = n_modes;
    const DenseMatrix drive   = pair.Phi.transpose() * contact.forces;
    const double      largest = drive.lpNorm<Eigen::Infinity>();
    scale                     = largest > 0. ? rate * rate / largest : 1.;
    A.block(0, m, m, m).setIdentity();
    A.block(m, 0, m, m) = -pair.K_m / (rate * rate);
    A.block(m, m, m, m) = -pair.C_m / rate;
    A.middleRows(m, m).rightCols(drive.cols()) =
      drive * (scale / (rate * rate));
    E.topLeftCorner(2 * m, 2 * m).setIdentity();
    E.middleRows(m, m).rightCols(drive.cols()) =
      drive * (-retardation * scale / rate);
  }

  void StabilityPencil::add_contact(const ReducedPair   &pair,
                                    const LinearContact &contact)
  {
    const std::size_t m = n_modes, n_x = contact.n_unknowns();
    const DenseMatrix residual = pair.W_res * contact.forces;
    A.bottomRows(n_x) << contact.N_u * pair.Phi, contact.N_v * pair.Phi * rate,
      (contact.N_u * residual + contact.N_r) * scale;
    E.bottomRightCorner(n_x, n_x) =
      -(contact.N_v * residual + contact.N_s) * scale * rate;
    E.bottomRightCorner(n_x, n_x).leftCols(n_tractions) -=
      contact.N_r.leftCols(n_tractions) * (retardation * scale * rate);
    for (std::size_t i = 0; i < n_x; ++i)
      {
        auto         of_A = A.row(2 * m + i), of_E = E.row(2 * m + i);
        const double largest = std::max(of_A.lpNorm<Eigen::Infinity>(),
                                        of_E.lpNorm<Eigen::Infinity>());
        if (!(largest > 0.) || !of_A.allFinite() || !of_E.allFinite())
          throw InputError("Row " + std::to_string(i + 1) + " of " +
                           std::to_string(n_x) +
                           " of the linearised contact holds nothing, or an "
                           "entry that is not a number.");
        of_A /= largest;
        of_E /= largest;
      }
  }

  ComplexValues StabilityPencil::eigenvalues() const
  {
    const double at_infinity = 1e-9;
    double       shift       = 1.5;
    // E = P E_1 with its rows that are not zero: (A - shift E)^-1 P E_1 has the
    // eigenvalues of E_1 (A - shift E)^-1 P, which is smaller, and zeros
    std::vector<std::size_t> moving;
    for (std::size_t i = 0; i < size(); ++i)
      if (!E.row(i).isZero(0.))
        moving.push_back(i);
    const DenseMatrix one = DenseMatrix::Identity(size(), size()),
                      E_1 = E(moving, Eigen::all), P = one(Eigen::all, moving);
    DenseMatrix shifted, inverse;
    for (bool solved = false; !solved; shift *= 1.37)
      {
        if (shift > 10.)
          throw InputError("The equations of bodies and contact are singular: "
                           "the contact does not determine its forces, as "
                           "where nodes have no compliance.");
        shifted = A - shift * E;
        inverse = P;
        solved  = solve_general(shifted, inverse);
        if (solved)
          break;
      }
    const ComplexValues found   = RollingContact::eigenvalues(E_1 * inverse);
    double              largest = 0.;
    for (const auto &value : found)
      largest = std::max(largest, std::abs(value));
    ComplexValues values;
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

  StabilityMode StabilityPencil::mode(const std::complex<double> s) const
  {
    StabilityMode mode;
    // a hair beside the eigenvalue, where the matrix is not singular
    const std::complex<double> shift = s / rate * (1. + 1e-10) + 1e-14;
    const ComplexLU            factors(A - shift * E);
    ComplexVector              x(size());
    for (std::size_t i = 0; i < size(); ++i)
      x[i] = std::polar(1., 2.4 * i); // of no symmetry
    std::complex<double> change = 0.;
    for (unsigned int step = 0; step < 3; ++step)
      {
        const ComplexVector before = step == 0 ? x : ComplexVector(E * x);
        x                          = before;
        factors.solve(x);
        // (A - shift E) y = E x, and y is about E's x over (s - shift)
        if (step > 0)
          {
            const ComplexVector image = E * x;
            change                    = image.dot(before) / image.squaredNorm();
          }
        x.normalize();
      }
    mode.s = rate * (shift + change);
    if (s.imag() == 0.)
      mode.s = mode.s.real();
    const ComplexVector left = A * x;
    mode.residual =
      (left - mode.s / rate * (E * x)).norm() / left.lpNorm<Eigen::Infinity>();

    const double modal  = x.head(n_modes).norm(),
                 factor = modal > 0. ? 1 / modal : 1.;
    mode.modal          = x.head(n_modes) * factor;
    mode.unknowns       = x.tail(size() - 2 * n_modes) * (factor * scale);
    mode.unknowns.head(n_tractions) *= 1. + retardation * mode.s;
    return mode;
  }

  UnstableModes unstable_modes(const StabilityPencil &pencil,
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
