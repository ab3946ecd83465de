#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
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
    AtOneRate now{s, ComplexLU(std::move(D)), {}, {}};
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
  FullDynamics::add_attached(const Rates          &rates,
                             const ComplexColumns &X,
                             ComplexColumns       &result) const
  {
    if (!attached)
      return;
    ComplexColumns forces = transposed_product(attached->loads, X);
    for (std::size_t k = 0; k < rates.size(); ++k)
      forces.set(k, rates[k]->stiffness * forces.vector(k));
    result.add(attached->loads * forces);
  }



  void
  FullDynamics::add_flow(const Rates          &rates,
                         const ComplexColumns &X,
                         ComplexColumns       &velocities,
                         ComplexColumns       &result) const
  {
    const double rate = structure.rate;
    if (structure.S.size() == 0 || rate == 0.)
      return;
    std::vector<double> inverse_mass;
    for (std::size_t i = 0; i < structure.M.size(); ++i)
      {
        const double mass = structure.M.values[structure.M.column_starts[i]];
        inverse_mass.push_back(mass > 0. ? 1 / mass : 0.);
      }
    ComplexColumns S_X = times(structure.S, X);
    for (std::size_t k = 0; k < rates.size(); ++k)
      result.add(2. * rates[k]->s * rate, S_X, k);
    S_X.scale_rows(inverse_mass);
    const ComplexColumns twice = times(structure.S, S_X);
    for (std::size_t k = 0; k < rates.size(); ++k)
      {
        result.add(rate * rate, twice, k);
        velocities.add(rate, S_X, k);
      }
  }



  ComplexColumns
  FullDynamics::multiply(const Rates &rates, const ComplexColumns &X) const
  {
    ComplexColumns       result  = times(structure.K, X);
    const ComplexColumns inertia = times(structure.M, X);
    // what the damping sees: s x, and what flow brings
    ComplexColumns velocities(X.n_rows(), X.n_vectors());
    for (std::size_t k = 0; k < rates.size(); ++k)
      {
        const Complex s = rates[k]->s;
        result.add(s * s, inertia, k);
        velocities.add(s, X, k);
      }
    add_attached(rates, X, result);
    add_flow(rates, X, velocities, result);
    if (structure.C.size() > 0)
      result.add(times(structure.C, velocities));
    if (std::all_of(modal_damping.begin(),
                    modal_damping.end(),
                    [](const double c) { return c == 0.; }))
      return result;
    ComplexColumns modal = transposed_product(M_phi, velocities);
    modal.scale_rows(modal_damping);
    result.add(M_phi * modal);
    return result;
  }



  void
  FullDynamics::add_modes(const Rates    &rates,
                          ComplexColumns  Q,
                          ComplexColumns &X) const
  {
    for (std::size_t k = 0; k < rates.size(); ++k)
      {
        const ComplexVector q      = Q.vector(k);
        ComplexVector       change = q;
        rates[k]->modes.solve(change);
        for (std::size_t j = 0; j < change.size(); ++j)
          change[j] -= q[j] / modes.eigenvalue(j);
        Q.set(k, change);
      }
    X.add(modes.shapes * Q);
  }



  ComplexColumns
  FullDynamics::precondition(const Rates &rates, const ComplexColumns &B) const
  {
    ComplexColumns result(B);
    factor.solve(result.real_columns());
    add_modes(rates, transposed_product(modes.shapes, B), result);
    if (!attached)
      return result;
    // less P^-1 L (1 + Z L^T P^-1 L)^-1 Z L^T of that
    ComplexColumns forces = transposed_product(attached->loads, result);
    for (std::size_t k = 0; k < rates.size(); ++k)
      {
        ComplexVector force = rates[k]->stiffness * forces.vector(k);
        rates[k]->woodbury->solve(force);
        for (Complex &value : force)
          value *= -1.;
        forces.set(k, force);
      }
    result.add(attached->deflected * forces);
    add_modes(rates, transposed_product(attached->motions, forces), result);
    return result;
  }



  namespace
  {
    /** One of the systems that are solved side by side. */
    struct Iterate
    {
      explicit Iterate(const ComplexVector &b)
        : x(b.size(), 0.)
        , rest(b)
        , scale(norm(b))
        , error(scale > 0. ? 1. : 0.)
      {}

      void
      take_residual(const ComplexVector &b, const ComplexVector &image)
      {
        rest = b;
        add(rest, -1., image);
        error = norm(rest) / scale;
        ++n_steps;
      }

      ComplexVector x, rest;
      double        scale, error, before = 2.;
      unsigned int  n_steps = 0;
    };



    /** Whether one more step is wanted. Throws ConvergenceError. */
    bool
    goes_on(Iterate &now, const Complex s, const double tolerance)
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
  FullDynamics::solve(const ComplexVector              &s,
                      const std::vector<ComplexVector> &b,
                      const double                      tolerance) const
  {
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
        ComplexColumns X(structure.K.size(), active.size());
        for (std::size_t k = 0; k < active.size(); ++k)
          X.set(k, iterates[active[k]].rest);
        const ComplexColumns change = precondition(rates, X);
        for (std::size_t k = 0; k < active.size(); ++k)
          {
            add(iterates[active[k]].x, 1., change.vector(k));
            X.set(k, iterates[active[k]].x);
          }
        const ComplexColumns image = multiply(rates, X);
        for (std::size_t k = 0; k < active.size(); ++k)
          iterates[active[k]].take_residual(b[active[k]], image.vector(k));
        iterations += active.size();
      }
    std::vector<ComplexVector> solutions;
    for (Iterate &iterate : iterates)
      solutions.push_back(std::move(iterate.x));
    return solutions;
  }
} // namespace RollingContact
