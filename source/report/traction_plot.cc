#include <rolling_contact/assessment/reference_2d.h>
#include <rolling_contact/assessment/uniqueness_warning.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/plot/svg_plot.h>
#include <rolling_contact/report/traction_plot.h>

#include <cmath>

namespace RollingContact
{
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



    Lines
    computed_lines(const SceneParameters &scene,
                   const SteadyState<2>  &steady,
                   const Reference2D     &reference)
    {
      const double p0                 = reference.hertz.max_pressure,
                   bound              = scene.contact.friction_coefficient * p0;
      const ContactProblem   &problem = steady.problem;
      const TangentialProblem tangential =
        tangential_problem(problem, steady.state);
      Lines lines;
      for (unsigned int i = 0; i < problem.n_nodes; ++i)
        {
          const double at =
            problem.positions[i][0] / reference.hertz.half_width;
          if (std::abs(at) > extent)
            continue;
          lines.x.push_back(at);
          lines.pressure.push_back(steady.state.pressure[i] / p0);
          if (problem.n_tangential == 0)
            continue;
          lines.traction.push_back(steady.state.traction[i] / bound);
          lines.bound.push_back(std::copysign(problem.friction_law
                                                ? tangential.bound[i] / bound
                                                : lines.pressure.back(),
                                              steady.result.force_x));
        }
      return lines;
    }



    /**
     * Hertz, and Carter where there is one.
     */
    Lines
    reference_lines(const SceneParameters &scene, const Reference2D &reference)
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
          lines.pressure.push_back(reference.hertz.pressure(at * a) / p0);
          if (reference.carter)
            lines.traction.push_back(reference.carter->traction(at * a) /
                                     bound);
        }
      return lines;
    }



    std::string
    title(const SceneParameters &scene, const SteadyState<2> &steady)
    {
      if (steady.problem.n_tangential == 0)
        return "Frictionless contact";
      const auto readable = [](const double value) {
        return (value < 0 ? "\u2212" : "") + significant(std::abs(value), 4);
      };
      return "T / (" + scale_of_friction(scene) + "N) = " +
             readable(steady.result.force_x / steady.result.friction_force) +
             " at creepage " + readable(steady.problem.creepages.x);
    }
  } // namespace



  void
  plot_line_tractions(const SceneParameters &scene,
                      const SteadyState<2>  &steady,
                      RunFolder             &folder)
  {
    const Reference2D reference = reference_2d(scene, steady);
    const Lines       found     = computed_lines(scene, steady, reference),
                exact           = reference_lines(scene, reference);
    SvgPlot plot(title(scene, steady),
                 "x / a, material flows " + std::string(scene.contact.flow() > 0
                                                          ? "to the right"
                                                          : "to the left"),
                 "p / p\u2080,   q / (" + scale_of_friction(scene) +
                   "p\u2080)");
    if (reference.carter)
      {
        const double a     = reference.hertz.half_width;
        const auto   stick = reference.carter->stick_interval();
        if (stick.second > stick.first)
          plot.add_band("stick (Carter)", stick.first / a, stick.second / a);
      }
    plot.add_curve("Hertz", exact.x, exact.pressure, CurveStyle::reference);
    if (reference.carter)
      plot.add_curve("Carter", exact.x, exact.traction, CurveStyle::reference);
    plot.add_curve("pressure p", found.x, found.pressure, CurveStyle::points);
    if (steady.problem.n_tangential > 0)
      {
        plot.add_curve("traction q on the wheel",
                       found.x,
                       found.traction,
                       CurveStyle::points);
        plot.add_curve("bound \u03bcp", found.x, found.bound, CurveStyle::line);
      }
    plot.write(folder, "tractions.svg");
  }
} // namespace RollingContact
