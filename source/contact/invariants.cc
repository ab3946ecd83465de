#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/contact/invariants.h>
#include <rolling_contact/contact/tangential_problem.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /**
     * max(0, x) that keeps what is not a number.
     */
    double excess(const double x)
    {
      return x <= 0. ? 0. : x;
    }

    double ratio(const double value, const double scale)
    {
      return value == 0. ? 0. : value / scale;
    }

    void add_normal(const ContactProblem &problem,
                    const ContactState   &state,
                    Invariants           &result)
    {
      const std::vector<double> u_n  = normal_gap(problem, state);
      const double              rho  = problem.operators.normal_norm() > 0.
                                         ? 1 / problem.operators.normal_norm()
                                         : 0.;
      const double              load = problem.operators.load(state.pressure);
      double                    largest = 0.;
      for (unsigned int i = 0; i < problem.n_nodes(); ++i)
        {
          const double area = problem.operators.areas()[i],
                       p = state.pressure[i], distance = rho * u_n[i];
          largest = std::max({largest, p, distance});
          result.pull += area * excess(-p);
          result.overlap += area * excess(-distance);
          result.complementarity += area * excess(p) * excess(distance);
        }
      const double scale     = problem.loads.normal_load.value_or(load);
      result.pull            = ratio(result.pull, scale);
      result.overlap         = ratio(result.overlap, scale);
      result.complementarity = ratio(result.complementarity, scale * largest);
      if (problem.loads.normal_load)
        result.load = ratio(std::abs(load - scale), scale);
    }

    void add_friction(const ContactProblem &problem,
                      const ContactState   &state,
                      Invariants           &result)
    {
      const TangentialProblem friction = tangential_problem(problem, state);
      const double            norm     = problem.operators.tangential_norm();
      NodalField              slip     = friction.slip(state.traction);
      slip *= norm > 0. ? 1 / norm : 0.; // in Pa
      double largest = 0.;
      for (unsigned int i = 0; i < problem.n_nodes(); ++i)
        {
          double power = 0.;
          for (unsigned int c = 0; c < problem.n_tangential(); ++c)
            power += state.traction(c, i) * slip(c, i);
          const double area  = problem.operators.areas()[i],
                       bound = friction.bound[i];
          largest            = std::max(largest, bound + slip.norm_at(i));
          result.cone += area * excess(state.traction.norm_at(i) - bound);
          result.friction_power += area * excess(power);
        }
      const double scale    = problem.operators.resultant(friction.bound);
      result.cone           = ratio(result.cone, scale);
      result.friction_power = ratio(result.friction_power, scale * largest);
    }

    /**
     * r . W r of the nodal forces r = H (q, p), negative share over the sum of
     * the sizes of its terms.
     */
    double negative_energy(const ContactProblem &problem,
                           const ContactState   &state)
    {
      const std::vector<double> forces        = nodal_forces(problem, state);
      const std::vector<double> displacements = problem.operators.W() * forces;
      double                    energy = 0., size = 0.;
      for (std::size_t i = 0; i < forces.size(); ++i)
        {
          energy += forces[i] * displacements[i];
          size += std::abs(forces[i] * displacements[i]);
        }
      return ratio(excess(-energy), size);
    }
  } // namespace

  std::vector<std::pair<std::string, double>> Invariants::named() const
  {
    return {{"pull", pull},
            {"overlap", overlap},
            {"complementarity", complementarity},
            {"cone", cone},
            {"friction_power", friction_power},
            {"load", load},
            {"elastic_energy", elastic_energy}};
  }

  std::pair<std::string, double> Invariants::worst() const
  {
    std::pair<std::string, double> result{"none", 0.};
    for (const auto &invariant : named())
      {
        if (!std::isfinite(invariant.second))
          return invariant;
        if (invariant.second > result.second)
          result = invariant;
      }
    return result;
  }

  Invariants invariants(const ContactProblem &problem,
                        const ContactState   &state)
  {
    Invariants result;
    add_normal(problem, state, result);
    if (problem.n_tangential() > 0)
      add_friction(problem, state, result);
    result.elastic_energy = negative_energy(problem, state);
    return result;
  }

  double invariant_limit(const double tolerance)
  {
    const double rounding = 1e-12;
    return tolerance + rounding;
  }

  void check_invariants(const Invariants  &found,
                        const double       tolerance,
                        const std::string &where)
  {
    const auto   worst = found.worst();
    const double limit = invariant_limit(tolerance);
    if (worst.second <= limit)
      return;
    throw ConvergenceError(where + "the invariant `" + worst.first +
                           "` is broken: " + scientific(worst.second, 3) +
                           ", allowed " + scientific(limit, 3) +
                           ". The numbers of this state are wrong.");
  }
} // namespace RollingContact
