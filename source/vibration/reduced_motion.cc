#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/linear_algebra/block_products.h>
#include <rolling_contact/linear_algebra/dense_eigenvalues.h>
#include <rolling_contact/vibration/reduced_motion.h>

#include <cmath>
#include <stdexcept>

namespace RollingContact
{
  namespace
  {
    using Vector = std::vector<double>;

    Vector
    product(const DenseMatrix &M, const Vector &x)
    {
      Vector y(M.n_rows(), 0.);
      M.multiply_block(0, 0, x, y);
      return y;
    }



    /** x + a y. */
    Vector
    sum(Vector x, const double a, const Vector &y)
    {
      for (std::size_t i = 0; i < x.size(); ++i)
        x[i] += a * y[i];
      return x;
    }
  } // namespace



  ReducedMotion::ReducedMotion(ReducedPair bodies)
    : pair(std::move(bodies))
    , shapes(transposed(pair.Phi))
  {
    check(pair);
    const Vector nothing(pair.n_modes(), 0.);
    rest_at(nothing, Vector(pair.W_res.n_rows(), 0.));
  }



  void
  ReducedMotion::set_hub_inertia(Vector inertia)
  {
    if (inertia.size() != pair.n_modes())
      throw InputError("The inertia of the hub's motion has " +
                       std::to_string(inertia.size()) +
                       " values, the bodies have " +
                       std::to_string(pair.n_modes()) + " modes.");
    hub_inertia = std::move(inertia);
    begun       = false;
  }



  void
  ReducedMotion::set_time_step(const double step)
  {
    if (step == h)
      return;
    if (!(step > 0.) || !std::isfinite(step))
      throw InputError("A time step of the reduced bodies is " +
                       significant(step, 6) + " s; it must be above 0.");
    h                   = step;
    begun               = false;
    const std::size_t m = pair.n_modes();
    DenseMatrix       A(m, m);
    inverse = DenseMatrix(m, m);
    for (std::size_t j = 0; j < m; ++j)
      {
        for (std::size_t i = 0; i < m; ++i)
          A(i, j) = h / 2 * pair.C_m(i, j) + h * h / 4 * pair.K_m(i, j);
        A(j, j) += 1.;
        inverse(j, j) = 1.;
      }
    if (m > 0 && !solve_general(A, inverse))
      throw ConvergenceError("The matrix of a time step of " +
                             significant(h, 6) +
                             " s of the modes is singular.");
    inverse_transposed = transposed(inverse);
    const DenseMatrix G =
      dense_product(pair.Phi, dense_product(inverse, shapes));
    W = pair.W_res;
    for (std::size_t j = 0; j < W.n_rows(); ++j)
      for (std::size_t i = 0; i < W.n_rows(); ++i)
        W(i, j) += h * h / (2 * velocity_factor) * (G(i, j) + G(j, i)) / 2;
  }



  void
  ReducedMotion::rest_at(const Vector &eta, const Vector &forces)
  {
    ReducedState state;
    state.eta    = eta;
    state.rate   = Vector(eta.size(), 0.);
    state.forces = state.forces_before = forces;
    set_state(state);
    now.load = sum(product(pair.K_m, eta), -1., product(shapes, forces));
  }



  void
  ReducedMotion::set_state(ReducedState state)
  {
    const std::size_t m = pair.n_modes(), n = pair.W_res.n_rows();
    if (state.load.empty())
      state.load.assign(m, 0.);
    if (state.eta.size() != m || state.rate.size() != m ||
        state.load.size() != m || state.forces.size() != n ||
        state.forces_before.size() != n)
      throw InputError("A state of reduced bodies has " +
                       std::to_string(state.eta.size()) + " modes and " +
                       std::to_string(state.forces.size()) +
                       " forces, the bodies " + std::to_string(m) + " and " +
                       std::to_string(n) + ".");
    now             = std::move(state);
    begun           = false;
    residual        = product(pair.W_res, now.forces);
    residual_before = product(pair.W_res, now.forces_before);
    velocity        = product(pair.Phi, now.rate);
    step_energy     = {};
    find_energy();
  }



  ReducedMotion::Past
  ReducedMotion::past(const bool smooth) const
  {
    if (!smooth)
      return {velocity_factor, 0.};
    if (now.last_step == 0.) // at rest before, or a motion of equal steps
      return {2., -0.5};
    const double d = (h + now.last_step) / 2, D = d + now.distance,
                 before = (velocity_factor * D - h) / (D - d);
    return {before, velocity_factor - before};
  }



  void
  ReducedMotion::begin_step(const bool smooth, const double hub_acceleration)
  {
    if (h == 0.)
      throw std::logic_error("Reduced bodies have no time step.");
    load                = hub_acceleration == 0. || hub_inertia.empty()
                            ? now.load
                            : sum(now.load, hub_acceleration, hub_inertia);
    const Past   weight = past(smooth);
    const Vector start  = sum(now.rate, h / 2, sum(load, -1., K_eta));
    free_rate           = product(inverse, start);

    Vector expected = now.forces;
    if (smooth)
      for (std::size_t i = 0; i < expected.size(); ++i)
        expected[i] += now.forces[i] - now.forces_before[i];
    const Vector loads = product(shapes, expected), y = product(inverse, loads),
                 z = product(inverse_transposed, loads);

    const double part   = h * h / (4 * velocity_factor);
    Vector       amount = sum(now.eta, h / 2, free_rate);
    amount              = sum(std::move(amount), h * h / 4 - part, y);
    free_u              = product(pair.Phi, sum(std::move(amount), -part, z));

    Vector rate = sum(free_rate, h / 4, y);
    free_v      = product(pair.Phi, sum(std::move(rate), -h / 4, z));
    for (std::size_t i = 0; i < free_v.size(); ++i)
      free_v[i] -=
        (weight.before * residual[i] + weight.earlier * residual_before[i]) / h;
    begun     = true;
    continues = smooth;
  }



  void
  ReducedMotion::find_energy()
  {
    K_eta               = product(pair.K_m, now.eta);
    step_energy.kinetic = dot(now.rate, now.rate) / 2;
    step_energy.strain  = dot(now.eta, K_eta) / 2 + residual_energy();
  }



  double
  ReducedMotion::residual_energy() const
  {
    const Vector ahead =
                   sum(sum(now.forces, 1., now.forces), -1., now.forces_before),
                 u_ahead =
                   sum(sum(residual, 1., residual), -1., residual_before);
    return (dot(now.forces, residual) + dot(ahead, u_ahead)) / 4;
  }



  const StepEnergy &
  ReducedMotion::end_step(const Vector &forces)
  {
    if (!begun)
      throw std::logic_error("No step of the reduced bodies has begun.");
    begun                    = false;
    const Past       weight  = past(continues);
    const StepEnergy stored  = step_energy;
    const double     pressed = residual_energy();
    const Vector     eta = now.eta, K_before = K_eta;
    const Vector     loads = product(shapes, forces);
    const Vector rate = sum(free_rate, h / 2, product(inverse, loads)); // v_m
    const Vector u    = product(pair.W_res, forces);

    Vector give(u.size()), bend_force(u.size()), bend(u.size());
    for (std::size_t i = 0; i < u.size(); ++i)
      {
        give[i] = velocity_factor * u[i] - weight.before * residual[i] -
                  weight.earlier * residual_before[i]; // h times its rate
        bend_force[i] = forces[i] - 2 * now.forces[i] + now.forces_before[i];
        bend[i]       = u[i] - 2 * residual[i] + residual_before[i];
      }
    velocity = sum(product(pair.Phi, rate), 1 / h, give);

    now.eta           = sum(eta, h, rate);
    now.rate          = sum(sum(rate, 1., rate), -1., now.rate);
    now.forces_before = continues ? now.forces : forces;
    residual_before   = continues ? residual : u;
    now.forces        = forces;
    residual          = u;
    now.distance      = now.last_step > 0. ? (h + now.last_step) / 2 : h;
    now.last_step     = h;

    find_energy();
    StepEnergy &energy  = step_energy;
    energy.contact_work = h * dot(rate, loads) + dot(forces, give);
    energy.load_work    = h * dot(rate, load);
    // with what K_m does beyond its symmetric part, which stores energy
    energy.damping = h * dot(rate, product(pair.C_m, rate)) +
                     (dot(now.eta, K_before) - dot(eta, K_eta)) / 2;
    energy.numerical_dissipation =
      weight.before == 2. ? dot(bend_force, bend) / 4
                          : dot(forces, give) - residual_energy() + pressed;
    energy.balance_error = energy.kinetic + energy.strain - stored.kinetic -
                           stored.strain -
                           (energy.contact_work + energy.load_work -
                            energy.damping - energy.numerical_dissipation);
    return step_energy;
  }



  std::size_t
  ReducedMotion::memory_consumption() const
  {
    std::size_t sum = 0;
    for (const DenseMatrix *M : {&pair.K_m,
                                 &pair.C_m,
                                 &pair.Phi,
                                 &pair.W_res,
                                 &shapes,
                                 &inverse,
                                 &inverse_transposed,
                                 &W})
      sum += M->memory_consumption();
    return sum;
  }
} // namespace RollingContact
