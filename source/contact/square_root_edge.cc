#include <rolling_contact/contact/square_root_edge.h>

#include <cmath>

namespace RollingContact
{
  namespace
  {
    const std::size_t n_fitted = 5; // nodes that a parabola is fitted to

    const unsigned int n_rounds = 8; // each reduces the change about 10 times

    /**
     * The parabola through the squares of five nodes by least squares, as a
     * function of the distance from node 0 in elements.
     */
    struct Parabola
    {
      double middle;                  // the third of the nodes
      double value, slope, curvature; // there: v + s t + c t^2

      /**
       * Through the nodes from @p first on.
       */
      Parabola(const std::vector<double> &squares, const std::size_t first)
        : middle(first + 2)
      {
        const double *y = &squares[first];
        value = (-3 * y[0] + 12 * y[1] + 17 * y[2] + 12 * y[3] - 3 * y[4]) / 35;
        slope = (-2 * y[0] - y[1] + y[3] + 2 * y[4]) / 10;
        curvature = (2 * y[0] - y[1] - 2 * y[2] - y[3] + 2 * y[4]) / 14;
      }

      /**
       * Where it falls to zero, from node 0 in elements.
       */
      double root() const
      {
        const double discriminant = slope * slope - 4 * curvature * value;
        return discriminant < 0.
                 ? std::nan("")
                 : middle - 2 * value / (slope + std::sqrt(discriminant));
      }

      double slope_at(const double place) const
      {
        return slope + 2 * curvature * (place - middle);
      }
    };
  } // namespace

  SquareRootEdge::SquareRootEdge(
    const std::array<Quadratic, n_disturbed> &deviations,
    const std::array<double, 2>              &distances)
    : deviations(deviations)
    , distances(distances)
  {}

  namespace
  {
    /**
     * Where xi may lie: a node farther outside carries no force, and one
     * farther inside has a neighbour that does.
     */
    const std::array<double, 2> of_elements{{-0.45, 0.8}},
      of_collocation{{-0.2, 0.95}};
  } // namespace

  SquareRootEdge SquareRootEdge::of_hats()
  {
    return SquareRootEdge({{{{1.0441, -0.7593, 0.0139}},
                            {{0.1277, -0.2436, 0.1298}},
                            {{0.1077, -0.0714, 0.0049}},
                            {{0.0725, -0.0659, 0.0177}},
                            {{0.0568, -0.0467, 0.0102}}}},
                          of_collocation);
  }

  SquareRootEdge SquareRootEdge::of_pressure(const NodalForces forces)
  {
    if (forces == NodalForces::hats)
      return of_hats();
    return SquareRootEdge({{{{0.6258, -0.5745, 0.0735}},
                            {{0.2575, -0.0275, -0.0749}},
                            {{0.1148, -0.0559, -0.0159}},
                            {{0.0829, -0.0202, -0.0204}},
                            {{0.0625, -0.0213, -0.0132}}}},
                          of_elements);
  }

  SquareRootEdge SquareRootEdge::of_stick_zone(const NodalForces forces)
  {
    if (forces == NodalForces::hats)
      return of_hats();
    return SquareRootEdge({{{{0.7666, -0.6095, 0.0503}},
                            {{0.1994, -0.1187, -0.0244}},
                            {{0.1143, -0.0497, -0.0237}},
                            {{0.0770, -0.0413, -0.0141}},
                            {{0.0592, -0.0271, -0.0139}}}},
                          of_elements);
  }

  double SquareRootEdge::deviation_of(const std::size_t k,
                                      const Ending     &ending) const
  {
    double value = 0.;
    for (const double coefficient : deviations[k])
      value = value * ending.distance + coefficient;
    return ending.growth * value;
  }

  std::optional<SquareRootEdge::Ending>
  SquareRootEdge::ending(const std::vector<double> &from_end,
                         const std::size_t          first) const
  {
    if (from_end.size() < first + n_fitted)
      return {};
    std::vector<double> square;
    for (const double f : from_end)
      square.push_back(f * f);

    Ending              found{};
    std::vector<double> exact(square);
    for (unsigned int round = 0; round < n_rounds; ++round)
      {
        const Parabola parabola(exact, first);
        found.distance = -parabola.root();
        found.growth   = parabola.slope_at(-found.distance);
        if (!(found.distance > distances[0] && found.distance < distances[1] &&
              found.growth > 0.))
          return {};
        for (std::size_t k = 0; k < n_disturbed; ++k)
          exact[k] = square[k] - deviation_of(k, found);
      }
    return found;
  }

  std::vector<SquareRootEdge::Deviation>
  SquareRootEdge::deviation(const std::vector<double> &from_end) const
  {
    std::vector<Deviation> found;
    if (const auto end = ending(from_end, 1))
      for (std::size_t k = 0; k < n_disturbed; ++k)
        found.push_back({deviation_of(k, *end), end->growth});
    return found;
  }

  std::optional<double>
  SquareRootEdge::distance(const std::vector<double> &from_end,
                           const std::size_t          first) const
  {
    const auto end = ending(from_end, first);
    return end ? std::optional<double>(end->distance) : std::nullopt;
  }
} // namespace RollingContact
