#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/linear_algebra/block_products.h>
#include <rolling_contact/linear_algebra/complex_matrix.h>
#include <rolling_contact/linear_algebra/indefinite_factor.h>
#include <rolling_contact/modes/frequency_response.h>

namespace RollingContact
{
  namespace
  {
    DenseMatrix
    columns_of(const std::vector<std::vector<double>> &vectors,
               const std::size_t                       n_rows)
    {
      DenseMatrix result(n_rows, vectors.size());
      for (std::size_t j = 0; j < vectors.size(); ++j)
        std::copy(vectors[j].begin(),
                  vectors[j].end(),
                  result.data() + j * n_rows);
      return result;
    }



    double
    omega_of(const double frequency)
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
    const std::size_t n = structure.K.size(), m = modes.size();
    const DenseMatrix b = columns_of(loads, n);
    phi                 = transposed_product(modes.shapes, b);
    C_m                 = projected(structure.C, modes.shapes);
    for (std::size_t j = 0; j < m; ++j)
      {
        lambda.push_back(modes.eigenvalue(j));
        viscous_ratios.push_back(2 * damping_ratios[j] *
                                 omega_of(modes.frequencies[j]));
      }
    DenseMatrix y = b;
    factor.solve(y);
    DenseMatrix known = phi;
    for (std::size_t q = 0; q < known.n_columns(); ++q)
      for (std::size_t j = 0; j < m; ++j)
        known(j, q) /= lambda[j] + shift;
    const DenseMatrix of_modes = dense_product(modes.shapes, known);
    for (std::size_t i = 0; i < n * y.n_columns(); ++i)
      y.data()[i] -= of_modes.data()[i];
    stiff   = projected(structure.K, y);
    heavy   = projected(structure.M, y);
    lost    = projected(structure.H, y);
    viscous = projected(structure.C, y);
  }



  std::vector<FrequencyResponse::Complex>
  FrequencyResponse::receptances(const double frequency,
                                 const bool   modal_damping) const
  {
    const double         omega = omega_of(frequency);
    const int            m = lambda.size(), n = n_places();
    ComplexMatrix        D(m, m), x(phi);
    std::vector<Complex> alpha(static_cast<std::size_t>(n) * n);
    for (int j = 0; j < m; ++j)
      for (int i = 0; i < m; ++i)
        {
          if (i == j)
            D(i, j) = {lambda[j] - omega * omega,
                       modal_damping ? omega * viscous_ratios[j] : 0.};
          if (H_m.n_rows() > 0)
            D(i, j) += Complex(0., H_m(i, j));
          if (C_m.n_rows() > 0)
            D(i, j) += Complex(0., omega * C_m(i, j));
        }
    const ComplexLU factors(std::move(D));
    if (factors.singular())
      throw ConvergenceError("The receptance at " + significant(frequency, 6) +
                             " Hz is infinite: this is an eigenfrequency and "
                             "nothing damps it. Give damping, or another "
                             "frequency.");
    factors.solve(x);
    for (int q = 0; q < n; ++q)
      for (int p = 0; p < n; ++p)
        {
          Complex sum(stiff(p, q) + omega * omega * heavy(p, q), 0.);
          if (lost.n_rows() > 0)
            sum -= Complex(0., lost(p, q));
          if (viscous.n_rows() > 0)
            sum -= Complex(0., omega * viscous(p, q));
          for (int j = 0; j < m; ++j)
            sum += phi(j, p) * x(j, q);
          alpha[p + static_cast<std::size_t>(q) * n] = sum;
        }
    return alpha;
  }



  std::vector<std::complex<double>>
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
    std::vector<std::complex<double>> alpha;
    for (const std::vector<double> &load : loads)
      {
        const ComplexFactor::Values x =
          factor.solve({load.begin(), load.end()});
        for (const std::vector<double> &place : loads)
          {
            std::complex<double> sum = 0.;
            for (std::size_t i = 0; i < x.size(); ++i)
              if (place[i] != 0.)
                sum += place[i] * x[i];
            alpha.push_back(sum);
          }
      }
    return alpha;
  }
} // namespace RollingContact
