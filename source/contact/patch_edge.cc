#include <rolling_contact/contact/patch_edge.h>
#include <rolling_contact/contact/square_root_edge.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  double patch_edge(const std::vector<double> &x,
                    const std::vector<double> &pressure)
  {
    if (x.size() < 2)
      return x.empty() ? 0. : x[0];
    const bool        resolved = x.size() >= 10;
    const std::size_t i        = resolved ? 2 : 0;
    const auto        square   = [&](const std::size_t k) {
      return pressure[k] * pressure[k];
    };
    const double slope = (square(i + 1) - square(i)) / (x[i + 1] - x[i]);
    const double next =
      resolved ? (square(i + 2) - square(i + 1)) / (x[i + 2] - x[i + 1])
               : slope;
    const double curvature = resolved ? (next - slope) / (x[i + 2] - x[i]) : 0.;
    const double tangent   = slope - curvature * (x[i + 1] - x[i]);
    const double discriminant = tangent * tangent - 4 * curvature * square(i);
    if (tangent == 0. || discriminant < 0.)
      return x[0];
    const double edge =
      x[i] - 2 * square(i) /
               (tangent + std::copysign(std::sqrt(discriminant), tangent));
    // the next node upstream is open: the edge cannot lie beyond it
    const double spacing = x[1] - x[0];
    const double beyond  = std::clamp((x[0] - edge) / spacing, 0., 1.);
    return x[0] - beyond * spacing;
  }

  double recovered_edge(const std::vector<double> &x,
                        const std::vector<double> &pressure,
                        const bool                 curved,
                        const NodalForces          forces)
  {
    const double        alike = 1e-3; // distances between nodes, relatively
    std::vector<double> from_end;
    for (std::size_t k = 0; k < x.size(); ++k)
      {
        if (k > 1 && std::abs(x[k] - x[k - 1] - (x[1] - x[0])) >
                       alike * std::abs(x[1] - x[0]))
          break;
        from_end.push_back(pressure[k]);
      }
    if (const auto distance =
          SquareRootEdge::of_pressure(forces).distance(from_end,
                                                       curved ? 2 : 1))
      return x[0] - *distance * (x[1] - x[0]);
    return patch_edge(x, pressure);
  }
} // namespace RollingContact
