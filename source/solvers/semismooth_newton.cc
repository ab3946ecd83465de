#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/solvers/extragradient.h>
#include <rolling_contact/solvers/semismooth_newton.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace RollingContact
{
  namespace
  {
    /**
     * The touching unknowns, both components of a node side by side.
     */
    std::vector<NodalIndex> touching_unknowns(const TangentialProblem &problem)
    {
      std::vector<NodalIndex> unknowns;
      for (unsigned int i = 0; i < problem.contact.n_nodes(); ++i)
        if (problem.bound[i] > 0.)
          for (unsigned int c = 0; c < 2; ++c)
            unknowns.push_back({c, i});
      return unknowns;
    }

    std::vector<double> gathered(const std::vector<NodalIndex> &unknowns,
                                 const NodalField              &field)
    {
      std::vector<double> values;
      for (const NodalIndex &unknown : unknowns)
        values.push_back(field[unknown]);
      return values;
    }

    void scatter(const std::vector<NodalIndex> &unknowns,
                 const std::vector<double>     &values,
                 NodalField                    &field)
    {
      for (std::size_t k = 0; k < unknowns.size(); ++k)
        field[unknowns[k]] = values[k];
    }

    /**
     * The frictional problem on the touching unknowns alone.
     */
    struct TouchingProblem
    {
      explicit TouchingProblem(const TangentialProblem &problem)
        : unknowns(touching_unknowns(problem))
        , slip_compliance(problem.slip_compliance(unknowns))
        , norm(problem.contact.operators.tangential_norm())
        , friction_force(problem.contact.operators.resultant(problem.bound))
      {
        const NodalField no_traction(problem.contact.n_nodes(), 2);
        slip_at_zero = gathered(unknowns, problem.slip(no_traction));
        for (const NodalIndex &unknown : unknowns)
          {
            bound.push_back(problem.bound[unknown.node]);
            area.push_back(problem.contact.operators.areas()[unknown.node]);
          }
      }

      std::vector<double> slip(const std::vector<double> &traction) const
      {
        return sum(slip_compliance * traction, 1., slip_at_zero);
      }

      /**
       * Cut the nodal tractions back to the traction bound.
       */
      void project(std::vector<double> &traction) const
      {
        for (std::size_t k = 0; k < traction.size(); k += 2)
          {
            const double size = std::hypot(traction[k], traction[k + 1]);
            if (size > bound[k])
              for (unsigned int c = 0; c < 2; ++c)
                traction[k + c] *= bound[k] / size;
          }
      }

      /**
       * The natural residual, over mu N.
       */
      double residual(const std::vector<double> &traction) const
      {
        const std::vector<double> s   = slip(traction);
        double                    sum = 0.;
        for (std::size_t k = 0; k < traction.size(); k += 2)
          {
            const double x     = traction[k] - s[k] / norm,
                         y     = traction[k + 1] - s[k + 1] / norm;
            const double size  = std::hypot(x, y),
                         scale = size > bound[k] ? bound[k] / size : 1.;
            sum += area[k] * (std::abs(traction[k] - scale * x) +
                              std::abs(traction[k + 1] - scale * y));
          }
        return sum / friction_force;
      }

      std::vector<NodalIndex> unknowns;
      DenseMatrix             slip_compliance; ///< 1/Pa
      double                  norm;            ///< 1/Pa
      double                  friction_force;  ///< N
      std::vector<double>     slip_at_zero, bound, area;
    };

    /**
     * An unknown of a Newton step: how far the traction of a node goes in a
     * direction. A node that sticks has two of them, one that slides the one
     * along its bound, as the step across is known.
     */
    struct NewtonUnknown
    {
      std::size_t           first; ///< of the node's two tractions
      std::array<double, 2> direction;
      double                weight, diagonal; ///< of its row

      double along(const std::vector<double> &values) const
      {
        return direction[0] * values[first] + direction[1] * values[first + 1];
      }
    };

    /**
     * The unknowns, and @p right: of nodes that stick -rho s, of those that
     * slide the step across the bound, which is in @p known as well.
     */
    std::vector<NewtonUnknown>
    newton_unknowns(const TouchingProblem     &problem,
                    const std::vector<double> &traction,
                    const double               rho,
                    std::vector<double>       &right,
                    std::vector<double>       &known)
    {
      const std::vector<double> slip = problem.slip(traction);
      right.assign(traction.size(), 0.);
      known.assign(traction.size(), 0.);
      std::vector<NewtonUnknown> unknowns;
      for (std::size_t k = 0; k < traction.size(); k += 2)
        {
          const std::array<double, 2> z{
            {traction[k] - rho * slip[k], traction[k + 1] - rho * slip[k + 1]}};
          const double size = std::hypot(z[0], z[1]);
          if (size <= problem.bound[k])
            {
              right[k]     = -rho * slip[k];
              right[k + 1] = -rho * slip[k + 1];
              unknowns.push_back({k, {{1., 0.}}, 1., 0.});
              unknowns.push_back({k, {{0., 1.}}, 1., 0.});
              continue;
            }
          const double scale = problem.bound[k] / size;
          for (unsigned int c = 0; c < 2; ++c)
            right[k + c] = known[k + c] = scale * z[c] - traction[k + c];
          unknowns.push_back(
            {k, {{-z[1] / size, z[0] / size}}, scale, 1 - scale});
        }
      return unknowns;
    }

    /**
     * The Newton step of the traction; false if the matrix is singular. With r
     * the right hand side, A the compliance and D = mu p/|z| t t^T the
     * derivative of the projection, t along the bound: rho A dq = r of nodes
     * that stick, and dq + D (rho A dq - dq) = r, so dq = r + alpha t, of those
     * that slide.
     */
    bool newton_step(const TouchingProblem     &problem,
                     const std::vector<double> &traction,
                     const double               rho,
                     std::vector<double>       &step)
    {
      const DenseMatrix  &A = problem.slip_compliance;
      std::vector<double> right, known;
      const auto          unknowns =
        newton_unknowns(problem, traction, rho, right, known);
      const std::size_t         n = traction.size(), m = unknowns.size();
      const std::vector<double> slip_of_known = A * known;
      std::vector<double>       column(n);
      DenseMatrix               matrix(m, m);
      Eigen::VectorXd           solution(m);
      for (std::size_t j = 0; j < m; ++j)
        {
          const NewtonUnknown &of = unknowns[j];
          as_vector(column)       = of.direction[0] * A.col(of.first) +
                              of.direction[1] * A.col(of.first + 1);
          for (std::size_t i = 0; i < m; ++i)
            matrix(i, j) = unknowns[i].weight * rho * unknowns[i].along(column);
          matrix(j, j) += of.diagonal;
          solution[j] =
            of.weight * (of.along(right) - rho * of.along(slip_of_known));
        }
      if (!solve_general(matrix, solution))
        return false;
      step = known;
      for (std::size_t j = 0; j < m; ++j)
        for (unsigned int c = 0; c < 2; ++c)
          step[unknowns[j].first + c] += solution[j] * unknowns[j].direction[c];
      return true;
    }

    /**
     * Add the part 1, 1/2, ..., 1/64 of a step to the traction, cut back to the
     * traction bound: the first that lowers the residual by a tenth of the
     * part, else the best of them. Tractions beyond the bound, which a full
     * step may have tenfold, would be where the step's linearisation does not
     * hold.
     */
    void take_damped_step(const TouchingProblem     &problem,
                          const std::vector<double> &step,
                          const double               residual_now,
                          std::vector<double>       &traction)
    {
      const std::vector<double> start = traction;
      std::vector<double>       best_traction;
      double                    best = std::numeric_limits<double>::infinity();
      for (double part = 1.; part > 0.01; part /= 2)
        {
          for (std::size_t k = 0; k < traction.size(); ++k)
            traction[k] = start[k] + part * step[k];
          problem.project(traction);
          const double now = problem.residual(traction);
          if (now < (1 - 0.1 * part) * residual_now)
            return;
          if (best_traction.empty() || now < best)
            {
              best          = now;
              best_traction = traction;
            }
        }
      traction = best_traction;
    }

    /**
     * The traction on the way down, and the best so far.
     */
    class Descent
    {
    public:
      explicit Descent(std::vector<double> start)
        : q(std::move(start))
        , best_q(q)
      {}

      /**
       * The residual of q.
       */
      void note(const double residual)
      {
        const bool lower = residual < best;
        n_stalled        = lower ? 0 : n_stalled + 1;
        if (!lower)
          return;
        best   = residual;
        best_q = q;
      }

      /**
       * Go on from another traction, whatever its residual.
       */
      void restart(std::vector<double> other)
      {
        q         = std::move(other);
        n_stalled = 0;
        best      = std::numeric_limits<double>::infinity();
      }

      std::vector<double> q, best_q;
      unsigned int        n_stalled = 0;

    private:
      double best = std::numeric_limits<double>::infinity();
    };
  } // namespace

  SolverReport SemismoothNewton::solve(const TangentialProblem &problem,
                                       ContactState            &state) const
  {
    const unsigned int max_steps = 60, patience = 6, max_rescues = 4;
    SolverReport       report;
    report.solver = "active set";
    problem.project(state.traction);
    const TouchingProblem touching(problem);
    if (touching.unknowns.empty() || touching.norm == 0.)
      {
        report.converged = true;
        return report;
      }
    const double rho = controls.tangential_augmentation / touching.norm;
    Descent      way(gathered(touching.unknowns, state.traction));
    // a slip too small for the tolerance still gets its traction
    const bool   from_rest = std::all_of(way.q.begin(),
                                       way.q.end(),
                                       [](const double x) { return x == 0.; });
    unsigned int n_rescues = 0;
    for (unsigned int k = 0; k <= max_steps; ++k)
      {
        const double now           = touching.residual(way.q);
        report.residual.tangential = now;
        report.history.push_back(report.residual);
        if (now <= 0.5 * controls.tolerance &&
            (k > 0 || !from_rest || now == 0.))
          {
            scatter(touching.unknowns, way.q, state.traction);
            report.converged = true;
            return report;
          }
        way.note(now);
        if (n_rescues > max_rescues || (k == 0 && !std::isfinite(now)))
          break;
        if (way.n_stalled > patience || !std::isfinite(now))
          {
            const unsigned int n_steps = 20u << n_rescues++;
            scatter(touching.unknowns, way.best_q, state.traction);
            report.iterations += rescue(problem, n_steps, state);
            way.restart(gathered(touching.unknowns, state.traction));
            continue;
          }
        std::vector<double> step;
        if (!newton_step(touching, way.q, rho, step))
          break;
        take_damped_step(touching, step, now, way.q);
        ++report.iterations;
        ++report.tangential_solves;
      }
    scatter(touching.unknowns, way.best_q, state.traction);
    report.reason = "the semismooth Newton iteration stopped falling";
    return report;
  }

  unsigned int SemismoothNewton::rescue(const TangentialProblem &problem,
                                        const unsigned int       n_steps,
                                        ContactState            &state) const
  {
    SolverControls few = controls;
    few.max_iterations = n_steps;
    return Extragradient(few).solve(problem, state).iterations;
  }
} // namespace RollingContact
