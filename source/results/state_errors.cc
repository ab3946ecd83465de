#include <rolling_contact/base/constants.h>
#include <rolling_contact/contact/patch_area.h>
#include <rolling_contact/results/reference_2d.h>
#include <rolling_contact/results/reference_3d.h>
#include <rolling_contact/results/state_errors.h>

#include <cmath>
#include <functional>

namespace RollingContact
{
  namespace
  {
    /**
     * sqrt(integral |e|^2 dA / area) with the error e at the nodes, one for
     * each component.
     */
    double nodal_l2(const ContactProblem &problem,
                    const unsigned int    n_components,
                    const double          area,
                    const std::function<double(const unsigned int component,
                                               const unsigned int node)> &error)
    {
      double sum = 0.;
      for (unsigned int c = 0; c < n_components; ++c)
        for (unsigned int i = 0; i < problem.n_nodes(); ++i)
          sum += problem.operators.areas()[i] * std::pow(error(c, i), 2);
      return std::sqrt(sum / area);
    }

    /**
     * Difference of the pressures from the finest mesh; @p area and @p scale
     * make it dimensionless. Units: m^2, Pa.
     */
    double pressure_difference(const SteadyState<3> &steady,
                               const TractionField  &finest,
                               const double          area,
                               const double          scale)
    {
      const ContactProblem     &problem = steady.problem;
      const auto               &at      = problem.operators.positions();
      const std::vector<double> pressure =
        recovered_pressure(problem.operators, steady.state.pressure);
      return nodal_l2(problem,
                      1,
                      area,
                      [&](const unsigned int, const unsigned int i) {
                        double difference = pressure[i];
                        if (const auto weights =
                              finest.trace.interpolation(at[i][0], at[i][1]))
                          for (const auto &[node, weight] : *weights)
                            difference -=
                              weight * finest.recovered.pressure[node];
                        return difference;
                      }) /
             scale;
    }

    /**
     * Difference of the tractions from those of the finest mesh, in the norm of
     * L2.
     */
    template <int dim>
    double traction_difference(const SteadyState<dim> &steady,
                               const TractionField    &finest,
                               const double            area,
                               const double            scale)
    {
      const ContactProblem &problem = steady.problem;
      const auto           &at      = problem.operators.positions();
      const NodalField      traction =
        recovered_tractions(problem, steady.state).traction;
      return nodal_l2(problem,
                      problem.n_tangential(),
                      area,
                      [&](const unsigned int c, const unsigned int i) {
                        const auto weights =
                          finest.trace.interpolation(at[i][0], at[i][1]);
                        return traction(c, i) -
                               (weights ? apply(*weights,
                                                finest.recovered.traction,
                                                c)
                                        : 0.);
                      }) /
             scale;
    }

    void set_closed_forms(const PairSpec       &scene,
                          const SteadyState<2> &steady,
                          const TractionField  *finest,
                          StateErrors          &result)
    {
      const Reference2D reference = reference_2d(scene, steady);
      const Errors2D    errors    = errors_2d(scene, steady, reference);
      result.load                 = errors.normal_force;
      result.pressure_l2          = errors.pressure_l2;
      if (follows_carter(scene, steady))
        {
          result.traction_l2    = errors.traction_l2;
          result.sawtooth       = errors.sawtooth;
          result.stick_boundary = std::abs(errors.stick_boundary);
        }
      else if (finest != nullptr)
        result.traction_l2 =
          traction_difference(steady,
                              *finest,
                              reference.hertz.half_width * scene.thickness(),
                              scene.contact.friction_coefficient *
                                reference.hertz.max_pressure);
    }

    void set_differences(const PairSpec       &scene,
                         const SteadyState<3> &steady,
                         const TractionField  &finest,
                         StateErrors          &result)
    {
      const double area =
                     patch_areas(steady.problem, steady.state).contact / pi,
                   scale = steady.result.max_pressure;
      result.pressure_l2 = pressure_difference(steady, finest, area, scale);
      result.traction_l2 = traction_difference(
        steady, finest, area, scene.contact.friction_coefficient * scale);
    }

    void set_closed_forms(const PairSpec       &scene,
                          const SteadyState<3> &steady,
                          const TractionField  *finest,
                          StateErrors          &result)
    {
      if (scene.profiles.in_use() || scene.touches_in_line())
        {
          if (finest != nullptr)
            set_differences(scene, steady, *finest, result);
          return;
        }
      const References::HertzEllipse hertz =
        reference_3d(scene, steady.result.normal_force, {}).hertz;
      const double              area = hertz.half_width_x * hertz.half_width_y;
      const auto               &at   = steady.problem.operators.positions();
      const std::vector<double> pressure =
        recovered_tractions(steady.problem, steady.state).pressure;
      result.pressure_l2 =
        nodal_l2(steady.problem,
                 1,
                 area,
                 [&](const unsigned int, const unsigned int i) {
                   return pressure[i] - hertz.pressure(at[i][0], at[i][1]);
                 }) /
        hertz.max_pressure;
      if (finest != nullptr)
        result.traction_l2 =
          traction_difference(steady,
                              *finest,
                              area,
                              scene.contact.friction_coefficient *
                                hertz.max_pressure);
    }
  } // namespace

  template <int dim>
  bool follows_carter(const PairSpec &scene, const SteadyState<dim> &steady)
  {
    if constexpr (dim == 2)
      {
        const Reference2D reference = reference_2d(scene, steady);
        return reference.carter && reference.carter_is_exact;
      }
    else
      return false;
  }

  template <int dim>
  StateErrors state_errors(const PairSpec         &scene,
                           const SteadyState<dim> &steady,
                           const TractionField    *finest)
  {
    StateErrors result;
    set_closed_forms(scene, steady, finest, result);
    return result;
  }

  template StateErrors
  state_errors(const PairSpec &, const SteadyState<2> &, const TractionField *);
  template StateErrors
  state_errors(const PairSpec &, const SteadyState<3> &, const TractionField *);
  template bool follows_carter(const PairSpec &, const SteadyState<2> &);
  template bool follows_carter(const PairSpec &, const SteadyState<3> &);
} // namespace RollingContact
