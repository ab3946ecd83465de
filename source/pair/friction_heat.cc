#include <rolling_contact/base/constants.h>
#include <rolling_contact/contact/node_lines.h>
#include <rolling_contact/contact/tangential_problem.h>
#include <rolling_contact/pair/friction_heat.h>
#include <rolling_contact/references/moving_heat_source.h>

#include <algorithm>
#include <array>
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
      return std::sqrt(body.thermal_conductivity *
                       body.surface_material().density * body.heat_capacity);
    }

    /** The part of the wheel in the effusivities of both. */
    double share_of_wheel(const PairSpec &scene)
    {
      return effusivity(scene.wheel) /
             (effusivity(scene.wheel) + effusivity(scene.rail));
    }

    /**
     * Length and width of the part of a line of nodes that touches, with half
     * of the distance to the next nodes at its ends. Units: m.
     */
    std::array<double, 2> extent_of(const std::vector<unsigned int> &line,
                                    const ContactOperators          &operators,
                                    const std::vector<double>       &pressure)
    {
      const auto x = [&](const std::size_t k) {
        return operators.positions()[line[k]][0];
      };
      double length = 0., area = 0.;
      for (std::size_t k = 0; k < line.size(); ++k)
        if (pressure[line[k]] > 0.)
          {
            area += operators.areas()[line[k]];
            length +=
              (x(std::min(k + 1, line.size() - 1)) - x(k > 0 ? k - 1 : 0)) / 2;
          }
      return {{length, length > 0. ? area / length : 0.}};
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
    const double     share = share_of_wheel(scene),
                 diffusivity =
                   wheel.thermal_conductivity /
                   (wheel.surface_material().density * wheel.heat_capacity);
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

  std::optional<PatchTemperature>
  patch_temperature(const PairSpec       &scene,
                    const ContactProblem &problem,
                    const ContactState   &state)
  {
    const auto rise = flash_temperature(scene, problem, state);
    if (rise.empty())
      return {};
    const auto &area  = problem.operators.areas();
    double      whole = 0., sum = 0.;
    for (std::size_t i = 0; i < rise.size(); ++i)
      if (state.pressure[i] > 0.)
        {
          whole += area[i];
          sum += area[i] * rise[i];
        }
    return PatchTemperature{*std::max_element(rise.begin(), rise.end()),
                            whole > 0. ? sum / whole : 0.};
  }

  double contact_temperature(const PairSpec &scene)
  {
    const double share = share_of_wheel(scene);
    return share * scene.wheel.temperature +
           (1 - share) * scene.rail.temperature;
  }

  HeatFlows heat_flows(const PairSpec       &scene,
                       const ContactProblem &problem,
                       const ContactState   &state,
                       const double          power)
  {
    const double share = share_of_wheel(scene),
                 V     = std::abs(scene.contact.rolling_speed());
    double of_lines    = 0.;
    for (const auto &line : node_lines(problem.operators, 0))
      {
        const auto [length, width] =
          extent_of(line, problem.operators, state.pressure);
        of_lines += width * std::sqrt(length);
      }
    const double conducted =
      2 * share * effusivity(scene.rail) *
      (scene.wheel.temperature - scene.rail.temperature) * std::sqrt(V / pi) *
      of_lines;
    return {share * power - conducted, (1 - share) * power + conducted};
  }

  std::vector<double> hot_friction(const PairSpec            &scene,
                                   const HotFriction         &law,
                                   const std::vector<double> &cold,
                                   const std::vector<double> &rise)
  {
    const double        base     = contact_temperature(scene);
    std::vector<double> friction = cold;
    for (std::size_t i = 0; i < rise.size(); ++i)
      friction[i] *= law.share(base + rise[i]);
    return friction;
  }
} // namespace RollingContact
