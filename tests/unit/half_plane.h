#ifndef rolling_contact_tests_half_plane_h
#define rolling_contact_tests_half_plane_h

#include <rolling_contact/base/constants.h>
#include <rolling_contact/contact/resultants.h>
#include <rolling_contact/contact/slip_operator.h>
#include <rolling_contact/solvers/contact_solver.h>

#include <cmath>

namespace HalfPlane
{
  using namespace RollingContact;

  const double mu = 0.3;

  /**
   * Displacement of node i for a unit force at node j of a half-plane, linear
   * tractions between nodes of spacing @p h; half-width, peak pressure and
   * relative radius one, E* = 2. Normal and tangential alike.
   */
  inline double half_plane(const int i, const int j, const double h)
  {
    const auto second_antiderivative = [](const double x) {
      return x == 0. ? 0. : 0.5 * x * x * std::log(std::abs(x)) - 0.75 * x * x;
    };
    const double d = h * (i - j);
    return (-(second_antiderivative(d + h) - 2 * second_antiderivative(d) +
              second_antiderivative(d - h)) /
              h +
            3 * h) /
           pi / h;
  }

  struct Options
  {
    unsigned int     n_elements  = 40;
    double           offset      = 0.3;
    double           creepage    = 0.4; ///< over saturation
    SlipOperatorKind kind        = SlipOperatorKind::calibrated;
    int              flow        = 1;
    double           coupling    = 0.; ///< Dundurs' beta
    bool             friction    = true;
    double           length_unit = 1., pressure_unit = 1.;
    NodalForces      forces = NodalForces::of_elements; ///< taken for
  };

  /**
   * Hertz and Carter on half-planes, p0 = a = R = 1, E* = 2, load pi/2.
   */
  inline ContactProblem half_plane_problem(const Options &options)
  {
    const double       h = 2. / options.n_elements * options.length_unit;
    const unsigned int n = 1.6 * options.n_elements;
    Trace              trace;
    for (unsigned int i = 0; i < n; ++i)
      trace.nodes.push_back({{h * (i - 0.5 * (n - 1) + options.offset), 0.}});
    for (unsigned int i = 0; i + 1 < n; ++i)
      trace.cells.push_back({trace.nodes[i],
                             {{trace.nodes[i + 1][0], 1.}},
                             {{{i, 1.}}, {{i + 1, 1.}}}});
    const unsigned int n_blocks = options.friction ? 2 : 1;
    DenseMatrix        W        = DenseMatrix::Zero(n_blocks * n, n_blocks * n);
    const double       scale    = 1 / options.pressure_unit;
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        {
          for (unsigned int c = 0; c < n_blocks; ++c)
            W(c * n + i, c * n + j) =
              scale * half_plane(i, j, 2. / options.n_elements);
          if (options.friction)
            {
              // du_t/dx = -beta p, its mirror image in the other block
              const double step = i == j ? 0. : (i > j ? 0.5 : -0.5);
              W(i, n + j) = W(n + j, i) = -scale * options.coupling * step;
            }
        }
    ContactProblem problem;
    problem.operators =
      ContactOperators(trace.nodes,
                       contact_matrix(trace, ContactMatrices::lumped, 1.),
                       std::move(W),
                       options.friction ? SlipOperator(trace,
                                                       options.kind,
                                                       ContactMatrices::lumped,
                                                       options.flow)
                                        : SlipOperator(),
                       {options.coupling != 0., options.coupling},
                       options.forces);
    for (const auto &node : trace.nodes)
      problem.loads.gap.push_back(node[0] * node[0] / 2 / options.length_unit);
    problem.loads.friction.assign(n, mu);
    problem.loads.creepages = {options.creepage * mu, 0., 0.};
    problem.loads.normal_load =
      pi / 2 * options.length_unit * options.pressure_unit;
    return problem;
  }

  struct Solution
  {
    SolverReport report;
    ContactState state;
    Resultants   result;
  };

  inline Solution solve(const ContactProblem &problem,
                        const std::string    &solver   = "automatic",
                        SolverControls        controls = SolverControls())
  {
    Solution solution;
    solution.report =
      make_contact_solver(solver, controls)->solve(problem, solution.state);
    solution.result = resultants(problem, solution.state);
    return solution;
  }

  inline double carter_force(const double creepage)
  {
    return -(2 * creepage - creepage * creepage);
  }

  inline double force(const Solution &solution)
  {
    return solution.result.force_x / (mu * solution.result.normal_force);
  }
} // namespace HalfPlane

#endif
