#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/vibration/reduced_motion.h>

#include <cmath>
#include <stdexcept>

namespace RollingContact
{
  namespace
  {
    using Vector = std::vector<double>;
  } // namespace

  ReducedMotion::ReducedMotion(ReducedPair bodies)
    : pair(std::move(bodies))
    , shapes(pair.Phi.transpose())
  {
    check(pair);
    const Vector nothing(pair.n_modes(), 0.);
    rest_at(nothing, Vector(pair.W_res.rows(), 0.));
  }

  void ReducedMotion::set_hub_inertia(Vector inertia)
  {
    if (inertia.size() != pair.n_modes())
      throw InputError("The inertia of the hub's motion has " +
                       std::to_string(inertia.size()) +
                       " values, the bodies have " +
                       std::to_string(pair.n_modes()) + " modes.");
    hub_inertia = std::move(inertia);
    begun       = false;
  }

  void ReducedMotion::set_time_step(const double step)
  {
    if (step == h)
      return;
    if (!(step > 0.) || !std::isfinite(step))
      throw InputError("A time step of the reduced bodies is " +
                       significant(step, 6) + " s; it must be above 0.");
    h                   = step;
    begun               = false;
    const std::size_t m = pair.n_modes();
    inverse             = DenseMatrix::Identity(m, m);
    DenseMatrix A       = inverse + h / 2 * pair.C_m + h * h / 4 * pair.K_m;
    if (!solve_general(A, inverse))
      throw ConvergenceError("The matrix of a time step of " +
                             significant(h, 6) +
                             " s of the modes is singular.");
    inverse_transposed  = inverse.transpose();
    const DenseMatrix G = pair.Phi * (inverse * shapes);
    W                   = follows() * pair.W_res +
        h * h / (4 * velocity_factor) * (G + G.transpose());
  }

  void ReducedMotion::rest_at(const Vector &eta, const Vector &forces)
  {
    ReducedState state;
    state.eta    = eta;
    state.rate   = Vector(eta.size(), 0.);
    state.forces = state.forces_before = forces;
    set_state(state);
    rest_load = sum(pair.K_m * eta, -1., shapes * forces);
  }

  void ReducedMotion::set_state(ReducedState state)
  {
    const std::size_t m = pair.n_modes(), n = pair.W_res.rows();
    if (state.eta.size() != m || state.rate.size() != m ||
        state.forces.size() != n || state.forces_before.size() != n)
      throw InputError("A state of reduced bodies has " +
                       std::to_string(state.eta.size()) + " modes and " +
                       std::to_string(state.forces.size()) +
                       " forces, the bodies " + std::to_string(m) + " and " +
                       std::to_string(n) + ".");
    now             = std::move(state);
    begun           = false;
    residual        = pair.W_res * now.forces;
    residual_before = pair.W_res * now.forces_before;
    velocity        = pair.Phi * now.rate;
    step_energy     = {};
    find_energy();
  }

  ReducedMotion::Past ReducedMotion::past(const bool smooth) const
  {
    if (!smooth)
      return {velocity_factor, 0.};
    if (now.last_step == 0.) // at rest before, or a motion of equal steps
      return {2., -0.5};
    const double d = (h + now.last_step) / 2, D = d + now.distance,
                 before = (velocity_factor * D - h) / (D - d);
    return {before, velocity_factor - before};
  }

  void ReducedMotion::begin_step(const bool   smooth,
                                 const double hub_acceleration)
  {
    if (h == 0.)
      throw std::logic_error("Reduced bodies have no time step.");
    load                = hub_acceleration == 0. || hub_inertia.empty()
                            ? rest_load
                            : sum(rest_load, hub_acceleration, hub_inertia);
    const Past   weight = past(smooth);
    const Vector start  = sum(now.rate, h / 2, sum(load, -1., K_eta));
    free_rate           = inverse * start;

    // 2 g_n - g_(n-1) + tau g'
    const double ahead    = smooth ? 1 + pair.retardation / h : 0.;
    const Vector expected = sum(sum(now.forces, ahead, now.forces),
                                -ahead,
                                now.forces_before),
                 loads = shapes * expected, y = inverse * loads,
                 z = inverse_transposed * loads;

    const double part   = h * h / (4 * velocity_factor);
    Vector       amount = sum(now.eta, h / 2, free_rate);
    amount              = sum(std::move(amount), h * h / 4 - part, y);
    free_u              = pair.Phi * sum(std::move(amount), -part, z);

    Vector rate                = sum(free_rate, h / 4, y);
    free_v                     = pair.Phi * sum(std::move(rate), -h / 4, z);
    const Eigen::VectorXd went = (weight.before * as_vector(residual) +
                                  weight.earlier * as_vector(residual_before)) /
                                 h * follows();
    as_vector(free_v) -= went;
    as_vector(free_u) += pair.retardation * went;
    begun     = true;
    continues = smooth;
  }

  void ReducedMotion::find_energy()
  {
    K_eta               = pair.K_m * now.eta;
    step_energy.kinetic = dot(now.rate, now.rate) / 2;
    step_energy.strain  = dot(now.eta, K_eta) / 2 + residual_energy();
  }

  double ReducedMotion::residual_energy() const
  {
    const Vector ahead =
                   sum(sum(now.forces, 1., now.forces), -1., now.forces_before),
                 u_ahead =
                   sum(sum(residual, 1., residual), -1., residual_before);
    return (dot(now.forces, residual) + dot(ahead, u_ahead)) / 4;
  }

  const StepEnergy &ReducedMotion::end_step(const Vector &forces)
  {
    if (!begun)
      throw std::logic_error("No step of the reduced bodies has begun.");
    begun                    = false;
    const Past       weight  = past(continues);
    const StepEnergy stored  = step_energy;
    const double     pressed = residual_energy();
    const Vector     eta = now.eta, K_before = K_eta;
    const Vector     loads = shapes * forces;
    const Vector     rate  = sum(free_rate, h / 2, inverse * loads); // v_m
    Vector           g(forces.size());
    as_vector(g) =
      follows() *
      (as_vector(forces) + pair.retardation / h *
                             (weight.before * as_vector(now.forces) +
                              weight.earlier * as_vector(now.forces_before)));
    const Vector u = pair.W_res * g;

    const Vector bend_force =
                   sum(sum(g, -2., now.forces), 1., now.forces_before),
                 bend = sum(sum(u, -2., residual), 1., residual_before);
    Vector give(u.size()); // h times its rate
    as_vector(give) = velocity_factor * as_vector(u) -
                      weight.before * as_vector(residual) -
                      weight.earlier * as_vector(residual_before);
    velocity = sum(pair.Phi * rate, 1 / h, give);

    now.eta           = sum(eta, h, rate);
    now.rate          = sum(sum(rate, 1., rate), -1., now.rate);
    now.forces_before = continues ? now.forces : g;
    residual_before   = continues ? residual : u;
    now.forces        = g;
    residual          = u;
    now.distance      = now.last_step > 0. ? (h + now.last_step) / 2 : h;
    now.last_step     = h;

    find_energy();
    StepEnergy &energy  = step_energy;
    energy.contact_work = h * dot(rate, loads) + dot(forces, give);
    energy.load_work    = h * dot(rate, load);
    // with what K_m does beyond its symmetric part, which stores energy
    energy.damping = h * dot(rate, pair.C_m * rate) +
                     (dot(now.eta, K_before) - dot(eta, K_eta)) / 2 +
                     dot(sum(forces, -1., g), give);
    energy.numerical_dissipation =
      weight.before == 2. ? dot(bend_force, bend) / 4
                          : dot(g, give) - residual_energy() + pressed;
    energy.balance_error = energy.kinetic + energy.strain - stored.kinetic -
                           stored.strain -
                           (energy.contact_work + energy.load_work -
                            energy.damping - energy.numerical_dissipation);
    return step_energy;
  }

  std::size_t ReducedMotion::memory_consumption() const
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
      sum += RollingContact::memory_consumption(*M);
    return sum;
  }
} // namespace RollingContact
