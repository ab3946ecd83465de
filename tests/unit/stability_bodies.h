#ifndef rolling_contact_tests_stability_bodies_h
#define rolling_contact_tests_stability_bodies_h

#include <boost/test/unit_test.hpp>

#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/solvers/contact_solver.h>
#include <rolling_contact/stability/linear_contact.h>
#include <rolling_contact/stability/pencil.h>

#include <cmath>
#include <memory>
#include <random>

/** Small bodies in rolling contact, without a mesh. */
namespace StabilityBodies
{
  using namespace RollingContact;

  /**
   * A grid of nodes along x, and across in 3D.
   */
  struct Grid
  {
    unsigned int n_x = 7, n_y = 1; ///< n_y = 1: 2D
    double       size = 1e-3;      ///< of elements, m

    unsigned int n_tangential() const
    {
      return n_y == 1 ? 1 : 2;
    }

    unsigned int n_nodes() const
    {
      return n_x * n_y;
    }

    Trace trace() const
    {
      Trace trace;
      trace.n_dimensions = n_tangential();
      for (unsigned int j = 0; j < n_y; ++j)
        for (unsigned int i = 0; i < n_x; ++i)
          trace.nodes.push_back(
            {{size * (i - 0.5 * (n_x - 1)),
              n_y == 1 ? 0. : size * (j - 0.5 * (n_y - 1))}});
      for (unsigned int j = 0; j + 1 < std::max(n_y, 2u); ++j)
        for (unsigned int i = 0; i + 1 < n_x; ++i)
          {
            const unsigned int k = j * n_x + i;
            if (n_y == 1)
              trace.cells.push_back({trace.nodes[k],
                                     {{trace.nodes[k + 1][0], 1.}},
                                     {{{k, 1.}}, {{k + 1, 1.}}}});
            else
              trace.cells.push_back({trace.nodes[k],
                                     trace.nodes[k + n_x + 1],
                                     {{{k, 1.}},
                                      {{k + 1, 1.}},
                                      {{k + n_x, 1.}},
                                      {{k + n_x + 1, 1.}}}});
          }
      return trace;
    }
  };

  /**
   * Compliance of a half-space under nodal forces that stand on circles of one
   * node's area (Boussinesq, Cerruti): tangential components first.
   */
  inline DenseMatrix
  half_space(const Grid &grid, const double shear, const double poisson)
  {
    const Trace        trace = grid.trace();
    const unsigned int n = grid.n_nodes(), T = grid.n_tangential();
    const double       a = grid.size / std::sqrt(pi), f = 1 / (2 * pi * shear);
    DenseMatrix        W = DenseMatrix::Zero((T + 1) * n, (T + 1) * n);
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        {
          const double x          = trace.nodes[i][0] - trace.nodes[j][0],
                       y          = trace.nodes[i][1] - trace.nodes[j][1],
                       r          = std::hypot(x, y);
          const double one_over_r = i == j ? 2 / a : 1 / r;
          const double xx   = i == j ? one_over_r / 2 : x * x / (r * r * r),
                       yy   = i == j ? one_over_r / 2 : y * y / (r * r * r),
                       xy   = i == j ? 0. : x * y / (r * r * r);
          const double skew = i == j ? 0. : (1 - 2 * poisson) / 2 / (r * r);
          W(i, j)           = f * ((1 - poisson) * one_over_r + poisson * xx);
          W(T * n + i, T * n + j) = f * (1 - poisson) * one_over_r;
          W(i, T * n + j)         = -0.3 * f * skew * x;
          W(T * n + i, j)         = 0.3 * f * skew * x;
          if (T == 2)
            {
              W(n + i, n + j) = f * ((1 - poisson) * one_over_r + poisson * yy);
              W(i, n + j) = W(n + i, j) = f * poisson * xy;
              W(n + i, 2 * n + j)       = -0.3 * f * skew * y;
              W(2 * n + i, n + j)       = 0.3 * f * skew * y;
            }
        }
    return W;
  }

  /**
   * Steady rolling of a pair whose modes add to the compliance of the contact.
   */
  struct RollingState
  {
    ContactProblem problem;
    ContactState   state;
    bool           converged = false;

    void solve()
    {
      SolverControls controls;
      controls.tolerance = 1e-12;
      state              = {};
      converged          = make_contact_solver("automatic", controls)
                    ->solve(problem, state)
                    .converged;
    }

    /** From the state that there is, with its edges and cubics. */
    void solve_holding_scheme()
    {
      SolverControls controls;
      controls.tolerance = 1e-12;
      state.holds_scheme = true;
      converged          = make_contact_solver("automatic", controls)
                    ->solve(problem, state)
                    .converged;
    }
  };

  /**
   * W_res + Phi K^-1 Phi^T.
   */
  inline DenseMatrix static_compliance(const ReducedPair &pair)
  {
    DenseMatrix K = pair.K_m, X = pair.Phi.transpose();
    solve_general(K, X);
    return pair.W_res + pair.Phi * X;
  }

  inline ContactProblem
  rolling_problem(const Grid            &grid,
                  DenseMatrix            W,
                  const double           mu,
                  const Creepages       &creepages,
                  const double           approach,
                  const SlipOperatorKind kind = SlipOperatorKind::upwind_2,
                  const int              flow = 1)
  {
    ContactProblem problem;
    const Trace    trace = grid.trace();
    problem.operators    = ContactOperators(
      trace.nodes,
      contact_matrix(trace, ContactMatrices::lumped, grid.size),
      std::move(W),
      SlipOperator(trace, kind, ContactMatrices::lumped, flow));
    for (const auto &node : trace.nodes)
      problem.loads.gap.push_back(
        (node[0] * node[0] + 1.3 * node[1] * node[1]) / 2 / 0.3);
    problem.loads.friction.assign(trace.nodes.size(), mu);
    problem.loads.creepages = creepages;
    problem.loads.approach  = approach;
    return problem;
  }

  /**
   * Modes of random shape on the contact, as smooth as those of bodies: each a
   * motion and a turn of the patch.
   */
  inline ReducedPair random_pair(const Grid        &grid,
                                 const unsigned int n_modes,
                                 const unsigned int seed,
                                 const double       damping_ratio = 1e-3,
                                 const double       mobility      = 0.03)
  {
    std::mt19937                           generator(seed);
    std::uniform_real_distribution<double> uniform(0., 1.);
    std::normal_distribution<double>       normal;
    const Trace                            trace = grid.trace();
    const unsigned int N = grid.n_nodes(), T = grid.n_tangential();
    ReducedPair        pair;
    pair.K_m = pair.C_m = DenseMatrix::Zero(n_modes, n_modes);
    pair.Phi            = DenseMatrix::Zero((T + 1) * N, n_modes);
    pair.W_res          = half_space(grid, 80e9, 0.3);
    pair.n_wheel_modes  = n_modes / 2;
    for (unsigned int k = 0; k < n_modes; ++k)
      {
        const double omega =
          2 * pi * (200. + 5800. * (k + 0.8 * uniform(generator)) / n_modes);
        pair.K_m(k, k) = omega * omega;
        pair.C_m(k, k) = 2 * damping_ratio * omega * (0.1 + uniform(generator));
        for (unsigned int c = 0; c <= T; ++c)
          {
            const double mean = mobility * normal(generator),
                         in_x = mobility * normal(generator) / 0.05,
                         in_y = mobility * normal(generator) / 0.05;
            for (unsigned int i = 0; i < N; ++i)
              pair.Phi(c * N + i, k) =
                mean + in_x * trace.nodes[i][0] + in_y * trace.nodes[i][1];
          }
      }
    return pair;
  }
  /**
   * Steady rolling of a pair under a load of 4 kN.
   */
  inline RollingState rolling_state(const Grid        &grid,
                                    const ReducedPair &pair,
                                    const double       mu,
                                    const Creepages   &creepages)
  {
    RollingState rolling{
      rolling_problem(grid, static_compliance(pair), mu, creepages, 0.), {}};
    rolling.problem.loads.normal_load = 4e3;
    rolling.solve();
    BOOST_TEST(rolling.converged);
    return rolling;
  }

  const double speed = 10.; ///< m/s

  inline LinearContactOptions
  at_speed(const FrictionResponse friction = FrictionResponse::constant)
  {
    LinearContactOptions options;
    options.speed    = speed;
    options.friction = friction;
    return options;
  }

  inline std::complex<double> nearest(const ComplexValues       &values,
                                      const std::complex<double> s)
  {
    std::complex<double> best = values.at(0);
    for (const auto &value : values)
      if (std::abs(value - s) < std::abs(best - s))
        best = value;
    return best;
  }
} // namespace StabilityBodies

#endif
