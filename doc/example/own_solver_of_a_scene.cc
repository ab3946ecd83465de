#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/program/scene_reader.h>
#include <rolling_contact/solvers/falling_friction.h>
#include <rolling_contact/solvers/normal_active_set.h>
#include <rolling_contact/solvers/normal_tangential_split.h>
#include <rolling_contact/state/state_finder.h>
#include <rolling_contact/tables/quiet_context.h>

#include <cmath>
#include <cstdio>
#include <iostream>

// A scene file, in 2D or 3D and with any slip operator, solved by the library
// and by a solver of one's own, with constant friction and with a law of one's
// own:  own_solver_of_a_scene FILE.prm [--set "Section/Entry=value"]...

using namespace RollingContact;

namespace
{
  /** drop(v) = A 2 / pi atan(v / v_c). */
  class ArcTangent : public FrictionLaw
  {
  public:
    ArcTangent(const double A, const double v_c)
      : A(A)
      , v_c(v_c)
    {}

    double drop(const double v) const override
    {
      return A * 2 / M_PI * std::atan(v / v_c);
    }

    double slope(const double v) const override
    {
      return A * 2 / M_PI * v_c / (v_c * v_c + v * v);
    }

    double decay_speed() const override
    {
      return v_c;
    }

  private:
    const double A, v_c;
  };

  /**
   * Traction at a given pressure by the splitting of Douglas and Rachford, for
   * the slip s(q) = s(0) + S q and the discs |q| <= mu p:
   *
   *   q = Proj z,   x = (I + r S)^-1 (2 q - z - r s(0)),   z += x - q.
   *
   * Converges for any monotone S; one factor, one dense product an iteration.
   */
  class Splitting : public TangentialSolver
  {
  public:
    using TangentialSolver::TangentialSolver;

    SolverReport solve(const TangentialProblem &friction,
                       ContactState            &state) const override
    {
      SolverReport report;
      report.solver                 = "splitting";
      NodalField             &q     = state.traction;
      std::vector<NodalIndex> nodes = carrying(friction, q.n_components());
      const std::size_t       n     = nodes.size();
      const NodalField        zero(q.n_nodes(), q.n_components()),
        slip              = friction.slip(zero);
      const double      r = 10. / friction.contact.operators.tangential_norm();
      const DenseMatrix inverse = resolvent(friction.slip_compliance(nodes), r);
      friction.project(q);
      NodalField z = q;
      while (true)
        {
          q = z;
          friction.project(q);
          if (ends_with(friction.residual(q, friction.slip(q)), report))
            return report;
          if (report.iterations++ == controls.max_iterations)
            break;
          std::vector<double> b(n);
          for (std::size_t k = 0; k < n; ++k)
            {
              const auto [c, i] = nodes[k];
              b[k]              = 2 * q(c, i) - z(c, i) - r * slip(c, i);
            }
          const std::vector<double> x = inverse * b;
          for (std::size_t k = 0; k < n; ++k)
            {
              const auto [c, i] = nodes[k];
              z(c, i) += x[k] - q(c, i);
            }
        }
      report.reason = "the splitting reached its limit";
      return report;
    }

  private:
    /** The tractions that are not zero by their bound. */
    static std::vector<NodalIndex> carrying(const TangentialProblem &friction,
                                            const unsigned int       components)
    {
      std::vector<NodalIndex> nodes;
      for (unsigned int i = 0; i < friction.bound.size(); ++i)
        for (unsigned int c = 0; c < components; ++c)
          if (friction.bound[i] > 0.)
            nodes.push_back({c, i});
      return nodes;
    }

    /** (I + r S)^-1. */
    static DenseMatrix resolvent(DenseMatrix S, const double r)
    {
      DenseMatrix inverse = DenseMatrix::Identity(S.rows(), S.cols());
      S                   = r * S + inverse;
      solve_general(S, inverse);
      return inverse;
    }
  };

  /** Pressure by the library, traction by the splitting, edges settled. */
  std::unique_ptr<ContactSolver> own_solver(const SolverControls &controls)
  {
    std::vector<std::unique_ptr<TangentialSolver>> tangential;
    tangential.push_back(std::make_unique<Splitting>(controls));
    return std::make_unique<FallingFriction>(
      std::make_unique<NormalTangentialSplit>(std::make_unique<NormalActiveSet>(
                                                controls),
                                              std::move(tangential),
                                              controls),
      controls);
  }

  void print(const char           *name,
             const ContactProblem &problem,
             const ContactSolver  &solver)
  {
    ContactState       state  = open_state(problem);
    const SolverReport report = solver.solve(problem, state);
    const Resultants   result = resultants(problem, state);
    std::printf("%-18s T = (%.3f, %.3f) N, %s, residual %.0e, %u iterations\n",
                name,
                result.force_x,
                result.force_y,
                report.converged ? "converged" : report.reason.c_str(),
                report.residual.worst(),
                report.iterations);
  }

  template <int dim>
  void compare(const Situation &scene)
  {
    QuietContext   context(&std::cerr);
    ContactProblem problem =
      solve_steady_state<dim>(scene, StateDemands(), context.run).problem;
    const SolverControls controls;
    const auto           library = make_contact_solver("automatic", controls),
               own               = own_solver(controls);
    print("scene, library", problem, *library);
    print("scene, own", problem, *own);
    problem.loads.friction_law = std::make_shared<ArcTangent>(0.4, 0.1);
    problem.loads.speed        = 10.; // m/s
    print("own law, library", problem, *library);
    print("own law, own", problem, *own);
  }
} // namespace

int main(const int argc, const char *const *argv)
{
  try
    {
      const SceneInput input = read_scene(CommandLine(argc, argv));
      for (const std::string &warning : input.warnings)
        std::cerr << "Warning: " << warning << '\n';
      input.scene.dimension == 2 ? compare<2>(input.scene)
                                 : compare<3>(input.scene);
    }
  catch (const std::exception &error) // InputError, ConvergenceError, ...
    {
      std::cerr << error.what() << '\n';
      return 1;
    }
}
