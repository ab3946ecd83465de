#include <rolling_contact/contact/square_root_edge.h>

#include <cmath>

namespace RollingContact
{
  namespace
  {
    /**
     * Nodes 1 to 5 are those that a parabola is fitted to; with a sixth there
     * is one that decides nothing.
     */
    const std::size_t least_nodes = 6;

    /**
     * Where xi may lie: a node farther outside carries no force, and one
     * farther inside has a neighbour that does.
     */
    const double smallest_distance = -0.45, largest_distance = 0.8;

    const unsigned int n_rounds = 8; // each reduces the change about 10 times

    /**
     * The parabola through the squares of nodes 1 to 5 by least squares, as a
     * function of the distance from node 0 in elements.
     */
    struct Parabola
    {
      double value, slope, curvature; // at node 3: v + s t + c t^2

      explicit Parabola(const std::vector<double> &y)
        : value((-3 * y[1] + 12 * y[2] + 17 * y[3] + 12 * y[4] - 3 * y[5]) / 35)
        , slope((-2 * y[1] - y[2] + y[4] + 2 * y[5]) / 10)
        , curvature((2 * y[1] - y[2] - 2 * y[3] - y[4] + 2 * y[5]) / 14)
      {}

      /**
       * Where it falls to zero, from node 0 in elements.
       */
      double root() const
      {
        const double discriminant = slope * slope - 4 * curvature * value;
        return discriminant < 0.
                 ? std::nan("")
                 : 3 - 2 * value / (slope + std::sqrt(discriminant));
      }

      double slope_at(const double place) const
      {
        return slope + 2 * curvature * (place - 3);
      }
    };
  } // namespace

  SquareRootEdge::SquareRootEdge(
    const std::array<Quadratic, n_disturbed> &deviations)
    : deviations(deviations)
  {}

  SquareRootEdge SquareRootEdge::of_pressure()
  {
    return SquareRootEdge({{{{0.6258, -0.5745, 0.0735}},
                            {{0.2575, -0.0275, -0.0749}},
                            {{0.1148, -0.0559, -0.0159}},
                            {{0.0829, -0.0202, -0.0204}},
                            {{0.0625, -0.0213, -0.0132}}}});
  }

  SquareRootEdge SquareRootEdge::of_stick_zone()
  {
    return SquareRootEdge({{{{0.7666, -0.6095, 0.0503}},
                            {{0.1994, -0.1187, -0.0244}},
                            {{0.1143, -0.0497, -0.0237}},
                            {{0.0770, -0.0413, -0.0141}},
                            {{0.0592, -0.0271, -0.0139}}}});
  }

  std::vector<SquareRootEdge::Deviation>
  SquareRootEdge::deviation(const std::vector<double> &from_end) const
  {
    if (from_end.size() < least_nodes)
      return {};
    std::vector<double> square;
    for (const double f : from_end)
      square.push_back(f * f);

    std::vector<Deviation> found(n_disturbed);
    std::vector<double>    exact(square);
    for (unsigned int round = 0; round < n_rounds; ++round)
      {
        const Parabola parabola(exact);
        const double   distance = -parabola.root();
        const double   growth   = parabola.slope_at(-distance);
        if (!(distance > smallest_distance && distance < largest_distance &&
              growth > 0.))
          return {};
        for (std::size_t k = 0; k < n_disturbed; ++k)
          {
            double value = 0.;
            for (const double coefficient : deviations[k])
              value = value * distance + coefficient;
            found[k] = {growth * value, growth};
            exact[k] = square[k] - found[k].of_square;
          }
      }
    return found;
  }
} // namespace RollingContact
