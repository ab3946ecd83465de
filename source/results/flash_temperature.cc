#include <rolling_contact/contact/node_lines.h>
#include <rolling_contact/contact/tangential_problem.h>
#include <rolling_contact/references/moving_heat_source.h>
#include <rolling_contact/results/flash_temperature.h>

#include <cmath>

namespace RollingContact
{
  namespace
  {
    /**
     * sqrt(k rho c): what a body takes of heat that comes suddenly.
     */
    double effusivity(const BodySpec &body)
    {
      return std::sqrt(body.thermal_conductivity * body.material.density *
                       body.heat_capacity);
    }
  } // namespace

  std::vector<double> flash_temperature(const PairSpec       &scene,
                                        const ContactProblem &problem,
                                        const ContactState   &state)
  {
    const ContactOperators &operators = problem.operators;
    if (problem.n_tangential() == 0 || !scene.contact.speed ||
        operators.time_scaling().rate != 0.)
      return {};
    const double     V = std::abs(*scene.contact.speed);
    const NodalField s = tangential_problem(problem, state).mean_slip(state);
    const BodySpec  &wheel = scene.wheel;
    const double     share = effusivity(wheel) /
                         (effusivity(wheel) + effusivity(scene.rail)),
                 diffusivity = wheel.thermal_conductivity /
                               (wheel.material.density * wheel.heat_capacity);
    std::vector<double> rise(problem.n_nodes(), 0.);
    for (const std::vector<unsigned int> &line : node_lines(operators, 0))
      {
        std::vector<double> x, flux;
        for (const unsigned int i : line)
          {
            double power = 0.;
            for (unsigned int c = 0; c < problem.n_tangential(); ++c)
              power -= state.traction(c, i) * s(c, i) * V;
            x.push_back(operators.positions()[i][0]);
            flux.push_back(share * power);
          }
        const std::vector<double> along =
          References::moving_heat_source(x,
                                         flux,
                                         scene.contact.flow() * V,
                                         wheel.thermal_conductivity,
                                         diffusivity);
        for (std::size_t k = 0; k < line.size(); ++k)
          rise[line[k]] = along[k];
      }
    return rise;
  }
} // namespace RollingContact
