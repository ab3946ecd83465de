#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/contact/friction_limit.h>
#include <rolling_contact/contact/resultants.h>

#include <cmath>
#include <limits>

namespace RollingContact
{
  std::vector<std::pair<unsigned int, double>>
  asked_components(const AskedForces &forces)
  {
    std::vector<std::pair<unsigned int, double>> asked;
    const std::array<std::optional<double>, 3>   all{
      {forces.x, forces.y, forces.moment}};
    for (unsigned int k = 0; k < all.size(); ++k)
      if (all[k])
        asked.emplace_back(k, *all[k]);
    return asked;
  }

  Creepages unit_creepage(const unsigned int component)
  {
    return {component == 0 ? 1. : 0.,
            component == 1 ? 1. : 0.,
            component == 2 ? 1. : 0.};
  }

  double sliding_resultant(const ContactProblem      &problem,
                           const std::vector<double> &pressure,
                           const unsigned int         component)
  {
    const NodalField slip =
      rigid_slip(problem.operators, unit_creepage(component));
    double sum = 0.;
    for (unsigned int i = 0; i < problem.n_nodes(); ++i)
      sum += problem.operators.areas()[i] * problem.loads.friction[i] *
             pressure[i] * slip.norm_at(i);
    return sum;
  }

  std::array<double, 3>
  plane_resultant_of_pressure(const ContactProblem      &problem,
                              const std::vector<double> &pressure)
  {
    if (problem.operators.frames().is_plane())
      return {};
    ContactState pressed = open_state(problem);
    pressed.pressure     = pressure;
    return plane_resultant(problem, nodal_forces(problem, pressed));
  }

  namespace
  {
    /**
     * The least of the sum of b |s(v)| over v with F . v = 1, by reweighting:
     * |s| is bounded by (|s|^2 / |s_0| + |s_0|) / 2 with the slip s_0 of the
     * last v, and the least of that is a linear system.
     */
    class LeastPower
    {
    public:
      LeastPower(const std::vector<NodalField> &slips,
                 const std::vector<double>     &bounds,
                 const std::vector<double>     &forces)
        : slips(slips)
        , bounds(bounds)
        , forces(forces)
        , v(forces.size(), 1.)
      {}

      double find()
      {
        const unsigned int max_rounds = 200;
        double             power      = std::numeric_limits<double>::infinity();
        for (unsigned int k = 0; k < max_rounds; ++k)
          {
            reweight();
            const double now = sliding_power();
            if (std::abs(power - now) <= 1e-12 * now)
              return now;
            power = now;
          }
        return power;
      }

    private:
      double slip_at(const unsigned int c, const unsigned int i) const
      {
        double s = 0.;
        for (std::size_t k = 0; k < v.size(); ++k)
          s += v[k] * slips[k](c, i);
        return s;
      }

      double speed_at(const unsigned int i) const
      {
        double squares = 0.;
        for (unsigned int c = 0; c < slips[0].n_components(); ++c)
          squares += std::pow(slip_at(c, i), 2);
        return std::sqrt(squares);
      }

      double sliding_power() const
      {
        double power = 0.;
        for (std::size_t i = 0; i < bounds.size(); ++i)
          power += bounds[i] * speed_at(i);
        return power;
      }

      void reweight()
      {
        const std::size_t n       = v.size();
        double            fastest = 0.;
        for (std::size_t i = 0; i < bounds.size(); ++i)
          if (bounds[i] > 0.)
            fastest = std::max(fastest, speed_at(i));
        DenseMatrix M = DenseMatrix::Zero(n, n);
        for (std::size_t i = 0; i < bounds.size(); ++i)
          {
            if (bounds[i] <= 0.)
              continue;
            const double weight =
              bounds[i] / std::max(speed_at(i), 1e-12 * fastest);
            for (std::size_t k = 0; k < n; ++k)
              for (std::size_t l = 0; l < n; ++l)
                for (unsigned int c = 0; c < slips[0].n_components(); ++c)
                  M(k, l) += weight * slips[k](c, i) * slips[l](c, i);
          }
        Eigen::VectorXd x = as_vector(forces);
        if (solve_positive_definite(M, x))
          as_vector(v) = x / as_vector(forces).dot(x);
      }

      const std::vector<NodalField> &slips;
      const std::vector<double>     &bounds, &forces;
      std::vector<double>            v;
    };
  } // namespace

  double largest_share_of_forces(const ContactProblem      &problem,
                                 const std::vector<double> &pressure)
  {
    const auto          asked = asked_components(problem.loads.forces);
    const auto          part  = plane_resultant_of_pressure(problem, pressure);
    std::vector<double> bounds(problem.n_nodes()), forces;
    for (unsigned int i = 0; i < problem.n_nodes(); ++i)
      bounds[i] =
        problem.operators.areas()[i] * problem.loads.friction[i] * pressure[i];
    std::vector<NodalField> slips;
    bool                    any = false;
    for (const auto &[component, force] : asked)
      {
        slips.push_back(
          rigid_slip(problem.operators, unit_creepage(component)));
        forces.push_back(force - part[component]);
        any = any || forces.back() != 0.;
      }
    return any ? LeastPower(slips, bounds, forces).find()
               : std::numeric_limits<double>::infinity();
  }
} // namespace RollingContact
