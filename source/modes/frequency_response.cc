#include <rolling_contact/algebra/indefinite_factor.h>
#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/modes/frequency_response.h>

#include <numeric>

namespace RollingContact
{
  namespace
  {
    double omega_of(const double frequency)
    {
      return 2 * pi * frequency;
    }
  } // namespace

  FrequencyResponse::FrequencyResponse(
    const VibratingStructure               &structure,
    const Factorisation                    &factor,
    const double                            shift,
    const StructuralModes                  &modes,
    const std::vector<double>              &damping_ratios,
    const std::vector<std::vector<double>> &loads)
    : H_m(projected(structure.H, modes.shapes))
  {
    const std::size_t m = modes.size();
    const DenseMatrix b = columns_of(loads, structure.K.size());
    phi                 = modes.shapes.transpose() * b;
    C_m                 = projected(structure.C, modes.shapes);
    for (std::size_t j = 0; j < m; ++j)
      {
        lambda.push_back(modes.eigenvalue(j));
        viscous_ratios.push_back(2 * damping_ratios[j] *
                                 omega_of(modes.frequencies[j]));
      }
    DenseMatrix y = b;
    factor.solve(y);
    const DenseMatrix  at_rest = modes.at_rest.transpose() * b;
    const Eigen::Index n_rest  = at_rest.rows();
    y -= modes.at_rest * at_rest +
         modes.shapes.rightCols(m - n_rest) *
           (as_vector(lambda).tail(m - n_rest).array() + shift)
             .inverse()
             .matrix()
             .asDiagonal() *
           phi.bottomRows(m - n_rest);
    stiff   = projected(structure.K, y);
    heavy   = projected(structure.M, y);
    lost    = projected(structure.H, y);
    viscous = projected(structure.C, y);
  }

  ComplexMatrix FrequencyResponse::receptances(const double frequency,
                                               const bool   modal_damping) const
  {
    const double        omega = omega_of(frequency);
    const Eigen::Index  m     = lambda.size();
    const ComplexMatrix b     = phi.cast<Complex>();
    ComplexMatrix       D = ComplexMatrix::Zero(m, m), x = b;
    D.diagonal().real() = (as_vector(lambda).array() - omega * omega).matrix();
    if (modal_damping)
      D.diagonal().imag() = omega * as_vector(viscous_ratios);
    if (H_m.size() > 0)
      D.imag() += H_m;
    if (C_m.size() > 0)
      D.imag() += omega * C_m;
    const ComplexLU factors(std::move(D));
    if (factors.singular())
      throw ConvergenceError("The receptance at " + significant(frequency, 6) +
                             " Hz is infinite: this is an eigenfrequency and "
                             "nothing damps it. Give damping, or another "
                             "frequency.");
    factors.solve(x);
    ComplexMatrix alpha = b.transpose() * x;
    alpha.real() += stiff + omega * omega * heavy;
    if (lost.size() > 0)
      alpha.imag() -= lost;
    if (viscous.size() > 0)
      alpha.imag() -= omega * viscous;
    return alpha;
  }

  ComplexMatrix
  direct_receptances(const VibratingStructure               &structure,
                     const std::vector<std::vector<double>> &loads,
                     const double                            frequency)
  {
    const double          omega = omega_of(frequency);
    SymmetricSparseMatrix real  = linear_combination(1.,
                                                    structure.K,
                                                    -omega * omega,
                                                    structure.M),
                          imaginary;
    if (structure.H.size() > 0 && structure.C.size() > 0)
      imaginary = linear_combination(1., structure.H, omega, structure.C);
    else if (structure.H.size() > 0)
      imaginary = structure.H;
    else if (structure.C.size() > 0)
      imaginary = linear_combination(omega, structure.C, 0., structure.C);
    else
      imaginary = linear_combination(0., structure.M, 0., structure.M);
    ComplexFactor factor(real, imaginary, structure.node_of_unknown);
    ComplexMatrix alpha(loads.size(), loads.size());
    for (std::size_t q = 0; q < loads.size(); ++q)
      {
        const ComplexFactor::Values x =
          factor.solve({loads[q].begin(), loads[q].end()});
        for (std::size_t p = 0; p < loads.size(); ++p)
          alpha(p, q) = std::inner_product(x.begin(),
                                           x.end(),
                                           loads[p].begin(),
                                           std::complex<double>());
      }
    return alpha;
  }
} // namespace RollingContact
