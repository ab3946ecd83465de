#include <rolling_contact/base/text.h>
#include <rolling_contact/results/lines_across.h>
#include <rolling_contact/results/profile_plot.h>
#include <rolling_contact/run/figure.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    const double plane_length = 0.03, normal_length = 0.015; // m, as drawn

    using Points = std::vector<std::array<double, 2>>;

    /** In mm. */
    void add_points(const std::string &label,
                    const Points      &points,
                    const CurveStyle   style,
                    Figure            &figure)
    {
      std::vector<double> across, upwards;
      for (const auto &point : points)
        {
          across.push_back(1e3 * point[0]);
          upwards.push_back(1e3 * point[1]);
        }
      figure.add_curve(label, across, upwards, style);
    }

    /**
     * The rail under a patch, from its first line of nodes to its last.
     */
    Points rail_under(const ContactPatch           &patch,
                      const SteadyState<3>         &steady,
                      const Profiles::ContactFrame &frame)
    {
      std::vector<double> y;
      for (const unsigned int node : patch.nodes)
        y.push_back(steady.problem.operators.positions()[node][1]);
      const auto [first, last]     = std::minmax_element(y.begin(), y.end());
      const double half_an_element = steady.grading.element_size_y / 2,
                   from            = *first - half_an_element,
                   to              = *last + half_an_element;
      Points             points;
      const unsigned int n = 40;
      for (unsigned int k = 0; k <= n; ++k)
        {
          const double at = from + (to - from) * k / n;
          if (const auto point = frame.rail_in_track(at))
            points.push_back(*point);
        }
      return points;
    }

    /**
     * From the surface of contact at @p s outwards.
     */
    Points normal_at(const double s, const Profiles::ContactFrame &frame)
    {
      const Profiles::SurfacePoint at = frame.surface(s);
      return {frame.point_in_track(at.y, at.z),
              frame.point_in_track(at.y + normal_length * std::sin(at.angle),
                                   at.z + normal_length * std::cos(at.angle))};
    }

    /**
     * "N = 60 + 20 kN".
     */
    std::string loads(const std::vector<ContactPatch> &patches)
    {
      std::string text;
      for (const ContactPatch &patch : patches)
        text += (text.empty() ? "N = " : " + ") +
                significant(1e-3 * patch.normal_force, 4);
      return text + " kN";
    }

    /** Angles of the surface of contact at each patch, in words. */
    std::string angles(const std::vector<ContactPatch> &patches,
                       const Profiles::ContactFrame    &frame)
    {
      const double degree = std::acos(-1.) / 180;
      std::string  text;
      for (const ContactPatch &patch : patches)
        {
          const double angle =
            frame.angle() + frame.surface(patch.centre_y).angle;
          text += (text.empty() ? "" : ", ") +
                  std::string(angle < 0. ? "\u2212" : "") +
                  significant(std::abs(angle) / degree, 3) + "\u00b0";
          if (frame.kind() == Profiles::SurfaceKind::plane)
            break;
        }
      return text;
    }

    Figure sections(const PairSpec &scene, const SteadyState<3> &steady)
    {
      const Profiles::ContactFrame   &frame   = *scene.frame;
      const std::vector<ContactPatch> patches = patches_of(steady);
      Figure figure(loads(patches) + " on " + std::to_string(patches.size()) +
                      (patches.size() == 1 ? " patch" : " patches") + " at " +
                      angles(patches, frame) + ", " +
                      (scene.profiles.is_left ? "left" : "right") + " side",
                    "y from the middle of the track, to the right (mm)",
                    "height (mm)");
      figure.set_equal_scales();
      add_points("rail", frame.rail_section(), CurveStyle::line, figure);
      add_points("wheel", frame.wheel_section(), CurveStyle::line, figure);
      for (std::size_t k = 0; k < patches.size(); ++k)
        add_points(patches.size() == 1 ? "patch"
                                       : "patch " + std::to_string(k + 1),
                   rail_under(patches[k], steady, frame),
                   CurveStyle::thick,
                   figure);
      if (frame.kind() == Profiles::SurfaceKind::plane)
        {
          add_points("plane of contact",
                     {frame.point_in_track(-plane_length, 0.),
                      frame.point_in_track(plane_length, 0.)},
                     CurveStyle::reference,
                     figure);
          add_points("its normal",
                     normal_at(0., frame),
                     CurveStyle::reference,
                     figure);
        }
      else
        for (std::size_t k = 0; k < patches.size(); ++k)
          add_points(patches.size() == 1 ? "its normal"
                                         : "normal of " + std::to_string(k + 1),
                     normal_at(patches[k].centre_y, frame),
                     CurveStyle::reference,
                     figure);
      add_points("first contact",
                 {frame.point_in_track(0., 0.)},
                 CurveStyle::points,
                 figure);
      return figure;
    }

    /**
     * The largest pressure of each line of nodes along x, and below it the heat
     * of friction where there is some.
     */
    void add_lines_of_nodes(const SteadyState<3> &steady,
                            const bool            is_plane,
                            Figure               &figure)
    {
      std::vector<double> y, pressure, heat;
      for (const LineAcross &line : lines_across(steady))
        {
          y.push_back(1e3 * line.y);
          pressure.push_back(1e-6 * line.max_pressure);
          heat.push_back(1e-3 * line.heat);
        }
      const auto add = [&](const std::string         &axis,
                           const std::string         &label,
                           const std::vector<double> &values) {
        Figure panel("",
                     is_plane ? "y in the plane of contact, to the right (mm)"
                              : "along the rail's section, to the right (mm)",
                     axis);
        panel.add_curve(label, y, values, CurveStyle::line_and_points);
        figure.add_separate_panel(panel);
      };
      add("max p (MPa)", "peak pressure along x", pressure);
      if (steady.problem.n_tangential() > 0)
        add("heat (kJ/m\u00b2)",
            "heat of friction, per metre rolled and metre across",
            heat);
    }
  } // namespace

  void plot_profiles(const PairSpec       &scene,
                     const SteadyState<3> &steady,
                     RunContext           &context,
                     const std::string    &name)
  {
    if (!scene.frame || !steady.solver.converged ||
        steady.result.n_touching == 0)
      return;
    Figure figure = sections(scene, steady);
    add_lines_of_nodes(steady,
                       scene.frame->kind() == Profiles::SurfaceKind::plane,
                       figure);
    figure.draw(context, name);
  }
} // namespace RollingContact
