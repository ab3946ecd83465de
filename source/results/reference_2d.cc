#include <rolling_contact/contact/patch_edge.h>
#include <rolling_contact/contact/recovered_tractions.h>
#include <rolling_contact/pair/layered_bodies.h>
#include <rolling_contact/references/clamped_annuli_approach.h>
#include <rolling_contact/results/reference_2d.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace RollingContact
{
  namespace
  {
    /**
     * The body as an annulus whose exact compression is known, if it is one.
     */
    std::optional<References::Annulus> annulus(const BodySpec &body)
    {
      if (body.rigid)
        return {};
      return body.body_shape()->clamped_annulus(body.material.young_modulus,
                                                body.material.poisson_ratio);
    }

    /**
     * sqrt(integral (f - reference)^2 dx / a) by the trapezoidal rule.
     */
    double l2_error(const std::vector<double>                 &x,
                    const std::vector<double>                 &nodal,
                    const std::function<double(const double)> &reference,
                    const double                               half_width)
    {
      double sum = 0., previous = 0.;
      for (std::size_t i = 0; i < x.size(); ++i)
        {
          const double square = std::pow(nodal[i] - reference(x[i]), 2);
          if (i > 0)
            sum += (x[i] - x[i - 1]) * (previous + square) / 2;
          previous = square;
        }
      return std::sqrt(sum / half_width);
    }

    double sawtooth(const std::vector<double>                 &x,
                    const std::vector<double>                 &nodal,
                    const std::function<double(const double)> &reference)
    {
      std::vector<double> error(x.size());
      for (std::size_t i = 0; i < x.size(); ++i)
        error[i] = nodal[i] - reference(x[i]);
      double largest = 0.;
      for (std::size_t i = 1; i + 1 < x.size(); ++i)
        largest =
          std::max(largest,
                   std::abs(error[i + 1] - 2 * error[i] + error[i - 1]));
      return largest / 4;
    }

    /**
     * Where the stick zone ends along the flow: mu p - |q| falls to zero there
     * as the pressure does at its edge. The leading edge if nothing sticks.
     */
    double stick_boundary(const SteadyState<2>      &steady,
                          const std::vector<double> &x,
                          const int                  flow)
    {
      const TangentialProblem tangential =
        tangential_problem(steady.problem, steady.state);
      const auto          states = node_states(tangential, steady.state);
      std::vector<double> stick_x, margin;
      const int           n = x.size();
      for (int k = 0; k < n; ++k)
        {
          const int i = flow > 0 ? n - 1 - k : k;
          if (states[i] == NodeState::stick)
            {
              stick_x.push_back(x[i]);
              margin.push_back(tangential.bound[i] -
                               steady.state.traction.norm_at(i));
            }
          else if (!stick_x.empty())
            break;
        }
      if (!stick_x.empty())
        return patch_edge(stick_x, margin);
      return flow > 0 ? steady.result.edge_begin_x : steady.result.edge_end_x;
    }
  } // namespace

  Reference2D reference_2d(const PairSpec &scene, const SteadyState<2> &steady)
  {
    const PairConstants constants = pair_constants(scene);
    Reference2D reference{References::hertz_line(steady.result.normal_force /
                                                   scene.thickness(),
                                                 constants.relative_radius,
                                                 constants.contact_modulus),
                          {},
                          steady.pair->bodies().twins(),
                          {},
                          {}};
    if (scene.has_covers())
      {
        const auto line =
          layered_line_contact(scene,
                               steady.result.normal_force / scene.thickness(),
                               References::LineFriction::none);
        reference.hertz   = {line.half_width, line.pressure(0.)};
        reference.layered = line;
        return reference;
      }
    if (std::abs(constants.dundurs_beta) < 1e-12 &&
        steady.problem.n_tangential() > 0 &&
        scene.contact.has_constant_friction())
      reference.carter.emplace(reference.hertz,
                               constants.relative_radius,
                               scene.contact.friction_coefficient,
                               steady.problem.loads.creepages.x,
                               scene.contact.flow());
    const auto wheel = annulus(scene.wheel), rail = annulus(scene.rail);
    // its pressure is that of Hertz, which thinner rims do not have
    const auto is_thick = [&](const std::optional<References::Annulus> &body) {
      return body &&
             body->rim_radius - body->hub_radius > steady.result.half_width_x;
    };
    if (is_thick(wheel) && is_thick(rail) && scene.contact.approach)
      reference.normal_force =
        References::load_of_two_clamped_annuli(*wheel,
                                               *rail,
                                               steady.state.approach) *
        scene.thickness();
    return reference;
  }

  Errors2D errors_2d(const PairSpec       &scene,
                     const SteadyState<2> &steady,
                     const Reference2D    &reference)
  {
    std::vector<double> x;
    for (const auto &position : steady.problem.operators.positions())
      x.push_back(position[0]);
    const double a  = reference.hertz.half_width,
                 p0 = reference.hertz.max_pressure,
                 mu = scene.contact.friction_coefficient;
    const RecoveredTractions recovered =
      recovered_tractions(steady.problem, steady.state);
    Errors2D errors;
    if (reference.normal_force)
      errors.normal_force =
        steady.result.normal_force / *reference.normal_force - 1;
    errors.pressure_l2 =
      l2_error(
        x,
        recovered.pressure,
        [&](const double at) { return reference.pressure(at); },
        a) /
      p0;
    if (!reference.carter || !reference.carter_is_exact)
      return errors;
    const References::Carter &carter = *reference.carter;
    const std::vector<double> q      = steady.state.traction.component(0);
    const auto traction = [&](const double at) { return carter.traction(at); };
    errors.force        = steady.result.force_x / steady.result.friction_force -
                   carter.force_ratio();
    errors.traction_l2 =
      l2_error(x, recovered.traction.component(0), traction, a) / (mu * p0);
    errors.sawtooth       = sawtooth(x, q, traction) / (mu * p0);
    const int  flow       = scene.contact.flow();
    const auto interval   = carter.stick_interval();
    errors.stick_boundary = (stick_boundary(steady, x, flow) -
                             (flow > 0 ? interval.second : interval.first)) /
                            steady.grading.element_size_x;
    return errors;
  }
} // namespace RollingContact
