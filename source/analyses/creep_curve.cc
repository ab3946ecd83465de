#include <rolling_contact/analyses/creep_curve.h>
#include <rolling_contact/analyses/solve_to_target.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/stopwatch.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/results/bodies_report.h>
#include <rolling_contact/results/profile_columns.h>
#include <rolling_contact/results/reference_2d.h>
#include <rolling_contact/results/reference_3d.h>
#include <rolling_contact/results/result_row.h>
#include <rolling_contact/results/state_report.h>
#include <rolling_contact/results/uniqueness_warning.h>
#include <rolling_contact/run/progress.h>
#include <rolling_contact/state/estimate_errors.h>
#include <rolling_contact/state/state_finder.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    const char curve_needs_contact[] =
      "Analysis = creep curve needs contact and friction: check "
      "Contact/Approach, Contact/Normal load and "
      "Contact/Friction coefficient.";

    bool varies(const std::vector<double> &values)
    {
      return std::any_of(values.begin(), values.end(), [&](const double value) {
        return value != values[0];
      });
    }

    bool any(const std::vector<double> &values)
    {
      return std::any_of(values.begin(), values.end(), [](const double value) {
        return value != 0.;
      });
    }

    /**
     * The points of the path by component.
     */
    struct Path
    {
      Path(const std::vector<Creepages> &points)
      {
        for (const Creepages &point : points)
          {
            x.push_back(point.x);
            y.push_back(point.y);
            spin.push_back(point.spin);
          }
      }

      std::vector<double> x, y, spin;
    };

    /**
     * What the points are drawn over: a creepage that is found for the same
     * force at all of them is none of it.
     */
    std::vector<Creepages> abscissae(const std::vector<CreepCurvePoint> &points,
                                     std::vector<Creepages>              found)
    {
      const AskedForces &first    = points[0].forces;
      const auto         constant = [&](std::optional<double> AskedForces::*c) {
        return first.*c &&
               std::all_of(points.begin(), points.end(), [&](const auto &it) {
                 return it.forces.*c == first.*c;
               });
      };
      for (Creepages &point : found)
        {
          if (constant(&AskedForces::x))
            point.x = 0.;
          if (constant(&AskedForces::y))
            point.y = 0.;
          if (constant(&AskedForces::moment))
            point.spin = 0.;
        }
      return found;
    }

    /**
     * For the screen: the creepages that vary, then forces.
     */
    std::vector<std::string> columns_of(const std::vector<Creepages> &points,
                                        const bool                    any_force)
    {
      const Path               path(points);
      std::vector<std::string> columns;
      if (varies(path.x))
        columns.push_back("creepage_x");
      if (varies(path.y))
        columns.push_back("creepage_y");
      if (varies(path.spin))
        columns.push_back("spin_1/m");
      if (any_force || any(path.x))
        columns.push_back("force_x_N");
      if (any(path.y) || any(path.spin))
        columns.push_back("force_y_N");
      columns.insert(columns.end(),
                     {"traction_coefficient", "stick_area_m2", "iterations"});
      return columns;
    }

    StateDemands curve_demands()
    {
      StateDemands demands;
      demands.pair.bulk_errors = true;
      return demands;
    }
  } // namespace

  template <int dim>
  void CreepCurve<dim>::run()
  {
    const auto points = scene.inputs->own<CreepCurveParameters>().points();
    if (scene.contact.friction_coefficient <= 0. || !bodies_touch(scene))
      throw InputError(curve_needs_contact);
    // section Contact has creepages for levels only, which refine for them
    Situation start = scene;
    if (scene.mesh.adaptive_levels == 0)
      start.contact.creepages = Creepages();
    start.contact.forces = AskedForces();
    TargetDemands targets;
    targets.spin =
      std::any_of(points.begin(), points.end(), [](const auto &point) {
        return point.creepages.spin != 0. || point.forces.moment;
      });
    SteadyState<dim> steady = solve_to_target<dim>(
      start, curve_demands(), targets, context, [](const auto &) {});
    scene.mesh = start.mesh;
    require_solved(scene, steady, "Creep curve, the state to start from");
    if (steady.result.normal_force <= 0.)
      throw InputError(curve_needs_contact);
    describe_bodies(steady, context);
    const Stopwatch watch;
    march(points, steady);
    context.log.message(context.results.screen_table(
      columns_of(curve.found, points[0].forces.any())));
    context.report.set_finding("load",
                               "N = " +
                                 significant(steady.result.normal_force, 6) +
                                 " N at the last point");
    note_profiles(scene, steady, context.report);
    context.report.set_finding(
      "curve",
      std::to_string(points.size()) + " points in " +
        human_seconds(watch.seconds()) +
        " after meshing, factorisation and condensation; "
        "largest |T|/(" +
        (scene.contact.falling_friction() ? "mu_s" : "mu") + " N) = " +
        significant(*std::max_element(curve.force_ratio.begin(),
                                      curve.force_ratio.end()),
                    5));
    if (scene.inputs->output.plot)
      plot_creep_curve(abscissae(points, curve.found),
                       curve,
                       scale_of_friction(scene.contact),
                       context);
  }

  template <int dim>
  void CreepCurve<dim>::march(const std::vector<CreepCurvePoint> &points,
                              SteadyState<dim>                   &steady)
  {
    Progress         progress(context.log, "point", points.size());
    StateReview<dim> review(scene, context);
    for (std::size_t k = 0; k < points.size(); ++k)
      {
        throw_if_interrupted();
        const Stopwatch point_watch;
        solve_point(points[k], steady);
        steady.wall_s = point_watch.seconds();
        estimate_errors(scene, steady);
        add_result_row(scene, steady, context);
        require_solved(scene,
                       steady,
                       "Creep curve, point " + std::to_string(k + 1) + " of " +
                         std::to_string(points.size()));
        review.add(steady, "point " + std::to_string(k + 1));
        progress.report(k + 1);
      }
    review.warn(steady);
    warn_of_missed_target(scene, context);
  }

  template <int dim>
  void CreepCurve<dim>::solve_point(const CreepCurvePoint &point,
                                    SteadyState<dim>      &steady)
  {
    ContactLoads &loads = steady.problem.loads;
    loads.forces        = point.forces;
    loads.creepages =
      start_of_search(point.forces, loads.creepages, point.creepages);
    StateFinder<dim>(scene, curve_demands(), context).solve_enclosed(steady);
    curve.found.push_back(steady.problem.loads.creepages);

    const Resultants &result         = steady.result;
    const double      friction_force = result.friction_force;
    curve.force_x.push_back(result.force_x);
    curve.force_y.push_back(result.force_y);
    curve.moment.push_back(result.spin_moment);
    curve.half_width = std::max(curve.half_width, result.half_width_x);
    curve.force_ratio.push_back(result.tangential_force / friction_force);
    std::size_t n = 0;
    const auto  keep =
      [&](const std::string &label, const bool saturates, const double ratio) {
        if (n == curve.references.size())
          curve.references.push_back({label, saturates, {}});
        curve.references[n++].ratios.push_back(ratio);
      };
    if (!scene.has_plain_surfaces())
      return;
    if constexpr (dim == 3)
      for (const NamedForce &theory :
           reference_3d(scene, steady.result.normal_force, curve.found.back())
             .forces)
        keep(theory.label,
             theory.saturates,
             std::hypot(theory.x, theory.y) / friction_force);
    else
      {
        const Reference2D reference = reference_2d(scene, steady);
        if (reference.carter && reference.carter_is_exact)
          keep("Carter", true, std::abs(reference.carter->force_ratio()));
      }
  }

  template class CreepCurve<2>;
  template class CreepCurve<3>;

  namespace
  {
    std::vector<TableAxis> creepages_of_curve(const SceneParameters &scene)
    {
      const auto &curve = scene.own<CreepCurveParameters>();
      return {
        {"Creep curve/Creepage x", "Contact/Creepage x", curve.creepage_x},
        {"Creep curve/Creepage y", "Contact/Creepage y", curve.creepage_y},
        {"Creep curve/Spin", "Contact/Spin", curve.spin}};
    }

    void check_creep_curve(const SceneParameters &scene)
    {
      const CreepCurveParameters &curve = scene.own<CreepCurveParameters>();
      if (scene.dimension == 2)
        curve.check_in_2d();
      bool has_forces = false;
      for (const CreepCurvePoint &point : curve.points())
        has_forces = has_forces || point.forces.any();
      if (!has_forces)
        return;
      const std::string asked =
        "Creep curve/Longitudinal force, Lateral force or Spin moment";
      scene.check_forces(asked,
                         !curve.lateral_force.empty() ||
                           !curve.spin_moment.empty());
      if (scene.contact.friction_coefficient == 0.)
        throw InputError(asked +
                         " and Contact/Friction coefficient = 0: without "
                         "friction there is no such force.");
    }
  } // namespace

  AnalysisKind creep_curve_kind()
  {
    AnalysisKind kind =
      kind_of<CreepCurve>("creep curve",
                          "steady states at many creepages, see section Creep "
                          "curve");
    kind.sections = {"Creep curve"};
    kind.own_section.emplace(CreepCurveParameters());
    kind.own_creepages = &creepages_of_curve;
    kind.rules         = {&check_creep_curve};
    return kind;
  }
} // namespace RollingContact
