#include <rolling_contact/base/text.h>
#include <rolling_contact/damage/shakedown.h>
#include <rolling_contact/results/state_damage.h>
#include <rolling_contact/run/figure.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    using Damage::ArchardScatter;
    using Damage::DamageParameters;
    using Damage::WearLaw;

    /// load factors of the shakedown map that are drawn
    const double highest_drawn = 8.;

    /** Largest traction of a node over its friction bound that still sticks. */
    const double sliding = 0.999;
  } // namespace

  bool StateDamage::is_asked(const PairSpec       &scene,
                             const ContactProblem &problem)
  {
    return scene.wear.report && problem.n_tangential() > 1 &&
           problem.operators.time_scaling().rate == 0.;
  }

  StateDamage::StateDamage(const PairSpec       &scene,
                           const ContactProblem &problem,
                           const ContactState   &state)
    : scene(scene)
    , problem(problem)
    , state(state)
    , tangential(tangential_problem(problem, state))
  {
    const NodalField slip  = tangential.mean_slip(state);
    const double     speed = std::abs(scene.contact.rolling_speed());
    for (unsigned int i = 0; i < problem.n_nodes(); ++i)
      {
        Damage::RubbingNode node;
        node.pressure = state.pressure[i];
        node.slip     = slip.norm_at(i);
        for (unsigned int c = 0; c < slip.n_components(); ++c)
          node.power -= state.traction(c, i) * slip(c, i);
        node.sliding_speed = node.slip * speed;
        nodes.push_back(node);
      }
  }

  std::vector<WearLaw> StateDamage::laws() const
  {
    std::vector<WearLaw> told;
    for (const WearLaw &law : Damage::wear_laws())
      if (can_tell(law))
        told.push_back(law);
    return told;
  }

  std::vector<double> StateDamage::rates(const WearLaw &law) const
  {
    std::vector<double> all;
    for (const Damage::RubbingNode &node : nodes)
      all.push_back(law.rate(node, scene.wear));
    return all;
  }

  std::vector<double> StateDamage::surface_indices() const
  {
    std::vector<double> all;
    for (unsigned int i = 0; i < nodes.size(); ++i)
      all.push_back(
        state.pressure[i] > 0.
          ? Damage::nodal_surface_index(state.traction.norm_at(i),
                                        state.pressure[i],
                                        scene.wear.shear_yield_stress)
          : std::nan(""));
    return all;
  }

  double StateDamage::depth(const LineAcross       &line,
                            const WearLaw          &law,
                            const DamageParameters &constants) const
  {
    if (!(line.width > 0.))
      return 0.;
    Damage::NodeLine of_line;
    for (const unsigned int i : line.nodes)
      {
        of_line.nodes.push_back(nodes[i]);
        of_line.lengths.push_back(problem.operators.areas()[i] / line.width);
      }
    return Damage::depth_per_passage(of_line, law, constants);
  }

  std::pair<std::vector<double>, std::vector<double>>
  StateDamage::sliding_points() const
  {
    std::pair<std::vector<double>, std::vector<double>> points;
    for (unsigned int i = 0; i < nodes.size(); ++i)
      {
        const double q = state.traction.norm_at(i), p = state.pressure[i];
        if (p <= 0. || q < sliding * tangential.bound[i])
          continue;
        points.first.push_back(q / p);
        points.second.push_back(p / scene.wear.shear_yield_stress);
      }
    return points;
  }

  std::vector<Damage::FrictionUse> StateDamage::friction_uses() const
  {
    std::vector<Damage::FrictionUse> all;
    for (unsigned int i = 0; i < nodes.size(); ++i)
      if (tangential.bound[i] > 0.)
        all.push_back({state.traction.norm_at(i) / tangential.bound[i],
                       problem.operators.areas()[i] * state.pressure[i]});
    return all;
  }

  std::optional<double> rolling_radius(const PairSpec &scene, const double y)
  {
    const double radius = scene.wheel.radius;
    if (!(radius > 0.))
      return {};
    if (!scene.frame)
      return radius;
    const auto s = scene.frame->wheel_arc_length(y);
    if (!s)
      return {};
    const Profiles::WheelOnRail &profiles = scene.frame->wheel_on_rail();
    return profiles.wheel_radius() + profiles.wheel_profile().at(*s).z;
  }

  namespace
  {
    /** The worn area of the wheel's section per metre rolled. Units: m. */
    double worn_area_of_wheel(const PairSpec                &scene,
                              const StateDamage             &damage,
                              const std::vector<LineAcross> &lines,
                              const WearLaw                 &law,
                              const DamageParameters        &constants)
    {
      double area = 0.;
      for (const LineAcross &line : lines)
        if (const auto radius = rolling_radius(scene, line.y))
          area +=
            line.width *
            Damage::wheel_depth_per_metre(damage.depth(line, law, constants),
                                          *radius);
      return area;
    }

    /** What a patch is to the indices of fatigue. */
    struct PatchFatigue
    {
      double utilised_friction, load_factor, surface, surface_of_area,
        subsurface, damage;
    };

    PatchFatigue fatigue_of(const ContactPatch   &patch,
                            const WearParameters &wear)
    {
      const double k = wear.shear_yield_stress, N = patch.normal_force,
                   mu_u = Damage::utilised_friction(std::hypot(patch.force_x,
                                                               patch.force_y),
                                                    N);
      return {mu_u,
              Damage::load_factor(patch.max_pressure, k),
              Damage::surface_fatigue_index(mu_u, patch.max_pressure, k),
              Damage::surface_fatigue_index_of_area(mu_u, N, patch.area, k),
              Damage::subsurface_fatigue_index(mu_u, N, patch.area),
              Damage::t_gamma_damage(std::max(0., patch.dissipation),
                                     wear.threshold)};
    }

    /** All patches, that nearest to cracks at the surface first. */
    std::vector<PatchFatigue> fatigue_of_patches(const PairSpec       &scene,
                                                 const SteadyState<3> &steady)
    {
      std::vector<PatchFatigue> all;
      for (const ContactPatch &patch : patches_of(steady))
        if (patch.normal_force > 0. && patch.area > 0.)
          all.push_back(fatigue_of(patch, scene.wear));
      std::stable_sort(all.begin(),
                       all.end(),
                       [](const PatchFatigue &a, const PatchFatigue &b) {
                         return a.surface > b.surface;
                       });
      return all;
    }

    void set_wear_columns(const PairSpec       &scene,
                          const SteadyState<3> &steady,
                          const StateDamage    &damage,
                          ResultsTable         &table)
    {
      const auto lines = lines_across(steady);
      const auto set   = [&](const std::string      &column,
                           const WearLaw          &law,
                           const DamageParameters &constants) {
        table.set(column + "_mm2/km",
                  worn_area_of_wheel(scene, damage, lines, law, constants) /
                    Damage::mm2_per_km);
      };
      for (const WearLaw &law : damage.laws())
        {
          set("wear_" + law.name, law, scene.wear);
          if (law.rate != &Damage::archard_rate)
            continue;
          DamageParameters scatter = scene.wear;
          scatter.archard_scatter  = ArchardScatter::lowest;
          set("wear_archard_lowest", law, scatter);
          scatter.archard_scatter = ArchardScatter::highest;
          set("wear_archard_highest", law, scatter);
        }
      double brr = 0.;
      for (const ContactPatch &patch : patches_of(steady))
        brr += Damage::brr_worn_area(std::max(0., patch.dissipation),
                                     2 * scene.wheel.radius);
      table.set("wear_brr_mm2/km", brr / Damage::mm2_per_km);
    }
  } // namespace

  void set_damage_columns(const PairSpec       &scene,
                          const SteadyState<3> &steady,
                          ResultsTable         &table)
  {
    if (!StateDamage::is_asked(scene, steady.problem))
      return;
    const StateDamage damage(scene, steady.problem, steady.state);
    if (scene.wheel.radius > 0.)
      set_wear_columns(scene, steady, damage, table);
    const auto patches = fatigue_of_patches(scene, steady);
    if (patches.empty())
      return;
    const PatchFatigue &worst = patches.front();
    table.set("utilised_friction", worst.utilised_friction);
    table.set("utilised_friction_95",
              Damage::friction_use_percentile(damage.friction_uses()));
    table.set("load_factor", worst.load_factor);
    table.set("fi_surf", worst.surface);
    table.set("fi_surf_area", worst.surface_of_area);
    table.set("fi_sub_Pa", worst.subsurface);
    table.set("t_gamma_damage", worst.damage);
  }

  void set_depth_columns(const PairSpec    &scene,
                         const StateDamage &damage,
                         const LineAcross  &line,
                         ResultsTable      &table)
  {
    const auto radius = rolling_radius(scene, line.y);
    for (const WearLaw &law : damage.laws())
      {
        const double depth = damage.depth(line, law, scene.wear);
        table.set("wear_rail_" + law.name + "_m", depth);
        table.set_if(radius.has_value(),
                     "wear_wheel_" + law.name + "_m/m",
                     radius ? Damage::wheel_depth_per_metre(depth, *radius)
                            : 0.);
      }
  }

  void note_damage(const PairSpec       &scene,
                   const SteadyState<3> &steady,
                   RunReport            &report)
  {
    if (!steady.solver.converged ||
        !StateDamage::is_asked(scene, steady.problem))
      return;
    const StateDamage damage(scene, steady.problem, steady.state);
    const auto        patches = fatigue_of_patches(scene, steady);
    if (patches.empty())
      return;
    std::string wear;
    const auto  lines = lines_across(steady);
    if (scene.wheel.radius > 0.)
      for (const WearLaw &law : damage.laws())
        wear += law.name + ' ' +
                significant(
                  worn_area_of_wheel(scene, damage, lines, law, scene.wear) /
                    Damage::mm2_per_km,
                  3) +
                ", ";
    report.set_finding(
      "wear",
      (wear.empty() ? wear : "of the wheel, mm\u00b2/km: " + wear) +
        "p0/k = " + significant(patches.front().load_factor, 3) +
        " at a utilised friction of " +
        significant(patches.front().utilised_friction, 3) +
        ", FI_surf = " + significant(patches.front().surface, 3));
  }

  namespace
  {
    void add_limits(Figure &figure, const double poisson_ratio)
    {
      std::vector<double> x;
      const auto          map = Damage::shakedown_map(0.6, 60, poisson_ratio);
      for (const Damage::ShakedownLimits &limits : map)
        x.push_back(limits.utilised_friction);
      const auto add = [&](const std::string &label,
                           double Damage::ShakedownLimits::*limit,
                           const CurveStyle style = CurveStyle::reference) {
        std::vector<double> y;
        for (const Damage::ShakedownLimits &limits : map)
          y.push_back(limits.*limit <= highest_drawn ? limits.*limit
                                                     : std::nan(""));
        figure.add_curve(label, x, y, style);
      };
      add("surface yields, 1/\u03bc",
          &Damage::ShakedownLimits::surface,
          CurveStyle::thick);
      add("shakedown, point contact",
          &Damage::ShakedownLimits::point_shakedown);
      add("shakedown, line contact", &Damage::ShakedownLimits::line_shakedown);
      add("elastic limit, line contact",
          &Damage::ShakedownLimits::line_elastic);
    }
  } // namespace

  void plot_shakedown_map(const PairSpec       &scene,
                          const SteadyState<3> &steady,
                          RunContext           &context,
                          const std::string    &name)
  {
    if (!steady.solver.converged ||
        !StateDamage::is_asked(scene, steady.problem))
      return;
    const auto patches = fatigue_of_patches(scene, steady);
    if (patches.empty())
      return;
    Figure figure("Shakedown map",
                  "utilised friction",
                  "p\u2080 / k,   k = " +
                    significant(1e-6 * scene.wear.shear_yield_stress, 4) +
                    " MPa");
    add_limits(figure, scene.rail.surface_material().poisson_ratio);
    const auto [x, y] =
      StateDamage(scene, steady.problem, steady.state).sliding_points();
    if (!x.empty())
      figure.add_curve("nodes that slide, p/k", x, y, CurveStyle::points);
    std::vector<double> of_patches, factors;
    for (const PatchFatigue &patch : patches)
      {
        of_patches.push_back(patch.utilised_friction);
        factors.push_back(patch.load_factor);
      }
    figure.add_curve("patches", of_patches, factors, CurveStyle::points);
    figure.draw(context, name);
  }
} // namespace RollingContact
