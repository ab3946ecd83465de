#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/modes/full_dynamics.h>

#include <cmath>

namespace RollingContact
{
  namespace
  {
    using Complex = std::complex<double>;

    const unsigned int most_iterations = 200;

    /// residual at which rounding may end the iterations: they gain less than
    /// this share
    const double good_enough = 1e-6, standing_still = 0.5;

    /** Real parts of complex columns, and behind them the imaginary ones: what
     * is real multiplies and solves all of them at once. */
    DenseMatrix parts(const ComplexMatrix &X)
    {
      DenseMatrix result(X.rows(), 2 * X.cols());
      result << X.real(), X.imag();
      return result;
    }

    ComplexMatrix joined(const DenseMatrix &parts)
    {
      const Eigen::Index n = parts.cols() / 2;
      return parts.leftCols(n) + Complex(0., 1.) * parts.rightCols(n);
    }

    /** A X of a real dense matrix or an expression of one. */
    template <class Matrix>
    ComplexMatrix product(const Matrix &A, const ComplexMatrix &X)
    {
      return joined(A * parts(X));
    }

    /** A X of a sparse matrix. */
    template <class Matrix>
    ComplexMatrix times(const Matrix &A, const ComplexMatrix &X)
    {
      return joined(times(A, parts(X)));
    }
  } // namespace

  FullDynamics::FullDynamics(const TurningStructure         &structure,
                             const Factorisation            &factor,
                             const StructuralModes          &modes,
                             const std::vector<double>      &damping_ratios,
                             const DenseMatrix              &K_m,
                             const DenseMatrix              &C_m,
                             std::optional<AttachedDynamics> attached)
    : structure(structure)
    , factor(factor)
    , modes(modes)
    , K_m(K_m)
    , C_m(C_m)
    , attached(std::move(attached))
  {
    modal_damping =
      4 * pi *
      as_vector(damping_ratios).cwiseProduct(as_vector(modes.frequencies));
  }

  Complex FullDynamics::part_beyond(const Complex s) const
  {
    return 1. / (1. + s * retardation_beyond.value_or(0.));
  }

  FullDynamics::AtOneRate FullDynamics::at(const Complex s) const
  {
    ComplexMatrix D = K_m + s * C_m;
    D.diagonal().array() += s * s;
    AtOneRate now{s, ComplexLU(std::move(D)), {}, {}};
    if (now.modes.singular())
      throw ConvergenceError("The modes have no finite response at this "
                             "frequency, because it is an undamped "
                             "eigenfrequency of them.");
    if (!attached)
      return now;
    // L^T P^-1 L = P [(s^2 + s C_m + K_m)^-1 - Lambda^-1] P^T + L^T K^-1 L
    const ComplexMatrix P        = attached->motions.cast<Complex>();
    ComplexMatrix       of_modes = P.transpose();
    now.modes.solve(of_modes);
    now.stiffness = attached->stiffness(s);
    ComplexMatrix system =
      now.stiffness * (P * of_modes + part_beyond(s) * attached->residual);
    system.diagonal().array() += 1.;
    now.woodbury.emplace(std::move(system));
    if (now.woodbury->singular())
      throw ConvergenceError("The modes and what hangs on them have no finite "
                             "response at this frequency, because it is an "
                             "undamped eigenfrequency of them.");
    return now;
  }

  void FullDynamics::add_losses(const Rates         &rates,
                                const ComplexMatrix &X,
                                ComplexMatrix       &result) const
  {
    if (structure.H.size() == 0)
      return;
    const ComplexMatrix losses = times(structure.H, X);
    for (std::size_t k = 0; k < rates.size(); ++k)
      if (const Complex s = rates[k]->s; s.imag() != 0.)
        result.col(k) += s / std::abs(s.imag()) * losses.col(k);
  }

  void FullDynamics::add_attached(const Rates         &rates,
                                  const ComplexMatrix &X,
                                  ComplexMatrix       &result) const
  {
    if (!attached)
      return;
    ComplexMatrix forces = product(attached->loads.transpose(), X);
    for (std::size_t k = 0; k < rates.size(); ++k)
      forces.col(k) = rates[k]->stiffness * forces.col(k);
    result += product(attached->loads, forces);
  }

  void FullDynamics::add_flow(const Rates         &rates,
                              const ComplexMatrix &X,
                              ComplexMatrix       &velocities,
                              ComplexMatrix       &result) const
  {
    const double rate = structure.rate;
    if (structure.S.size() == 0 || rate == 0.)
      return;
    ComplexMatrix S_X = times(structure.S, X);
    for (std::size_t k = 0; k < rates.size(); ++k)
      result.col(k) += 2. * rates[k]->s * rate * S_X.col(k);
    for (std::size_t i = 0; i < structure.M.size(); ++i)
      {
        const double mass = structure.M.values[structure.M.column_starts[i]];
        S_X.row(i) *= mass > 0. ? 1 / mass : 0.;
      }
    result += rate * rate * times(structure.S, S_X);
    velocities += rate * S_X;
  }

  ComplexMatrix FullDynamics::multiply(const Rates         &rates,
                                       const ComplexMatrix &X) const
  {
    ComplexMatrix       result  = times(structure.K, X);
    const ComplexMatrix inertia = times(structure.M, X);
    // what the damping sees: s x, and what flow brings
    ComplexMatrix velocities = X;
    for (std::size_t k = 0; k < rates.size(); ++k)
      {
        const Complex s = rates[k]->s;
        result.col(k) += s * s * inertia.col(k);
        velocities.col(k) *= s;
      }
    add_losses(rates, X, result);
    add_attached(rates, X, result);
    add_flow(rates, X, velocities, result);
    if (structure.C.size() > 0)
      result += times(structure.C, velocities);
    if (modal_damping.isZero(0.))
      return result;
    const ComplexMatrix of_modes =
      modal_damping.asDiagonal() *
      product(modes.shapes.transpose(), times(structure.M, velocities));
    return result + times(structure.M, product(modes.shapes, of_modes));
  }

  void FullDynamics::add_modes(const Rates         &rates,
                               ComplexMatrix        Q,
                               const ComplexMatrix &at_rest,
                               ComplexMatrix       &X) const
  {
    const Eigen::Index n_rest = modes.at_rest.cols();
    ComplexMatrix      taken  = at_rest; // amplitudes of Phi in R R^T B
    for (std::size_t j = n_rest; j < modes.size(); ++j)
      taken.row(j) /= std::sqrt(modes.eigenvalue(j));
    if (n_rest > 0)
      {
        X -= product(modes.at_rest, taken.topRows(n_rest));
        taken.topRows(n_rest).setZero();
      }
    for (std::size_t k = 0; k < rates.size(); ++k)
      {
        rates[k]->modes.solve(Q.col(k));
        const Complex follows = part_beyond(rates[k]->s);
        X.col(k) *= follows;
        taken.col(k) *= follows;
      }
    X += product(modes.shapes, Q - taken);
  }

  ComplexMatrix FullDynamics::precondition(const Rates         &rates,
                                           const ComplexMatrix &B) const
  {
    DenseMatrix       columns = parts(B);
    const DenseMatrix Q       = modes.shapes.transpose() * columns,
                      at_rest =
                        modes.statics(Q.transpose(),
                                      columns.transpose() * modes.at_rest);
    factor.solve(columns);
    ComplexMatrix result = joined(columns);
    add_modes(rates, joined(Q), joined(at_rest.transpose()), result);
    if (!attached)
      return result;
    // less P^-1 L (1 + Z L^T P^-1 L)^-1 Z L^T of that
    ComplexMatrix forces = -product(attached->loads.transpose(), result);
    for (std::size_t k = 0; k < rates.size(); ++k)
      {
        forces.col(k) = rates[k]->stiffness * forces.col(k);
        rates[k]->woodbury->solve(forces.col(k));
      }
    ComplexMatrix more = product(attached->deflected, forces);
    add_modes(rates,
              product(attached->motions.transpose(), forces),
              product(attached->statics.transpose(), forces),
              more);
    return result + more;
  }

  namespace
  {
    /** One of the systems that are solved side by side. */
    struct Iterate
    {
      explicit Iterate(const ComplexVector &b)
        : x(ComplexVector::Zero(b.size()))
        , rest(b)
        , scale(b.norm())
        , error(scale > 0. ? 1. : 0.)
      {}

      void take_residual(const ComplexVector &b, const ComplexVector &image)
      {
        rest  = b - image;
        error = rest.norm() / scale;
        ++n_steps;
      }

      ComplexVector x, rest;
      double        scale, error, before = 2.;
      unsigned int  n_steps = 0;
    };

    /** Whether one more step is wanted. Throws ConvergenceError. */
    bool goes_on(Iterate &now, const Complex s, const double tolerance)
    {
      if (!(now.error > tolerance) ||
          (now.error < good_enough && now.error > standing_still * now.before))
        return false;
      now.before = now.error;
      if (now.n_steps == most_iterations || !(now.error < 1e6))
        throw ConvergenceError(
          "Vibration of a whole body at " +
          significant(std::abs(s.imag()) / (2 * pi), 5) +
          " Hz was not found: residual " + significant(now.error, 2) +
          " after " + std::to_string(now.n_steps) +
          " iterations; raise Modes/Cut-off ratio, so that the modes reach "
          "further.");
      return true;
    }
  } // namespace

  std::vector<ComplexVector>
  FullDynamics::by_modes(const ComplexValues              &s,
                         const std::vector<ComplexVector> &b) const
  {
    std::vector<AtOneRate> all_rates;
    Rates                  rates;
    ComplexMatrix          B(structure.K.size(), b.size());
    all_rates.reserve(s.size());
    for (std::size_t k = 0; k < s.size(); ++k)
      {
        all_rates.push_back(at(s[k]));
        rates.push_back(&all_rates.back());
        B.col(k) = b[k];
      }
    const ComplexMatrix        X = precondition(rates, B);
    std::vector<ComplexVector> solutions;
    for (Eigen::Index k = 0; k < X.cols(); ++k)
      solutions.push_back(X.col(k));
    iterations += b.size();
    return solutions;
  }

  std::vector<ComplexVector>
  FullDynamics::solve(const ComplexValues              &s,
                      const std::vector<ComplexVector> &b,
                      const double                      tolerance) const
  {
    if (retardation_beyond)
      return by_modes(s, b);
    std::vector<AtOneRate> all_rates;
    std::vector<Iterate>   iterates;
    for (std::size_t k = 0; k < s.size(); ++k)
      {
        all_rates.push_back(at(s[k]));
        iterates.emplace_back(b[k]);
      }
    while (true)
      {
        std::vector<std::size_t> active;
        Rates                    rates;
        for (std::size_t k = 0; k < s.size(); ++k)
          if (goes_on(iterates[k], s[k], tolerance))
            {
              active.push_back(k);
              rates.push_back(&all_rates[k]);
            }
        if (active.empty())
          break;
        ComplexMatrix X(structure.K.size(), active.size());
        for (std::size_t k = 0; k < active.size(); ++k)
          X.col(k) = iterates[active[k]].rest;
        const ComplexMatrix change = precondition(rates, X);
        for (std::size_t k = 0; k < active.size(); ++k)
          X.col(k) = iterates[active[k]].x += change.col(k);
        const ComplexMatrix image = multiply(rates, X);
        for (std::size_t k = 0; k < active.size(); ++k)
          iterates[active[k]].take_residual(b[active[k]], image.col(k));
        iterations += active.size();
      }
    std::vector<ComplexVector> solutions;
    for (Iterate &iterate : iterates)
      solutions.push_back(std::move(iterate.x));
    return solutions;
  }
} // namespace RollingContact
