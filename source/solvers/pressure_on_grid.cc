#include <rolling_contact/solvers/pressure_on_grid.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /**
     * The quadratic problem on the active nodes. Vectors are of all nodes, and
     * zero on those that are not active.
     */
    class ForcesOnActive
    {
    public:
      ForcesOnActive(const ContactProblem      &problem,
                     const std::vector<double> &gap,
                     const std::vector<bool>   &active)
        : problem(problem)
        , gap(gap)
        , active(active)
        , grid(*problem.operators.W().on_grid())
        , component(problem.n_tangential())
        , share(problem.n_nodes(), 0.)
      {
        for (std::size_t i = 0; i < share.size(); ++i)
          if (active[i])
            share[i] = problem.operators.approach_share(i);
        forces_for_share = on_active(grid.forces_for(share, component));
      }

      /** f of the state's pressure, with the load that is given. */
      std::vector<double> start(const ContactState &state) const
      {
        std::vector<double> f =
          on_active(problem.operators.H().multiply(state.pressure));
        const auto &load = problem.loads.normal_load;
        if (!load)
          return f;
        const double now = dot(share, f);
        if (now > 0.)
          as_vector(f) *= *load / now;
        else
          as_vector(f) = as_vector(share) * (*load / dot(share, share));
        return f;
      }

      std::vector<double> displacement(const std::vector<double> &f) const
      {
        return on_active(grid.product(f, component, component, component + 1));
      }

      /**
       * A direction of forces that keeps the load, from the displacements that
       * are wanted; the approach that goes with it is added to @p approach.
       */
      std::vector<double> direction(const std::vector<double> &wanted,
                                    double                    &approach) const
      {
        std::vector<double> z = on_active(grid.forces_for(wanted, component));
        if (!problem.loads.normal_load)
          return z;
        const double change = dot(share, z) / dot(share, forces_for_share);
        as_vector(z) -= change * as_vector(forces_for_share);
        approach -= change;
        return z;
      }

      std::vector<double> on_active(std::vector<double> values) const
      {
        for (std::size_t i = 0; i < values.size(); ++i)
          if (!active[i])
            values[i] = 0.;
        return values;
      }

      const ContactProblem      &problem;
      const std::vector<double> &gap;
      const std::vector<bool>   &active;
      const GridCompliance      &grid;
      const unsigned int         component;
      std::vector<double>        share, forces_for_share;
    };
  } // namespace

  bool solve_pressure_on_grid(const ContactProblem      &problem,
                              const std::vector<double> &gap,
                              const std::vector<bool>   &active,
                              ContactState              &state)
  {
    const unsigned int   max_iterations = 500;
    const ForcesOnActive on(problem, gap, active);
    std::vector<double>  f = on.start(state), u = on.displacement(f), p;
    double               old = 1.;
    for (unsigned int k = 0; k < max_iterations; ++k)
      {
        // what closes the gaps; the approach is the multiplier of the load
        std::vector<double> r(f.size());
        double              largest = 0., left = 0.;
        for (std::size_t i = 0; i < r.size(); ++i)
          if (active[i])
            {
              r[i]    = state.approach * on.share[i] - gap[i] - u[i];
              largest = std::max({largest, std::abs(u[i]), std::abs(r[i])});
            }
        double                    change = 0.;
        const std::vector<double> z      = on.direction(r, change);
        state.approach += change;
        for (std::size_t i = 0; i < r.size(); ++i)
          left = std::max(left, std::abs(r[i] + change * on.share[i]));
        if (left <= gap_left_on_grid * largest)
          {
            state.pressure.assign(problem.n_nodes(), 0.);
            for (std::size_t i = 0; i < f.size(); ++i)
              if (active[i])
                state.pressure[i] = f[i] / problem.operators.areas()[i];
            return true;
          }
        const double now = dot(r, z);
        if (!(now > 0.))
          return false;
        p                              = k == 0 ? z : sum(z, now / old, p);
        old                            = now;
        const std::vector<double> Wp   = on.displacement(p);
        const double              step = now / dot(p, Wp);
        as_vector(f) += step * as_vector(p);
        as_vector(u) += step * as_vector(Wp);
      }
    return false;
  }
} // namespace RollingContact
