#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/linear_algebra/block_products.h>
#include <rolling_contact/modes/full_dynamics.h>

#include <algorithm>
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



    /** A real and an imaginary part, as real products take them. */
    struct Parts
    {
      explicit Parts(const ComplexVector &x)
      {
        for (const Complex &value : x)
          {
            real.push_back(value.real());
            imaginary.push_back(value.imag());
          }
      }

      explicit Parts(const std::size_t n)
        : real(n)
        , imaginary(n)
      {}

      std::vector<double> real, imaginary;
    };



    template <class Matrix>
    Parts
    product(const Matrix &A, const Parts &x)
    {
      Parts result(x.real.size());
      A.multiply(x.real, result.real);
      A.multiply(x.imaginary, result.imaginary);
      return result;
    }



    /** y += factor x. */
    void
    add(const Complex factor, const Parts &x, ComplexVector &y)
    {
      for (std::size_t i = 0; i < y.size(); ++i)
        y[i] += factor * Complex(x.real[i], x.imaginary[i]);
    }



    /** Both parts as columns: one pass through a large matrix takes both. */
    DenseMatrix
    columns_of(const Parts &x)
    {
      const std::size_t n = x.real.size();
      DenseMatrix       X(n, 2);
      std::copy(x.real.begin(), x.real.end(), X.data());
      std::copy(x.imaginary.begin(), x.imaginary.end(), X.data() + n);
      return X;
    }



    Parts
    parts_of(const DenseMatrix &X)
    {
      const double *middle = X.data() + X.n_rows();
      Parts         x(0);
      x.real.assign(X.data(), middle);
      x.imaginary.assign(middle, middle + X.n_rows());
      return x;
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
    , M_phi(times(structure.M, modes.shapes))
    , attached(std::move(attached))
  {
    for (std::size_t j = 0; j < modes.size(); ++j)
      modal_damping.push_back(2 * damping_ratios[j] * 2 * pi *
                              modes.frequencies[j]);
  }



  FullDynamics::AtOneRate
  FullDynamics::at(const Complex s) const
  {
    ComplexMatrix D(K_m, s, C_m);
    for (std::size_t j = 0; j < modes.size(); ++j)
      D(j, j) += s * s;
    AtOneRate now{ComplexLU(std::move(D)), {}, {}};
    if (now.modes.singular())
      throw ConvergenceError("Vibration of the modes alone has no answer at "
                             "this frequency: it is an undamped eigenvalue.");
    if (!attached)
      return now;
    // L^T P^-1 L = P [(s^2 + s C_m + K_m)^-1 - Lambda^-1] P^T + L^T K^-1 L
    const DenseMatrix &P = attached->motions;
    const std::size_t  c = P.n_rows(), m = P.n_columns();
    ComplexMatrix      of_modes(m, c);
    for (std::size_t i = 0; i < c; ++i)
      for (std::size_t j = 0; j < m; ++j)
        of_modes(j, i) = P(i, j);
    now.modes.solve(of_modes);
    for (std::size_t i = 0; i < c; ++i)
      for (std::size_t j = 0; j < m; ++j)
        of_modes(j, i) -= P(i, j) / modes.eigenvalue(j);
    ComplexMatrix compliance = ComplexMatrix(P) * of_modes;
    for (std::size_t i = 0; i < c; ++i)
      for (std::size_t j = 0; j < c; ++j)
        compliance(j, i) += attached->compliance(j, i);
    now.stiffness        = attached->stiffness(s);
    ComplexMatrix system = now.stiffness * compliance;
    for (std::size_t i = 0; i < c; ++i)
      system(i, i) += 1.;
    now.woodbury.emplace(std::move(system));
    if (now.woodbury->singular())
      throw ConvergenceError("Vibration of the modes and what hangs on them "
                             "has no answer at this frequency: it is an "
                             "undamped eigenvalue.");
    return now;
  }



  void
  FullDynamics::add_attached(const AtOneRate     &now,
                             const ComplexVector &x,
                             ComplexVector       &result) const
  {
    if (!attached)
      return;
    const ComplexVector force =
      now.stiffness * transposed_product(attached->loads, x);
    add(1.,
        parts_of(dense_product(attached->loads, columns_of(Parts(force)))),
        result);
  }



  ComplexVector
  FullDynamics::multiply(const Complex        s,
                         const AtOneRate     &now,
                         const ComplexVector &x) const
  {
    const double  rate = structure.rate;
    const Parts   parts(x);
    ComplexVector result(x.size(), 0.);
    add(1., product(structure.K, parts), result);
    add(s * s, product(structure.M, parts), result);
    add_attached(now, x, result);
    // what the damping sees: s x, and what flow brings
    ComplexVector velocity(x.size(), 0.);
    add(s, parts, velocity);
    if (structure.S.size() > 0 && rate != 0.)
      {
        const Parts S_x = product(structure.S, parts);
        add(2. * s * rate, S_x, result);
        Parts per_mass = S_x;
        for (std::size_t i = 0; i < x.size(); ++i)
          {
            const double mass =
              structure.M.values[structure.M.column_starts[i]];
            const double inverse = mass > 0. ? 1 / mass : 0.;
            per_mass.real[i] *= inverse;
            per_mass.imaginary[i] *= inverse;
          }
        add(rate * rate, product(structure.S, per_mass), result);
        add(rate, per_mass, velocity);
      }
    const Parts v(velocity);
    if (structure.C.size() > 0)
      add(1., product(structure.C, v), result);
    if (std::all_of(modal_damping.begin(),
                    modal_damping.end(),
                    [](const double c) { return c == 0.; }))
      return result;
    Parts modal = parts_of(transposed_product(M_phi, columns_of(v)));
    for (std::size_t j = 0; j < modal.real.size(); ++j)
      {
        modal.real[j] *= modal_damping[j];
        modal.imaginary[j] *= modal_damping[j];
      }
    add(1., parts_of(dense_product(M_phi, columns_of(modal))), result);
    return result;
  }



  void
  FullDynamics::add_modes(const AtOneRate &now,
                          ComplexVector    q,
                          ComplexVector   &x) const
  {
    ComplexVector change = q;
    now.modes.solve(change);
    for (std::size_t j = 0; j < change.size(); ++j)
      change[j] -= q[j] / modes.eigenvalue(j);
    add(1.,
        parts_of(dense_product(modes.shapes, columns_of(Parts(change)))),
        x);
  }



  ComplexVector
  FullDynamics::precondition(const AtOneRate &now, const ComplexVector &b) const
  {
    DenseMatrix block = columns_of(Parts(b));
    factor.solve(block);
    ComplexVector result(b.size(), 0.);
    add(1., parts_of(block), result);
    add_modes(now, transposed_product(modes.shapes, b), result);
    if (!attached)
      return result;
    // less P^-1 L (1 + Z L^T P^-1 L)^-1 Z L^T of that
    ComplexVector force =
      now.stiffness * transposed_product(attached->loads, result);
    now.woodbury->solve(force);
    for (Complex &value : force)
      value *= -1.;
    add(1.,
        parts_of(dense_product(attached->deflected, columns_of(Parts(force)))),
        result);
    add_modes(now, transposed_product(attached->motions, force), result);
    return result;
  }



  ComplexVector
  FullDynamics::solve(const Complex        s,
                      const ComplexVector &b,
                      const double         tolerance) const
  {
    const AtOneRate now = at(s);
    ComplexVector   x(b.size(), 0.), rest = b;
    const double    scale = norm(b);
    double          error = scale > 0. ? 1. : 0., before = 2.;
    for (unsigned int k = 0; error > tolerance; ++k)
      {
        if (error < good_enough && error > standing_still * before)
          break;
        before = error;
        if (k == most_iterations || !(error < 1e6))
          throw ConvergenceError(
            "Vibration of a whole body at " +
            significant(std::abs(s.imag()) / (2 * pi), 5) +
            " Hz was not found: residual " + significant(error, 2) + " after " +
            std::to_string(k) +
            " iterations; raise Modes/Cut-off ratio, so that the modes reach "
            "further.");
        const ComplexVector step = precondition(now, rest);
        for (std::size_t i = 0; i < x.size(); ++i)
          x[i] += step[i];
        rest                      = b;
        const ComplexVector image = multiply(s, now, x);
        for (std::size_t i = 0; i < x.size(); ++i)
          rest[i] -= image[i];
        error = norm(rest) / scale;
        ++iterations;
      }
    return x;
  }
} // namespace RollingContact
