#include <rolling_contact/analyses/falling_friction_notes.h>
#include <rolling_contact/analyses/line_reference.h>
#include <rolling_contact/analyses/traction_plot.h>
#include <rolling_contact/output/svg_plot.h>

#include <cmath>

namespace RollingContact
{
  void
  plot_line_tractions(const SceneParameters &scene,
                      const SteadyState<2>  &steady,
                      RunFolder             &folder)
  {
    const LineReference reference = line_reference(scene, steady);
    const double        a         = reference.hertz.half_width,
                 p0               = reference.hertz.max_pressure,
                 bound            = scene.contact.friction_coefficient * p0;
    const bool     friction       = steady.problem.n_tangential > 0;
    const unsigned n_fine         = 1000;
    const double   extent         = 1.15;

    const TangentialProblem tangential =
      tangential_problem(steady.problem, steady.state);
    std::vector<double> x, pressure, traction, lower_bound;
    for (unsigned int i = 0; i < steady.problem.n_nodes; ++i)
      {
        const double at = steady.problem.positions[i][0] / a;
        if (std::abs(at) > extent)
          continue;
        x.push_back(at);
        pressure.push_back(steady.state.pressure[i] / p0);
        traction.push_back(friction ? steady.state.traction[i] / bound : 0.);
        lower_bound.push_back(std::copysign(steady.problem.friction_law
                                              ? tangential.bound[i] / bound
                                              : pressure.back(),
                                            steady.result.force_x));
      }
    std::vector<double> fine_x, hertz, carter;
    for (unsigned int k = 0; k <= n_fine; ++k)
      {
        fine_x.push_back(extent * (2. * k / n_fine - 1));
        hertz.push_back(reference.hertz.pressure(fine_x.back() * a) / p0);
        if (reference.carter)
          carter.push_back(reference.carter->traction(fine_x.back() * a) /
                           bound);
      }

    const auto readable = [](const double value) {
      return (value < 0 ? "\u2212" : "") + significant(std::abs(value), 4);
    };
    SvgPlot plot(friction ? "T / (" + scale_of_friction(scene) + "N) = " +
                              readable(steady.result.force_x /
                                       (scene.contact.friction_coefficient *
                                        steady.result.normal_force)) +
                              " at creepage " + readable(steady.creepage_x)
                          : "Frictionless contact",
                 "x / a, material flows " + std::string(scene.contact.flow() > 0
                                                          ? "to the right"
                                                          : "to the left"),
                 "p / p\u2080,   q / (" + scale_of_friction(scene) +
                   "p\u2080)");
    if (reference.carter)
      {
        const auto stick = reference.carter->stick_interval();
        if (stick.second > stick.first)
          plot.add_band("stick (Carter)", stick.first / a, stick.second / a);
      }
    plot.add_curve("Hertz", fine_x, hertz, CurveStyle::reference);
    if (reference.carter)
      plot.add_curve("Carter", fine_x, carter, CurveStyle::reference);
    plot.add_curve("pressure p", x, pressure, CurveStyle::points);
    if (friction)
      {
        plot.add_curve("traction q on the wheel",
                       x,
                       traction,
                       CurveStyle::points);
        plot.add_curve("bound \u03bcp", x, lower_bound, CurveStyle::line);
      }
    plot.write(folder, "tractions.svg");
  }
} // namespace RollingContact
