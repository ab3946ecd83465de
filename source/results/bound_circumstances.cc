#include <rolling_contact/contact/tangential_problem.h>
#include <rolling_contact/contact/touching_run.h>
#include <rolling_contact/results/error_bounds.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  BoundCircumstances expected_circumstances(const PairSpec &scene,
                                            const double    half_width)
  {
    BoundCircumstances found;
    found.expected         = true;
    found.dim              = static_cast<int>(scene.dimension);
    found.kind             = scene.contact.slip_operator;
    found.beta             = std::abs(pair_constants(scene).dundurs_beta);
    found.varying_friction = !scene.surfaces.friction_share.empty() ||
                             !scene.contact.friction_over_temperature.empty() ||
                             scene.contact.friction_memory_length > 0.;
    found.falling_friction = scene.contact.falling_friction() != nullptr;
    found.spin =
      scene.contact.creepages.spin != 0. || scene.contact.forces.moment;
    found.refined             = scene.mesh.rim_levels > 0;
    found.approach_given      = !scene.contact.normal_load;
    found.friction            = scene.contact.friction_coefficient;
    found.growth              = scene.mesh.growth_in(scene.dimension);
    found.residual_normal     = scene.solver.controls.tolerance;
    found.residual_tangential = scene.solver.controls.tolerance;
    for (const BodySpec *body : {&scene.wheel, &scene.rail})
      if (!body->rigid)
        {
          found.incompressibility =
            std::max(found.incompressibility,
                     (body->material.poisson_ratio - 0.45) / 0.05);
          if (half_width > 0.)
            found.thickness =
              std::min(found.thickness,
                       body->body_shape()->thickness_below() / half_width);
        }
    return found;
  }

  namespace
  {
    /**
     * |p(y + h) - 2 p(y) + p(y - h)| / p at the node with the largest pressure.
     */
    template <int dim>
    double bend_of_peak(const SteadyState<dim> &steady)
    {
      const std::vector<double> &p = steady.state.pressure;
      const std::size_t peak = std::max_element(p.begin(), p.end()) - p.begin();
      const auto       &at   = steady.problem.operators.positions()[peak];
      const double      step = steady.grading.element_size_y;
      double            bend = -2 * p[peak];
      for (const double side : {-step, step})
        if (const auto weights =
              steady.pair->trace().interpolation(at[0], at[1] + side))
          bend += apply(*weights, p);
      return std::abs(bend) / p[peak];
    }

    template <int dim>
    double share_on_upwind_2(const SteadyState<dim> &steady)
    {
      if (steady.problem.n_tangential() == 0)
        return 0.;
      const SlipRows rows =
        tangential_problem(steady.problem, steady.state).rows;
      const std::size_t left = rows.n_unresolved;
      return left == 0 ? 0. : double(left) / (rows.edges.size() + left);
    }
  } // namespace

  template <int dim>
  BoundCircumstances bound_circumstances(const PairSpec         &scene,
                                         const SteadyState<dim> &steady)
  {
    const ContactProblem &problem = steady.problem;
    const double          a       = steady.result.half_width_x;
    BoundCircumstances    found   = expected_circumstances(scene, a);
    found.expected                = false;
    found.kind                    = problem.operators.slip_operator().kind();
    found.n                   = a > 0. ? 2 * a / steady.grading.element_size_x
                                       : steady.grading.elements_across();
    found.spin                = problem.loads.creepages.spin != 0.;
    found.edge_law            = steady.state.edge_law;
    found.edges_settled       = steady.solver.edges_settled;
    found.residual_normal     = steady.solver.residual.normal;
    found.residual_tangential = steady.solver.residual.tangential;
    found.refined             = false;
    if (scene.profiles.in_use())
      found.bend_of_peak = bend_of_peak(steady);
    if (dim == 3)
      found.element_aspect =
        steady.grading.element_size_x / steady.grading.element_size_y;
    for (const TouchingRun &run :
         touching_runs(problem.operators.slip_operator(),
                       steady.state.pressure))
      {
        found.refined = found.refined || run.cut;
        found.waves =
          std::max(found.waves,
                   change_of_curvature(run,
                                       places(run, problem.operators),
                                       problem.loads.gap));
      }
    found.split       = steady.pair->bodies().is_split();
    found.on_upwind_2 = share_on_upwind_2(steady);
    return found;
  }

  template BoundCircumstances bound_circumstances(const PairSpec &,
                                                  const SteadyState<2> &);
  template BoundCircumstances bound_circumstances(const PairSpec &,
                                                  const SteadyState<3> &);
} // namespace RollingContact
