#include <rolling_contact/base/text.h>
#include <rolling_contact/contact/patch_area.h>
#include <rolling_contact/contact/recovered_tractions.h>
#include <rolling_contact/pair/friction_heat.h>
#include <rolling_contact/results/linearity_check.h>
#include <rolling_contact/results/reference_2d.h>
#include <rolling_contact/results/result_error.h>
#include <rolling_contact/results/rough_state.h>
#include <rolling_contact/results/state_report.h>
#include <rolling_contact/run/figure.h>
#include <rolling_contact/run/log.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  std::string work_of_solver(const SolverReport &solver)
  {
    std::string text =
      solver.solver + ", " + std::to_string(solver.normal_solves) +
      " normal and " + std::to_string(solver.tangential_solves) +
      " tangential solves in " + std::to_string(solver.passes) + " passes";
    if (solver.corrections > 0)
      text += ", " + std::to_string(solver.corrections) +
              (solver.corrections == 1 ? " correction" : " corrections") +
              " of the compliance";
    if (solver.friction_rounds > 0)
      text +=
        ", friction in " + std::to_string(solver.friction_rounds) + " rounds";
    return text + "; natural residual " +
           scientific(solver.residual.normal, 2) + " normal, " +
           scientific(solver.residual.tangential, 2) + " tangential";
  }

  template <int dim>
  void note_state(const SteadyState<dim> &steady, RunReport &report)
  {
    const Resultants &result = steady.result;
    if (result.n_touching == 0)
      {
        report.set_finding("load",
                           "N = 0 at an approach of " +
                             millimetres(steady.state.approach, 5) +
                             ": the bodies do not touch");
        return;
      }
    report.set_finding(
      "load",
      "N = " + significant(result.normal_force, 6) + " N at an approach of " +
        millimetres(steady.state.approach, 5) + "; peak pressure " +
        significant(1e-6 * result.max_pressure, 5) + " MPa, half-width " +
        millimetres(result.half_width_x, 5) + ", " +
        std::to_string(result.n_touching) + " nodes touch");
    if (result.friction_force <= 0.)
      return;
    const PatchAreas areas = patch_areas(steady.problem, steady.state);
    const auto       shown = [&result](const double force) { // no rounding
      return significant(std::abs(force) < 1e-9 * result.friction_force ? 0.
                                                                        : force,
                         6);
    };
    const std::string across = dim == 2 ? "" : ", " + shown(result.force_y);
    report.set_finding(
      "force",
      (dim == 2 ? "T = " : "T = (") + shown(result.force_x) + across +
        (dim == 2 ? " N" : ") N") +
        ", |T|/N = " + significant(result.traction_coefficient, 5) +
        (steady.problem.loads.friction_law
           ? ""
           : ", |T|/(mu N) = " +
               significant(result.tangential_force / result.friction_force,
                           5)) +
        "; stick on " + significant(100 * areas.stick / areas.contact, 3) +
        " % of the patch");
  }

  template <int dim>
  void note_hot_friction(const PairSpec         &scene,
                         const SteadyState<dim> &steady,
                         RunReport              &report)
  {
    if (scene.contact.friction_over_temperature.empty() ||
        !(steady.result.friction_force > 0.))
      return;
    const auto &friction = steady.problem.loads.friction;
    const auto  flash = patch_temperature(scene, steady.problem, steady.state);
    double      least = scene.contact.friction_coefficient, most = 0.;
    for (std::size_t i = 0; i < friction.size(); ++i)
      if (steady.state.pressure[i] > 0.)
        {
          least = std::min(least, friction[i]);
          most  = std::max(most, friction[i]);
        }
    const double touch = contact_temperature(scene);
    report.set_finding("heat",
                       "surfaces of " + significant(touch, 4) + " to " +
                         significant(touch + (flash ? flash->largest : 0.), 4) +
                         " K, mu from " + significant(most, 3) + " to " +
                         significant(least, 3));
  }

  namespace
  {
    const double extent = 1.15; // of the picture, in half-widths

    /**
     * Lines over x/a, scaled by Hertz's peak pressure and friction bound.
     */
    struct Lines
    {
      std::vector<double> x, pressure, traction, bound;
    };

    Lines computed_lines(const PairSpec       &scene,
                         const SteadyState<2> &steady,
                         const Reference2D    &reference)
    {
      const double p0                 = reference.hertz.max_pressure,
                   bound              = scene.contact.friction_coefficient * p0;
      const ContactProblem   &problem = steady.problem;
      const TangentialProblem tangential =
        tangential_problem(problem, steady.state);
      const RecoveredTractions recovered =
        recovered_tractions(tangential, steady.state);
      Lines lines;
      for (unsigned int i = 0; i < problem.n_nodes(); ++i)
        {
          const double at =
            problem.operators.positions()[i][0] / reference.hertz.half_width;
          if (std::abs(at) > extent)
            continue;
          lines.x.push_back(at);
          lines.pressure.push_back(recovered.pressure[i] / p0);
          if (problem.n_tangential() == 0)
            continue;
          lines.traction.push_back(recovered.traction(0, i) / bound);
          lines.bound.push_back(
            std::copysign(problem.loads.friction_law
                            ? tangential.friction[i] * recovered.pressure[i] /
                                bound
                            : lines.pressure.back(),
                          steady.result.force_x));
        }
      return lines;
    }

    /**
     * Hertz, and Carter where there is one.
     */
    Lines reference_lines(const PairSpec &scene, const Reference2D &reference)
    {
      const unsigned int n = 1000;
      const double       a = reference.hertz.half_width,
                   p0      = reference.hertz.max_pressure,
                   bound   = scene.contact.friction_coefficient * p0;
      Lines lines;
      for (unsigned int k = 0; k <= n; ++k)
        {
          const double at = extent * (2. * k / n - 1);
          lines.x.push_back(at);
          lines.pressure.push_back(reference.pressure(at * a) / p0);
          if (reference.carter)
            lines.traction.push_back(reference.carter->traction(at * a) /
                                     bound);
        }
      return lines;
    }

    std::string title(const PairSpec &scene, const SteadyState<2> &steady)
    {
      if (!steady.solver.converged)
        return "Not converged: no solution";
      const std::string load =
        "N = " + significant(1e-3 * steady.result.normal_force, 4) + " kN";
      if (steady.problem.n_tangential() == 0)
        return load + " without friction";
      const auto readable = [](const double value) {
        return (value < 0 ? "\u2212" : "") + significant(std::abs(value), 4);
      };
      return load + ", T / (" + scale_of_friction(scene.contact) + "N) = " +
             readable(steady.result.force_x / steady.result.friction_force) +
             " at creepage " + readable(steady.problem.loads.creepages.x);
    }
  } // namespace

  void plot_line_tractions(const PairSpec       &scene,
                           const SteadyState<2> &steady,
                           RunContext           &context)
  {
    const Reference2D reference = reference_2d(scene, steady);
    const Lines       found     = computed_lines(scene, steady, reference),
                exact           = reference_lines(scene, reference);
    Figure plot(title(scene, steady),
                "x / a,   a = " + millimetres(reference.hertz.half_width, 4) +
                  ",   material flows " +
                  std::string(scene.contact.flow() > 0 ? "to the right"
                                                       : "to the left"),
                "p / p\u2080,   q / (" + scale_of_friction(scene.contact) +
                  "p\u2080),   p\u2080 = " +
                  significant(1e-6 * reference.hertz.max_pressure, 4) + " MPa");
    if (reference.carter && reference.carter_is_exact)
      {
        const double a     = reference.hertz.half_width;
        const auto   stick = reference.carter->stick_interval();
        if (stick.second > stick.first)
          plot.add_band("stick (Carter)", stick.first / a, stick.second / a);
      }
    plot.add_curve(reference.layered ? "half-planes with covers" : "Hertz",
                   exact.x,
                   exact.pressure,
                   CurveStyle::reference);
    if (reference.carter && reference.carter_is_exact)
      plot.add_curve("Carter", exact.x, exact.traction, CurveStyle::reference);
    plot.add_curve("pressure p", found.x, found.pressure, CurveStyle::points);
    if (steady.problem.n_tangential() > 0)
      {
        plot.add_curve("traction q on the wheel",
                       found.x,
                       found.traction,
                       CurveStyle::points);
        plot.add_curve("bound \u03bcp", found.x, found.bound, CurveStyle::line);
      }
    plot.draw(context, "tractions");
  }

  template <int dim>
  void StateReview<dim>::add(const SteadyState<dim> &steady,
                             const std::string      &name)
  {
    if (steady.solver.converged)
      note_error(scene, steady, context.report);
    worst.add(uniqueness(steady.problem, steady.state), steady.problem, name);
    fewest = std::min(fewest, steady.result.n_touching);
    note_slip_rows(steady);
  }

  template <int dim>
  void StateReview<dim>::note_slip_rows(const SteadyState<dim> &steady)
  {
    ++n_states;
    const bool stood_in =
      steady.solver.used_fallback || !steady.solver.edges_settled;
    if (stood_in && steady.solver.converged &&
        std::find(ways.begin(), ways.end(), steady.solver.solver) == ways.end())
      ways.push_back(steady.solver.solver);
    if (steady.problem.n_tangential() == 0)
      return;
    const SlipRows rows = tangential_problem(steady.problem, steady.state).rows;
    n_edges += rows.edges.size() + rows.n_unresolved;
    n_unresolved += rows.n_unresolved;
  }

  template <int dim>
  void StateReview<dim>::warn_of_slope(
    const std::vector<std::pair<double, double>> &load) const
  {
    double total = 0., slope = 0.;
    for (const auto &[y, force] : load)
      {
        total += force;
        slope += force * scene.frame->rail_angle(y);
      }
    const double large = 0.01; // rad
    if (total > 0. && std::abs(slope) > large * total)
      context.log.warning(
        "Under load the patch lies where the rail slopes by " +
        significant(std::abs(slope / total), 2) +
        " rad against the plane of contact. In the axes of the track the "
        "lateral force is off by this share of the load, and so is the "
        "coupling of both in vibrations. " +
        (scene.follows_profiles()
           ? "Profiles/Contact surface = curved lets the patch move with "
             "bodies that bend or move across."
           : "Profiles/Contact surface = loaded plane takes the plane at the "
             "patch that half-spaces have under load."));
  }

  template <int dim>
  void
  StateReview<dim>::warn_of_turning_normal(const SteadyState<dim> &last) const
  {
    if (!scene.frame)
      return;
    std::vector<std::pair<double, double>> load;
    for (unsigned int i = 0; i < last.problem.n_nodes(); ++i)
      load.emplace_back(last.problem.operators.positions()[i][1],
                        last.problem.operators.areas()[i] *
                          last.state.pressure[i]);
    const double turn = scene.frame->turn_of_normal(load), large = 0.26,
                 degree = std::acos(-1.) / 180;
    if (scene.frame->kind() == Profiles::SurfaceKind::plane)
      warn_of_slope(load);
    if (turn > large)
      context.log.warning(
        "The rail's normal turns by " + significant(turn / degree, 3) +
        " degrees over the contact, which is taken as plane. Forces are off "
        "by the sine and cosine of half this angle; Profiles/Contact surface "
        "= curved has a normal for each node.");
  }

  template <int dim>
  void StateReview<dim>::warn(const SteadyState<dim> &last) const
  {
    if (fewest < 5)
      context.log.warning("Only " + std::to_string(fewest) +
                          " nodes touch: the patch is unresolved, take more "
                          "elements (Mesh/Elements across patch).");
    warn_of_turning_normal(last);
    tell_rough_state(scene, last, context);
    warn_of_unknown_errors(context);
    if (n_unresolved > 0)
      context.log.warning(
        "At " + std::to_string(n_unresolved) + " of " +
        std::to_string(n_edges) +
        " leading edges `upwind 2` takes the place of the edge law, because "
        "the gap or the pressure changes from node to node: take more "
        "elements (Mesh/Elements across patch), at least 8 for a wave of "
        "Contact/Roughness.");
    for (const std::string &way : ways)
      context.log.warning(
        "Solved by \"" + way +
        "\", not by the active set alone: the laws of contact hold within the "
        "residual, but the force may have a larger error than is usual on "
        "this mesh" +
        (n_states > 1 ? " (column solver of results.csv)." : "."));
    warn_of_large_strains(
      strain_measures(scene, last.result, last.state.approach), context.log);
    warn_of_non_uniqueness(scene.dimension,
                           SolutionsOf::steady_states,
                           worst,
                           context.log);
  }

  template void
  note_hot_friction(const PairSpec &, const SteadyState<2> &, RunReport &);
  template void
  note_hot_friction(const PairSpec &, const SteadyState<3> &, RunReport &);
  template void note_state(const SteadyState<2> &, RunReport &);
  template void note_state(const SteadyState<3> &, RunReport &);
  template class StateReview<2>;
  template class StateReview<3>;
} // namespace RollingContact
