#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/stability/wave_response.h>

#include <cmath>

namespace RollingContact
{
  namespace
  {
    /// singular values of the modes at the patch that count, over the largest
    const double motion_share = 1e-9;

    /// residual of an answer over its right hand side
    const double wave_tolerance = 1e-9;

    const unsigned int most_corrections = 30;

    /** A x of a real matrix, part by part. */
    template <class Matrix>
    ComplexVector times_complex(const Matrix &A, const ComplexVector &x)
    {
      const Eigen::VectorXd real = x.real(), imaginary = x.imag();
      ComplexVector         result(A.rows());
      result.real() = A * real;
      result.imag() = A * imaginary;
      return result;
    }

    /** Solution of an equation at a rate and a speed, by steps of a nearly
     * exact one. Throws ConvergenceError. */
    template <class Values, class Product, class Solution>
    Values refined(const Values              &target,
                   const std::complex<double> s,
                   const double               speed,
                   const Product             &product,
                   const Solution            &nearly_solved)
    {
      Values y = nearly_solved(target);
      for (unsigned int step = 0;; ++step)
        {
          const Values r     = target - product(y);
          const double error = r.norm() / target.norm();
          if (error <= wave_tolerance)
            return y;
          if (step == most_corrections || !std::isfinite(error))
            throw ConvergenceError("The contact's answer to a wave at " +
                                   significant(s.imag() / (2 * pi), 4) +
                                   " Hz and " + significant(speed, 4) +
                                   " m/s was not found: its residual is " +
                                   significant(error, 2) + ".");
          y += nearly_solved(r);
        }
    }
  } // namespace

  DenseMatrix WaveResponse::motions_of(const ReducedPair &pair)
  {
    if (pair.n_modes() == 0)
      return DenseMatrix::Zero(pair.Phi.rows(), 0);
    std::vector<double> values;
    const DenseMatrix   all = left_singular_vectors(pair.Phi, values);
    std::size_t         p   = 0;
    while (p < values.size() && values[p] > motion_share * values[0])
      ++p;
    return all.leftCols(p);
  }

  WaveResponse::WaveResponse(const LinearContact &contact,
                             const ReducedPair   &pair,
                             const double         speed,
                             std::vector<double>  along,
                             const DenseMatrix   &motions)
    : contact(contact)
    , pair(pair)
    , speed(speed)
    , along(std::move(along))
    , residual(contact, pair)
    , U(motions)
    , amplitudes(motions.transpose() * pair.Phi)
    , N_u(contact.N_u * U)
    , N_v(contact.N_v * U)
  {
    scale_rows();
  }

  void WaveResponse::scale_rows()
  {
    // rows of stick and slip answer V alike in this measure
    scales = residual.statics.cwiseAbs().rowwise().maxCoeff();
    for (Eigen::Index i = 0; i < scales.size(); ++i)
      scales[i] = scales[i] > 0. ? 1 / scales[i] : 1.;
    for (DenseMatrix *M : {&residual.statics, &residual.viscosity, &N_u, &N_v})
      *M = scales.asDiagonal() * *M;
  }

  WaveResponse::Factors WaveResponse::factors(const double wave_number) const
  {
    const auto s = rate(wave_number);
    Factors    result{ComplexLU(residual.statics + s * residual.viscosity),
                   N_u + s * N_v};
    if (result.contact.singular())
      throw ConvergenceError("The contact has no answer to a wave of " +
                             significant(2e3 * pi / wave_number, 4) +
                             " mm: its equations are singular.");
    result.contact.solve(result.motions);
    return result;
  }

  ComplexVector WaveResponse::height_wave(const double wave_number) const
  {
    ComplexVector b = ComplexVector::Zero(contact.n_unknowns());
    for (std::size_t k = 0; k < along.size(); ++k)
      b[k] = std::polar(1., -wave_number * along[k]);
    return b;
  }

  WaveResponse::Reaction
  WaveResponse::reaction(const double         wave_number,
                         const Factors       &factors,
                         const ComplexMatrix &waves) const
  {
    const auto         s = rate(wave_number);
    const Eigen::Index n = waves.rows(), p = U.cols();
    ComplexMatrix      target =
      ComplexMatrix::Zero(contact.n_unknowns(), p + waves.cols());
    target.leftCols(p) = N_u + s * N_v;
    target.topRightCorner(n, waves.cols()) =
      scales.head(n).asDiagonal() * waves;
    const ComplexMatrix T = residual.statics + s * residual.viscosity;
    const ComplexMatrix y = refined(
      target,
      s,
      speed,
      [&](const ComplexMatrix &x) { return ComplexMatrix(T * x); },
      [&](ComplexMatrix r) {
        factors.contact.solve(r);
        return r;
      });
    DenseMatrix rows(p + 1 + pair.watched.cols(), contact.n_unknowns());
    rows.topRows(p) = U.transpose() * contact.forces;
    rows.row(p)     = contact.normal_load();
    if (pair.watched.size() > 0)
      rows.bottomRows(pair.watched.cols()) =
        pair.watched.transpose() * contact.forces;
    const ComplexMatrix all = (1. + s * pair.retardation) * (rows * y);
    return {all.leftCols(p), all.rightCols(waves.cols())};
  }

  WaveResponse::AtWave::AtWave(const WaveResponse &wave_response,
                               const double        wave_number,
                               const Factors      &factors,
                               const ModalFactors &modal)
    : of(wave_response)
    , factors(factors)
    , s(of.rate(wave_number))
    , delay(1. + s * of.pair.retardation)
    , response([&]() {
      ComplexMatrix rates =
        of.amplitudes.transpose().cast<std::complex<double>>();
      modal.solve(rates);
      return ComplexMatrix(of.amplitudes * rates);
    }())
    , reaction(
        delay *
        (of.U.transpose() * of.contact.forces).cast<std::complex<double>>())
    , joined(ComplexMatrix::Identity(of.U.cols(), of.U.cols()) +
             response * (reaction * factors.motions))
  {}

  ComplexVector
  WaveResponse::AtWave::motion_under(const ComplexVector &forces) const
  {
    ComplexVector result = times_complex(of.pair.W_res, forces) / delay;
    if (of.U.cols() > 0)
      result +=
        times_complex(of.U, response * times_complex(of.U.transpose(), forces));
    return result;
  }

  ComplexVector WaveResponse::AtWave::product(const ComplexVector &y) const
  {
    ComplexVector result = times_complex(of.residual.statics, y) +
                           s * times_complex(of.residual.viscosity, y);
    if (of.U.cols() > 0)
      {
        const ComplexVector u = response * (reaction * y);
        result += times_complex(of.N_u, u) + s * times_complex(of.N_v, u);
      }
    return result;
  }

  ComplexVector WaveResponse::AtWave::nearly_solved(ComplexVector r) const
  {
    factors.contact.solve(r);
    if (of.U.cols() == 0)
      return r;
    ComplexVector few = response * (reaction * r);
    joined.solve(few);
    return r - factors.motions * few;
  }

  ComplexVector WaveResponse::AtWave::unknowns(const ComplexVector &b) const
  {
    const ComplexVector target = of.scales.asDiagonal() * b;
    ComplexVector       y      = refined(
      target,
      s,
      of.speed,
      [&](const ComplexVector &x) { return product(x); },
      [&](const ComplexVector &r) { return nearly_solved(r); });
    y.head(of.contact.n_tractions()) *= delay;
    return y;
  }

  WaveAnswer WaveResponse::AtWave::answer(const ComplexVector &b) const
  {
    WaveAnswer result;
    result.unknowns = unknowns(b);
    result.motion =
      motion_under(times_complex(of.contact.forces, result.unknowns));
    return result;
  }

  WaveAnswer WaveResponse::AtWave::corrected(const ComplexVector &b,
                                             const BodyResponse  &bodies,
                                             const unsigned int   n_steps) const
  {
    WaveAnswer result = answer(b);
    for (unsigned int step = 0; step < n_steps; ++step)
      {
        const ComplexVector &x = result.unknowns;
        const ComplexVector  u = bodies({s}, {of.contact.forces * x}).front(),
                            residual =
                              b - of.contact.N_u * u - of.contact.N_r * x -
                              s * (of.contact.N_v * u + of.contact.N_s * x);
        const WaveAnswer change = answer(residual);
        result.motion           = u + change.motion;
        result.unknowns += change.unknowns;
      }
    return result;
  }
} // namespace RollingContact
